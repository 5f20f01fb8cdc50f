#include "thigma/session/world_session.h"

#include <cmath>
#include <stdexcept>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/device/script.h"

namespace thigma {
namespace {

using test::WorldBench;

WorldSessionConfig pushing(WorldBench& bench) {
  test::add_floor(bench, 1.0);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  bench.add(block, BodyKind::held, Vec3(-0.05, 0.0, 0.03));
  for (int i = 0; i < 2; ++i) bench.add(block, BodyKind::moving, Vec3(0.041 * i, 0.0, 0.02 + 3e-6));
  bench.make();
  WorldSessionConfig config;
  config.world = bench.world;
  config.start = bench.state;
  config.hands.resize(1);
  WorldHand& hand = config.hands[0];
  hand.body = 1;
  hand.coupling.linear_stiffness = 1000.0;
  hand.coupling.linear_damping = 16.0;
  hand.coupling.angular_stiffness = 2.0;
  hand.coupling.angular_damping = 0.02;
  config.duration = 0.5;
  return config;
}

/// A device with motors.
class PersonsDevice final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "motors"; }
  DeviceState read(double) THIGMA_RT override { return {}; }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  DeviceLimits limits_;
};

std::unique_ptr<HapticDevice> push_device() {
  DeviceLimits limits;
  limits.max_force = 100.0;
  std::vector<TimedPose> script(2);
  script[1].time = 0.5;
  script[1].pose.position.x() = 0.05;
  return make_script_device(script, limits);
}

WorldSummary run_one(const WorldSessionConfig& config, HapticDevice* device,
                     const std::function<void(const WorldFrame&)>& sink = {}) {
  return run_world(config, {&device, 1}, sink);
}

TEST(WorldSession, PushesBlocksTheSameWayTwice) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  WorldSummary runs[2];
  double way = 0.0;
  for (WorldSummary& run : runs) {
    const auto device = push_device();
    run = run_one(config, device.get(),
                  [&](const WorldFrame& frame) { way = frame.bodies[3].position.x() - 0.041; });
  }
  EXPECT_EQ(runs[0].frames, 500u);
  EXPECT_EQ(runs[0].state_hash, runs[1].state_hash);
  EXPECT_GT(way, 0.01);
  EXPECT_GT(runs[0].force_max, 0.3);
  EXPECT_EQ(runs[0].waited, 0.0);
  EXPECT_EQ(runs[0].not_whole, 0u);
  EXPECT_EQ(runs[0].largest_island, 3);
  EXPECT_GE(runs[0].port_energy_min, -1e-6);
}

TEST(WorldSession, OtherInputOtherHash) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  const auto first = push_device(), second = push_device();
  const std::uint64_t before = run_one(config, first.get()).state_hash;
  config.start.bodies[2].position.y() += 1e-12;
  EXPECT_NE(run_one(config, second.get()).state_hash, before);
}

TEST(WorldSession, RefusesDevicesThatHoldAPerson) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  PersonsDevice device;
  EXPECT_THROW(run_one(config, &device), std::invalid_argument);
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
    if (now < when_ || trouble_ == Trouble::none) return state;
    if (trouble_ == Trouble::lost) state.status = DeviceStatus::lost;
    if (trouble_ == Trouble::nan) state.motion.pose.position.y() = std::nan("");
    if (trouble_ == Trouble::jump) state.motion.pose.position.z() = 0.2;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    last = wrench;
    most = std::max(most, wrench.force.norm());
  }
  Wrench last;
  double most = 0.0;

 private:
  double speed_;
  Trouble trouble_;
  double when_;
  DeviceLimits limits_;
};

void expect_let_go(const BadDevice& device) {
  EXPECT_EQ(device.last.force.norm(), 0.0);
  EXPECT_EQ(device.last.torque.norm(), 0.0);
}

