#include "thigma/session/world_session.h"

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
  config.held = 1;
  config.coupling.linear_stiffness = 1000.0;
  config.coupling.linear_damping = 16.0;
  config.coupling.angular_stiffness = 2.0;
  config.coupling.angular_damping = 0.02;
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

TEST(WorldSession, PushesBlocksTheSameWayTwice) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  WorldSummary runs[2];
  double way = 0.0;
  for (WorldSummary& run : runs) {
    const auto device = push_device();
    run = run_world(config, device.get(),
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
  const std::uint64_t before = run_world(config, first.get()).state_hash;
  config.start.bodies[2].position.y() += 1e-12;
  EXPECT_NE(run_world(config, second.get()).state_hash, before);
}

TEST(WorldSession, RefusesDevicesThatHoldAPerson) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  PersonsDevice device;
  EXPECT_THROW(run_world(config, &device), std::invalid_argument);
}

TEST(WorldSession, RunsWithoutADevice) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  config.held = -1;
  config.duration = 1.5;
  const WorldSummary run = run_world(config, nullptr);
  EXPECT_EQ(run.frames, 1500u);
  EXPECT_LE(run.energy_end, run.energy_start);
  EXPECT_EQ(run.force_max, 0.0);
}

}  // namespace
}  // namespace thigma
