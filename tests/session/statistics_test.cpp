#include "thigma/session/statistics.h"

#include <memory>

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(HapticStatistics, KeepsExtremesSumsAndTheHash) {
  const auto t = std::make_unique<HapticStatistics>();
  HapticSample a;
  a.command.force = {3.0, 4.0, 0.0};
  a.feedback.torque = {0.0, 0.0, 0.5};  // felt, though not sent
  a.penetration = 1e-4;
  a.stretch = 0.5;  // nobody holds it
  a.model_sequence = 1;
  a.model_age = 0.002;
  HapticSample b = a;
  b.command.force = {0.0, 0.0, 1.0};
  b.penetration = -1.0;
  b.is_grasped = true;
  b.stretch = 0.25;
  accumulate(*t, a, 1000, -1);
  accumulate(*t, b, 2000, 500);
  EXPECT_EQ(t->frames, 2u);
  EXPECT_EQ(t->force_max, 5.0);
  EXPECT_EQ(t->force_square_sum, 26.0);
  EXPECT_EQ(t->torque_max, 0.5);
  EXPECT_EQ(t->penetration_max, 1e-4);
  EXPECT_EQ(t->stretch_max, 0.25);
  EXPECT_EQ(t->step_cpu.total, 2u);
  EXPECT_EQ(t->wake_late.total, 1u);
  EXPECT_EQ(t->model_age.total, 2u);
  StateHash hash;
  add_frame(hash, a.body, a.command);
  add_frame(hash, b.body, b.command);
  EXPECT_EQ(t->hash.value, hash.value);
}

TEST(HapticStatistics, SplitsAFrameAndCountsWhatWasLate) {
  const auto t = std::make_unique<HapticStatistics>();
  accumulate(*t, StageTimes{.device_read = 2000, .device_write = 500, .whole = 10000});
  accumulate(
      *t, StageTimes{.device_read = 2000, .device_write = 500, .whole = 10000, .is_overrun = true});
  EXPECT_NEAR(quantile(t->compute, 0.5), 7.5e-6, 2e-7);
  EXPECT_EQ(t->whole.total, 2u);
  EXPECT_EQ(t->overruns, 1u);
  const HapticSample sample;
  for (const std::int64_t late : {-1, 50'000, 150'000, 250'000, 5'000'000})
    accumulate(*t, sample, 0, late);
  EXPECT_EQ(t->late[0], 3u);
  EXPECT_EQ(t->late[1], 2u);
  EXPECT_EQ(t->late[2], 1u);
  EXPECT_EQ(t->wake_late.total, 4u);
}

TEST(ContactStatistics, AddsUp) {
  const auto t = std::make_unique<ContactStatistics>();
  ContactSample s;
  s.contacts = 10;
  s.clusters = 3;
  s.front = 100;
  s.dropped = 1;
  s.query_cpu = 1e-3;
  s.step_cpu = 2e-3;
  accumulate(*t, s);
  accumulate(*t, s);
  EXPECT_EQ(t->updates, 2u);
  EXPECT_EQ(t->contacts, 20u);
  EXPECT_EQ(t->clusters, 6u);
  EXPECT_EQ(t->front, 200u);
  EXPECT_EQ(t->dropped, 2u);
  EXPECT_NEAR(quantile(t->query_cpu, 0.5), 1e-3, 2e-5);
  EXPECT_NEAR(quantile(t->step_cpu, 0.5), 2e-3, 4e-5);
  EXPECT_NEAR(quantile(t->model_cpu, 0.5), 1e-3, 2e-5);
}

}  // namespace
}  // namespace thigma
