#include "viewer/server/timing_window.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thigma::live {
namespace {

TEST(TimingWindow, TellsQuantilesAndRatesOfTheLastSecond) {
  TimingWindow window;
  close(10.0, true, 5000, 100, window);
  std::vector<ChannelRow> rows(1000);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].values[10] = static_cast<float>(i) * 1e-6f;
    rows[i].values[11] = 2e-6f;
    rows[i].values[14] =
        static_cast<float>(kGrasped | (i % 4 == 0 ? kHeldBack : 0) | (i % 10 == 0 ? kSqueezed : 0));
  }
  const std::vector<double> queries = {3e-4, 1e-4, 2e-4};
  add(rows, queries, window);
  const Timing t = close(12.0, true, 7000, 500, window);
  EXPECT_NEAR(t.step_p50, 499e-6, 2e-6);
  EXPECT_NEAR(t.step_p99, 989e-6, 2e-6);
  EXPECT_NEAR(t.late_p99, 2e-6, 1e-12);
  EXPECT_EQ(t.query_p50, 2e-4);
  EXPECT_DOUBLE_EQ(t.held_back, 0.25);
  EXPECT_DOUBLE_EQ(t.squeezed, 0.1);
  EXPECT_EQ(close(13.0, true, 7000, 500, window).held_back, 0.0);
  EXPECT_DOUBLE_EQ(t.haptic_hz, 1000.0);
  EXPECT_DOUBLE_EQ(t.contact_hz, 200.0);
}

TEST(TimingWindow, WhatWasNotMeasuredIsUnknown) {
  TimingWindow window;
  const Timing first = close(1.0, true, 10, 10, window);
  EXPECT_TRUE(std::isnan(first.haptic_hz));
  EXPECT_TRUE(std::isnan(first.step_p50));
  EXPECT_TRUE(std::isnan(close(2.0, true, 3, 10, window).haptic_hz));     // another session
  EXPECT_TRUE(std::isnan(close(3.0, false, 900, 10, window).haptic_hz));  // paused since
  EXPECT_TRUE(std::isnan(close(4.0, true, 900, 10, window).haptic_hz));   // goes on
  EXPECT_DOUBLE_EQ(close(5.0, true, 1900, 20, window).haptic_hz, 1000.0);
}

}  // namespace
}  // namespace thigma::live
