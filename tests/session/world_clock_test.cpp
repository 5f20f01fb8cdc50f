// Worlds by the clock: the shell of WorldRun that waits, with made-up ticks.

#include <atomic>
#include <functional>
#include <optional>
#include <string>
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
  std::uint64_t seen = 0, when_stopped = 0;
  int polls = 0;  // since the last frame
  shell.sink = [&](const WorldFrame& frame) {
    seen = frame.frame + 1;
    polls = 0;
  };
  shell.between = [&](WorldRun&) {
    if (++polls < 10 || stop) return;  // before a frame it is called once or twice
    when_stopped = seen;
    stop = true;
  };
  const WorldSummary run = run_world_by_clock(config, {&list, 1}, shell);
  EXPECT_EQ(when_stopped, 5u);
  EXPECT_EQ(run.frames, seen);
  EXPECT_LE(seen, 6u);  // the one that it was about to make
  EXPECT_TRUE(run.was_stopped);
}

/// A page's hand that closes its clutch at a time, and does something each time it is read.
class ClosingHand final : public HapticDevice {
 public:
  explicit ClosingHand(double closes) : closes_(closes) { limits_.holds_person = false; }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "closing"; }
  DeviceState read(double now) THIGMA_RT override {
    if (on_read) on_read(now);
    DeviceState state;
    state.time = now;
    state.buttons = now >= closes_ ? kClutchButton : 0;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}
  std::function<void(double)> on_read;

 private:
  const double closes_;
  DeviceLimits limits_;
};

/// Three blocks, 1 to 3, and a free hand that is aimed at none.
WorldSessionConfig blocks_for_a_moment(WorldBench& bench) {
  WorldSessionConfig config = test::three_blocks(bench);
  config.duration = 0.02;
  return config;
}

/// The body that a hand takes which was aimed while paused, where block 1 goes after that, and
/// after `late` if that is any.
std::int32_t taken_after_a_change(const WorldAim& aim, const std::optional<WorldAim>& late) {
  WorldBench bench;
  const WorldSessionConfig config = blocks_for_a_moment(bench);
  bench.bodies.erase(bench.bodies.begin() + 1);
  bench.make();
  WorldSessionConfig next = config;
  next.world = bench.world;
  next.start = bench.state;
  next.hands[0].couplings.pop_back();
  ClosingHand hand(0.01);
  HapticDevice* device = &hand;
  LivePorts ports;
  ports.is_paused = true;
  ports.aim.publish(aim);
  WorldShell shell{.live = &ports, .wait_for_tick = made_up_ticks({})};
  int polls = 0;
  shell.between = [&](WorldRun& run) {
    if (++polls == 2) {
      WorldState state = next.start;
      state.bodies = {run.state().bodies[0], run.state().bodies[2], run.state().bodies[3]};
      run.go_on(next, state, std::vector<std::int32_t>{0, 2, 3});
      if (late) ports.aim.publish(*late);
    }
    if (polls == 4) ports.is_paused = false;
  };
  std::int32_t taken = -1;
  shell.sink = [&](const WorldFrame& frame) { taken = frame.grips[0].body; };
  EXPECT_EQ(run_world_by_clock(config, {&device, 1}, shell).frames, 20u);
  return taken;
}

TEST(WorldClock, WhatAHandWasAimedAtKeepsToItsBodyWhereNumbersChange) {
  EXPECT_EQ(taken_after_a_change({2, Vec3::Zero(), 0}, std::nullopt), 1);   // block 2, now body 1
  EXPECT_EQ(taken_after_a_change({1, Vec3::Zero(), 0}, std::nullopt), -1);  // the one that goes
}

TEST(WorldClock, AnAimByNumbersOfAnotherWorldTakesNothing) {
  EXPECT_EQ(taken_after_a_change({2, Vec3::Zero(), 0}, WorldAim{1, Vec3::Zero(), 0}), -1);
  EXPECT_EQ(taken_after_a_change({2, Vec3::Zero(), 0}, WorldAim{2, Vec3::Zero(), 1}), 2);
}

TEST(WorldClock, AnAimThatComesBeforeTheClutchClosesIsThereWithIt) {
  WorldBench bench;
  const WorldSessionConfig config = blocks_for_a_moment(bench);
  ClosingHand hand(0.01);
  HapticDevice* device = &hand;
  LivePorts ports;
  ports.aim.publish({1, Vec3::Zero(), 0});  // of long ago
  hand.on_read = [&](double now) {
    // The last moment before the sample that closes the clutch.
    if (now == 0.01) ports.aim.publish({2, Vec3::Zero(), 0});
  };
  std::vector<std::int32_t> held;
  WorldShell shell{.live = &ports, .wait_for_tick = made_up_ticks({})};
  shell.sink = [&](const WorldFrame& frame) { held.push_back(frame.grips[0].body); };
  run_world_by_clock(config, {&device, 1}, shell);
  ASSERT_EQ(held.size(), 20u);
  EXPECT_EQ(held[9], -1);
  EXPECT_EQ(held[10], 2);
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
