// Worlds by the clock: the shell of WorldRun that waits, with made-up ticks.

#include <atomic>
#include <functional>
#include <utility>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using namespace test;

/// Ticks without a clock: so many were over before the nth.
std::function<std::uint64_t()> made_up_ticks(std::vector<std::uint64_t> over) {
  return [over = std::move(over), next = std::size_t{0}]() mutable {
    return next < over.size() ? over[next++] : 0;
  };
}

TEST(WorldClock, HasTheBitsOfLockstepWhateverIsLate) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  const auto first = push_device(), second = push_device();
  const WorldSummary lockstep = run_one(config, first.get());
  HapticDevice* device = second.get();
  std::uint64_t lost = 0;
  WorldShell shell;
  shell.wait_for_tick = made_up_ticks({0, 0, 3, 0, 1});
  shell.sink = [&](const WorldFrame& frame) {
    lost += frame.lost;
    EXPECT_DOUBLE_EQ(frame.time, 1e-3 * static_cast<double>(frame.frame + 1));  // never a jump
  };
  const WorldSummary clock = run_world_by_clock(config, {&device, 1}, shell);
  EXPECT_EQ(clock.state_hash, lockstep.state_hash);
  EXPECT_EQ(clock.frames, lockstep.frames);
  EXPECT_EQ(clock.force_max, lockstep.force_max);
  EXPECT_EQ(clock.late_frames, 2u);
  EXPECT_NEAR(clock.lost_time, 4e-3, 1e-12);
  EXPECT_EQ(lost, 4u);
  EXPECT_EQ(lockstep.late_frames, 0u);
}

TEST(WorldClock, StandsStillWhilePausedAndGoesStepByStep) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  const auto device = push_device();
  HapticDevice* list = device.get();
  LivePorts ports;
  ports.is_paused = true;
  ports.steps = 5;
  std::atomic<bool> stop{false};
  WorldShell shell{.stop = &stop, .live = &ports, .wait_for_tick = made_up_ticks({})};
  std::uint64_t seen = 0;
  shell.sink = [&](const WorldFrame& frame) {
    seen = frame.frame + 1;
    if (seen == 5) stop = true;  // it would wait for ever
  };
  const WorldSummary run = run_world_by_clock(config, {&list, 1}, shell);
  EXPECT_EQ(seen, 5u);
  EXPECT_EQ(run.frames, 5u);
  EXPECT_TRUE(run.was_stopped);
}

TEST(WorldClock, AFaultEndsAtZeroForceOnAll) {
  WorldBench bench;
  const WorldSessionConfig config = with_two_hands(bench, false);
  BadDevice bad(0.05, BadDevice::Trouble::lost, 0.3), good(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&bad, &good};
  WorldShell shell;
  shell.wait_for_tick = made_up_ticks({});
  const WorldSummary run = run_world_by_clock(config, devices, shell);
  EXPECT_EQ(run.fault, Fault::device_lost);
  EXPECT_EQ(run.frames, 300u);
  for (const BadDevice* device : {&bad, &good}) {
    EXPECT_GT(device->most, 0.05);
    expect_let_go(*device);
  }
}

}  // namespace
}  // namespace thigma