/// Two hands: both on the pusher, at its ends, or the second on a block.
WorldSessionConfig with_two_hands(WorldBench& bench, bool same_body) {
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

TEST(WorldSession, TwoHandsPushTheSameWayTwiceAndBearTheSame) {
  for (const bool same_body : {true, false}) {
    WorldBench bench;
    const WorldSessionConfig config = with_two_hands(bench, same_body);
    WorldSummary runs[2];
    for (WorldSummary& run : runs) {
      BadDevice left(0.05, BadDevice::Trouble::none, 0.0),
          right(0.05, BadDevice::Trouble::none, 0.0);
      HapticDevice* devices[] = {&left, &right};
      run = run_world(config, devices);
      EXPECT_EQ(left.last.force.norm(), 0.0);  // at the end
      EXPECT_EQ(right.last.force.norm(), 0.0);
    }
    EXPECT_EQ(runs[0].state_hash, runs[1].state_hash);
    EXPECT_FALSE(runs[0].has_fault());
    ASSERT_EQ(runs[0].hands.size(), 2u);
    for (const WorldHandSummary& hand : runs[0].hands) {
      EXPECT_GT(hand.force_max, 0.1);
      EXPECT_GE(hand.port_energy_min, -1e-3);
    }
    EXPECT_LE(runs[0].energy_made, 1e-5);  // a port's work is summed at the ends of steps
    if (same_body) {
      EXPECT_NEAR(runs[0].hands[0].force_max, runs[0].hands[1].force_max, 1e-3);
    }
  }
}

TEST(WorldSession, AFaultOfOneHandLeavesBothAtZeroForce) {
  const struct {
    BadDevice::Trouble trouble;
    Fault fault;
  } cases[] = {{BadDevice::Trouble::lost, Fault::device_lost},
               {BadDevice::Trouble::nan, Fault::not_finite},
               {BadDevice::Trouble::jump, Fault::pose_jump}};
  for (const auto& c : cases) {
    for (const bool is_left : {true, false}) {
      WorldBench bench;
      const WorldSessionConfig config = with_two_hands(bench, false);
      BadDevice bad(0.05, c.trouble, 0.3), good(0.05, BadDevice::Trouble::none, 0.0);
      HapticDevice* devices[] = {is_left ? &bad : &good, is_left ? &good : &bad};
      const WorldSummary run = run_world(config, devices);
      EXPECT_TRUE(run.has_fault());
      EXPECT_EQ(run.fault, c.fault) << fault_name(run.fault);
      EXPECT_EQ(run.frames, 300u);
      EXPECT_EQ(run.hands[is_left ? 0 : 1].fault, c.fault) << fault_name(c.fault);
      EXPECT_EQ(run.hands[is_left ? 1 : 0].fault, Fault::none);
      for (const BadDevice* device : {&bad, &good}) {
        EXPECT_GT(device->most, 0.05);
        expect_let_go(*device);
      }
    }
  }
}

TEST(WorldSession, AMotionThatIsNoNumberEndsAtZeroForceAndSaysSo) {
  WorldBench bench;
  WorldSessionConfig config = with_two_hands(bench, true);
  config.start.bodies[3].linear_momentum.x() = std::nan("");
  BadDevice left(0.05, BadDevice::Trouble::none, 0.0), right(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&left, &right};
  const WorldSummary run = run_world(config, devices);
  EXPECT_TRUE(run.has_fault());
  EXPECT_EQ(run.fault, Fault::not_finite);
  EXPECT_EQ(run.frames, 0u);
  EXPECT_EQ(left.most, 0.0);
  EXPECT_EQ(right.most, 0.0);
}

TEST(WorldSession, ARecordingThatFailsLeavesAllHandsAtZeroForce) {
  WorldBench bench;
  const WorldSessionConfig config = with_two_hands(bench, true);
  BadDevice left(0.05, BadDevice::Trouble::none, 0.0), right(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&left, &right};
  const auto full_disk = [](const WorldFrame& frame) {
    if (frame.frame == 350) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(run_world(config, devices, full_disk), std::runtime_error);
  for (const BadDevice* device : {&left, &right}) {
    EXPECT_GT(device->most, 0.05);
    expect_let_go(*device);
  }
}

TEST(WorldSession, EachHandHasItsLimits) {
  WorldBench bench;
  WorldSessionConfig config = with_two_hands(bench, true);
  config.hands[1].limits.max_force = 0.05;
  BadDevice left(0.05, BadDevice::Trouble::none, 0.0), right(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&left, &right};
  run_world(config, devices);
  EXPECT_GT(left.most, 0.1);
  EXPECT_LE(right.most, 0.05 * (1.0 + 1e-15));
  EXPECT_THROW(run_world(config, {devices, 1}), std::invalid_argument);
}

TEST(WorldSession, RunsWithoutADevice) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  config.hands.clear();
  config.duration = 1.5;
  const WorldSummary run = run_world(config, {});
  EXPECT_EQ(run.frames, 1500u);
  EXPECT_LE(run.energy_end, run.energy_start);
  EXPECT_EQ(run.force_max, 0.0);
}

}  // namespace
}  // namespace thigma
