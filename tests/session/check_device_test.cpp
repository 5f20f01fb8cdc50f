#include "thigma/session/check_device.h"

#include <cmath>

#include "support/plane_session.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::plane_hand;

TEST(CheckDevice, a_simulated_hand_keeps_every_rule_but_those_of_time) {
  HandDevice hand(plane_hand(HandPath::press, 0.005));
  const DeviceReport report = check_device(hand, {.seconds = 0.6});
  EXPECT_GT(report.frames, 100u);
  for (const DeviceRule& rule : report.rules) {
    const bool is_of_time = std::string(rule.rule).find("frames are made") != std::string::npos ||
                            std::string(rule.rule).find("period") != std::string::npos;
    EXPECT_TRUE(rule.holds || is_of_time) << rule.rule << ": " << rule.found;
  }
}

TEST(CheckDevice, finds_a_device_that_gives_nonsense) {
  struct Bad final : HapticDevice {
    DeviceLimits own;
    int reads = 0;
    const DeviceLimits& limits() const override { return own; }
    std::string name() const override { return "bad"; }
    DeviceState read(double now) THIGMA_RT override {
      DeviceState state;
      state.time = now;
      if (++reads % 2 == 0) state.motion.pose.position.x() = std::nan("");
      state.motion.pose.orientation = Quat(2.0, 0.0, 0.0, 0.0);
      return state;
    }
    void write(const Wrench&) THIGMA_RT override {}
  } bad;
  const DeviceReport report = check_device(bad, {.seconds = 0.1});
  EXPECT_FALSE(report.is_conforming());
  int failed = 0;
  for (const DeviceRule& rule : report.rules) failed += rule.holds ? 0 : 1;
  EXPECT_GE(failed, 2);
}

}  // namespace
}  // namespace thigma
