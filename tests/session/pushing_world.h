#pragma once
// A world in which a hand pushes blocks, and devices for it that behave well or badly.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/device/script.h"
#include "thigma/session/world_session.h"

namespace thigma::test {

/// The world of a bench that is made, with one hand, which holds nothing yet.
inline WorldSessionConfig one_handed(const WorldBench& bench) {
  WorldSessionConfig config;
  config.world = bench.world;
  config.start = bench.state;
  config.hands.resize(1);
  WorldHand& hand = config.hands[0];
  hand.coupling.linear_stiffness = 1000.0;
  hand.coupling.linear_damping = 16.0;
  hand.coupling.angular_stiffness = 2.0;
  hand.coupling.angular_damping = 0.02;
  return config;
}

/// The same, with a hand that takes hold of what it is aimed at.
inline WorldSessionConfig free_handed(const WorldBench& bench) {
  WorldSessionConfig config = one_handed(bench);
  WorldHand& hand = config.hands[0];
  hand.is_free = true;
  hand.couplings.assign(bench.bodies.size(), hand.coupling);
  return config;
}

/// Three blocks, 1 to 3, and a free hand that is aimed at none.
inline WorldSessionConfig three_blocks(WorldBench& bench) {
  add_floor(bench, 1.0);
  const auto block = body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  for (int i = 0; i < 3; ++i) bench.add(block, BodyKind::moving, Vec3(0.1 * i, 0.0, 0.02 + 3e-6));
  bench.make();
  return free_handed(bench);
}

/// A block in the hand behind two others on a floor.
inline WorldSessionConfig pushing(WorldBench& bench) {
  add_floor(bench, 1.0);
  const auto block = body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  bench.add(block, BodyKind::held, Vec3(-0.05, 0.0, 0.03));
  for (int i = 0; i < 2; ++i) bench.add(block, BodyKind::moving, Vec3(0.041 * i, 0.0, 0.02 + 3e-6));
  bench.make();
  WorldSessionConfig config = one_handed(bench);
  config.hands[0].body = 1;
  config.duration = 0.5;
  return config;
}

inline std::unique_ptr<HapticDevice> push_device() {
  DeviceLimits limits;
  limits.max_force = 100.0;
  std::vector<TimedPose> script(2);
  script[1].time = 0.5;
  script[1].pose.position.x() = 0.05;
  return make_script_device(script, limits);
}

inline WorldSummary run_one(const WorldSessionConfig& config, HapticDevice* device,
                            const std::function<void(const WorldFrame&)>& sink = {}) {
  return run_world(config, {&device, 1}, sink);
}

/// Moves along x at a speed, is lost or jumps at a time; remembers what it was last sent.
class BadDevice final : public HapticDevice {
 public:
  enum class Trouble { none, lost, nan, jump };
  BadDevice(double speed, Trouble trouble, double when)
      : speed_(speed), trouble_(trouble), when_(when) {
    limits_.holds_person = false;
    limits_.max_force = 100.0;
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "bad"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    state.status = DeviceStatus::ok;
    state.motion.pose.position.x() = speed_ * now;
    state.motion.twist.linear.x() = speed_;
    if ((now < when_ && !must_fail) || trouble_ == Trouble::none) return state;
    has_failed = true;
    if (trouble_ == Trouble::lost) state.status = DeviceStatus::lost;
    if (trouble_ == Trouble::nan) state.motion.pose.position.y() = std::nan("");
    if (trouble_ == Trouble::jump) state.motion.pose.position.z() = 0.2;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    last = wrench;
    most = std::max(most, wrench.force.norm());
    is_let_go = !(wrench.force.norm() > 0.0) && !(wrench.torque.norm() > 0.0);
  }
  Wrench last;
  double most = 0.0;
  // For other threads: that its trouble begins, has begun, and what was sent last.
  std::atomic<bool> must_fail{false}, has_failed{false}, is_let_go{false};

 private:
  double speed_;
  Trouble trouble_;
  double when_;
  DeviceLimits limits_;
};

inline void expect_let_go(const BadDevice& device) {
  EXPECT_EQ(device.last.force.norm(), 0.0);
  EXPECT_EQ(device.last.torque.norm(), 0.0);
}

/// Two hands: both on the pusher, at its ends, or the second on a block.
inline WorldSessionConfig with_two_hands(WorldBench& bench, bool same_body) {
  WorldSessionConfig config = pushing(bench);
  config.hands.push_back(config.hands[0]);
  config.hands[0].at = Vec3(-0.05, -0.02, 0.03);
  config.hands[1].at = Vec3(-0.05, 0.02, 0.03);
  if (same_body) return config;
  bench.bodies[3].kind = BodyKind::held;
  bench.make();
  config.world = bench.world;
  config.start = bench.state;
  config.hands[1].body = 3;
  config.hands[1].at.reset();
  return config;
}

}  // namespace thigma::test
