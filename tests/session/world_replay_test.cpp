// Hands apart from their world, made again from what their steps had.

#include "thigma/session/world_replay.h"

#include <memory>
#include <string>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_threads.h"

namespace thigma {
namespace {

using namespace test;

/// A session on threads with two hands whose world is late now and then, and all that it takes to
/// make it again.
struct Recorded {
  WorldBench bench;
  WorldSessionConfig config;
  RecordedApart apart;
  std::vector<DeviceLimits> limits;
  WorldSummary summary;
  std::uint64_t steps = 0;

  Recorded() {
    config = with_two_hands(bench, false);
    config.duration = 0.2;
    BadDevice first(0.05, BadDevice::Trouble::none, 0.0),
        second(0.04, BadDevice::Trouble::none, 0.0);
    HapticDevice* devices[] = {&first, &second};
    for (const HapticDevice* device : devices) limits.push_back(device->limits());
    apart.ticks.resize(2);
    apart.seen.resize(2);
    WorldShell shell;
    shell.sink = [&](const WorldFrame& frame) {
      for (std::size_t i = 0; i < 2; ++i) apart.seen[i].push_back(frame.haptic.seen[i]);
      if (frame.frame % 20 == 10) sleep_ns(8'000'000);
    };
    shell.ticks = [&](std::span<const HandTick> ticks) {
      for (const HandTick& tick : ticks) {
        std::vector<HandTick>& list = apart.ticks[static_cast<std::size_t>(tick.hand)];
        EXPECT_EQ(tick.step, list.size());  // none is missing
        list.push_back(tick);
        ++steps;
      }
    };
    summary = run_world_on_threads(config, devices, shell);
    config.duration = static_cast<double>(summary.frames) / config.rate;
  }
};

TEST(WorldReplay, TwoHandsApartFromTheirWorldComeAgainBitForBit) {
  const Recorded was;
  ASSERT_FALSE(was.summary.has_fault()) << fault_name(was.summary.fault);
  EXPECT_GT(was.summary.late_frames, 0u);
  std::uint64_t steps = 0, forces = 0;
  ReplayWatch watch;
  watch.haptic = [&](const HandTick& now) {
    const HandTick& then = was.apart.ticks[static_cast<std::size_t>(now.hand)][now.step];
    ++steps;
    EXPECT_EQ(now.sent.force, then.sent.force);
    EXPECT_EQ(now.news, then.news);
    forces += now.sent.force.norm() > 0.0 ? 1 : 0;
  };
  const WorldSummary again = replay_world_apart(was.config, was.limits, was.apart, watch);
  EXPECT_EQ(again.frames, was.summary.frames);
  EXPECT_EQ(again.state_hash, was.summary.state_hash);
  EXPECT_EQ(steps, was.steps);
  EXPECT_GT(forces, 100u);
  ASSERT_EQ(again.haptic.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.haptic[i].steps, was.summary.haptic[i].steps);
    EXPECT_EQ(again.haptic[i].state_hash, was.summary.haptic[i].state_hash);
  }
}

TEST(WorldReplay, AnotherSampleOrOtherNewsAreAnotherSession) {
  const Recorded was;
  RecordedApart other = was.apart;
  other.ticks[1][100].device.motion.pose.position.x() += 1e-9;
  const WorldSummary moved = replay_world_apart(was.config, was.limits, other);
  EXPECT_NE(moved.haptic[1].state_hash, was.summary.haptic[1].state_hash);
  other = was.apart;
  // News that do not come for 60 ms: the force fades.
  for (std::vector<HandTick>& ticks : other.ticks)
    for (std::size_t step = 101; step < 160; ++step) ticks[step].news = ticks[100].news;
  const WorldSummary late = replay_world_apart(was.config, was.limits, other);
  EXPECT_NE(late.haptic[0].state_hash, was.summary.haptic[0].state_hash);
}

TEST(WorldReplay, WhatWasCutOffIsMadeAgainAsFarAsItGoes) {
  const Recorded was;
  RecordedApart other = was.apart;
  for (std::vector<HandTick>& ticks : other.ticks) ticks.resize(120);
  std::uint64_t steps = 0;
  ReplayWatch watch;
  watch.haptic = [&](const HandTick& now) {
    ++steps;
    EXPECT_EQ(now.sent.force,
              was.apart.ticks[static_cast<std::size_t>(now.hand)][now.step].sent.force);
  };
  const WorldSummary again = replay_world_apart(was.config, was.limits, other, watch);
  // Of a hand that was ahead of the other the last may have news of frames that had the other's.
  EXPECT_GE(steps, 120u);
  EXPECT_LE(steps, 240u);
  EXPECT_GT(again.frames, 20u);
  EXPECT_LE(again.frames, 120u);
}

TEST(WorldReplay, WhatCannotHaveBeenIsRefused) {
  const Recorded was;
  const auto refused = [&](const RecordedApart& other) {
    try {
      replay_world_apart(was.config, was.limits, other);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  RecordedApart other = was.apart;
  other.ticks[0][50].news = 100'000;  // of frames whose own samples are of steps after it
  EXPECT_NE(refused(other).find("which was not made before it"), std::string::npos);
  other = was.apart;
  other.ticks[0].back().news = 100'000;
  EXPECT_NE(refused(other).find(" has news of frame 100000, which the world did not make"),
            std::string::npos);
  other = was.apart;
  other.ticks[0][120].news = other.ticks[0][100].news;  // older than those of the step before
  EXPECT_NE(refused(other).find("where the world had told of frame"), std::string::npos);
  other = was.apart;
  other.seen[1][5].read = 1'000'000;
  EXPECT_NE(refused(other).find("hand 2: frame 5 of the world has haptic frame 1000000"),
            std::string::npos);
  other = was.apart;
  other.seen.pop_back();
  EXPECT_FALSE(refused(other).empty());
}

}  // namespace
}  // namespace thigma
