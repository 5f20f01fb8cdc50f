// Worlds by the clock, their hands on a thread of their own: nothing here depends on how fast.

#include "thigma/session/world_threads.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

#include "thigma/session/detail/hand_thread.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_apart.h"

namespace thigma {
namespace {

using namespace test;

/// Says what was recorded, then that it has finished.
class RecordedDevice final : public HapticDevice {
 public:
  explicit RecordedDevice(std::vector<DeviceState> samples) : samples_(std::move(samples)) {
    limits_.holds_person = false;
    limits_.max_force = 100.0;
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "recorded"; }
  DeviceState read(double) THIGMA_RT override {
    if (next_ < samples_.size()) return samples_[next_++];
    DeviceState state;
    state.status = DeviceStatus::finished;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  std::vector<DeviceState> samples_;
  std::size_t next_ = 0;
  DeviceLimits limits_;
};

TEST(WorldThreads, AWorldThatIsLateHoldsUpNoHandAndReplaysBitForBit) {
  for (const bool is_late : {false, true}) {
    WorldBench bench;
    WorldSessionConfig config = pushing(bench);
    config.duration = 0.2;
    BadDevice device(0.05, BadDevice::Trouble::none, 0.0);
    HapticDevice* list = &device;
    std::vector<DeviceState> samples;
    WorldShell shell;
    shell.sink = [&](const WorldFrame& frame) {
      samples.push_back(frame.grips[0].device);
      if (is_late && frame.frame % 20 == 10) sleep_ns(8'000'000);
    };
    const WorldSummary run = run_world_on_threads(config, {&list, 1}, shell);
    EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
    EXPECT_EQ(run.frames, 200u);
    ASSERT_EQ(run.haptic.size(), 1u);
    EXPECT_GE(run.haptic[0].steps + 1, run.frames);
    if (is_late) {
      EXPECT_GT(run.haptic[0].steps, run.frames);
      EXPECT_GT(run.late_frames, 0u);
    }
    EXPECT_EQ(run.haptic_cpu.total, run.haptic[0].steps);
    expect_let_go(device);
    RecordedDevice again(samples);
    const WorldSummary replay = run_one(config, &again);
    EXPECT_EQ(replay.state_hash, run.state_hash) << is_late;
    EXPECT_EQ(replay.frames, run.frames);
  }
}

TEST(WorldThreads, AFaultEndsAtZeroForceOnAll) {
  WorldBench bench;
  const WorldSessionConfig config = with_two_hands(bench, false);
  BadDevice bad(0.05, BadDevice::Trouble::lost, 0.1), good(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&bad, &good};
  const WorldSummary run = run_world_on_threads(config, devices, {});
  EXPECT_EQ(run.fault, Fault::device_lost);
  EXPECT_EQ(run.hands[0].fault, Fault::device_lost);
  for (const BadDevice* device : {&bad, &good}) expect_let_go(*device);
}

TEST(WorldThreads, AFaultWhileAStepOfTheWorldTakesLongEndsAtZeroForceAtOnce) {
  WorldBench bench;
  const WorldSessionConfig config = with_two_hands(bench, false);
  BadDevice bad(0.05, BadDevice::Trouble::lost, 1e9);
  BadDevice good(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&bad, &good};
  bool is_let_go = false;
  WorldShell shell;
  shell.sink = [&](const WorldFrame& frame) {
    if (frame.frame != 80) return;
    bad.must_fail = true;
    // It is as if this step took until both hands are let go; a minute, should they never be.
    for (int i = 0; i < 60'000 && !is_let_go; ++i) {
      sleep_ns(1'000'000);
      is_let_go = bad.has_failed && bad.is_let_go && good.is_let_go;
    }
  };
  const WorldSummary run = run_world_on_threads(config, devices, shell);
  EXPECT_EQ(run.fault, Fault::device_lost);
  EXPECT_TRUE(is_let_go);
  EXPECT_GT(good.most, 0.0);
}

TEST(WorldThreads, AnErrorOfTheWorldsSinkEndsAtZeroForce) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  BadDevice device(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* list = &device;
  WorldShell shell;
  shell.sink = [](const WorldFrame& frame) {
    if (frame.frame == 30) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(run_world_on_threads(config, {&list, 1}, shell), std::runtime_error);
  expect_let_go(device);
}

/// A page's hand whose clutch is closed from the second read on and whose handle lifts.
class PageHand final : public HapticDevice {
 public:
  PageHand() { limits_.holds_person = false; }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "page"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    state.buttons = reads.load() > 0 ? kClutchButton : 0;
    state.motion.pose.position.z() = 1e-3 * std::min(now, 1.0);
    if (is_lost) state.status = DeviceStatus::lost;
    ++reads;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    force = wrench.force.norm();
    most = std::max(most, wrench.force.norm());
  }
  std::atomic<std::uint64_t> reads{0};
  std::atomic<double> force{0.0};  // sent last
  std::atomic<bool> is_lost{false};
  double most = 0.0;

 private:
  DeviceLimits limits_;
};

/// A block on a floor, and a free hand; without ramps.
WorldSessionConfig one_block(WorldBench& bench) {
  add_floor(bench, 1.0);
  bench.add(body_mesh(make_box(Vec3(0.04, 0.04, 0.04))), BodyKind::moving,
            Vec3(0.0, 0.0, 0.02 + 3e-6));
  bench.make();
  WorldSessionConfig config = free_handed(bench);
  config.duration = 0.2;
  config.hands[0].limits.start_ramp = config.hands[0].limits.clear_before_arming = 0.0;
  return config;
}

/// The same, apart from its world.
struct BlockApart {
  WorldBench bench;
  WorldSessionConfig config = one_block(bench);
  PageHand hand;
  HapticDevice* device = &hand;
  WorldApart apart{config, {&device, 1}};
  detail::HandsShared shared;
  std::vector<std::unique_ptr<detail::HandThread>> hands = one_thread();

  /// Whose watchdog sees no gap.
  std::vector<std::unique_ptr<detail::HandThread>> one_thread() {
    SafetyLimits limits;
    limits.watchdog = 1e9;
    std::vector<std::unique_ptr<detail::HandThread>> list;
    list.push_back(std::make_unique<detail::HandThread>(0, limits, apart, shared));
    return list;
  }
  /// Runs the hand's thread until it has made some steps.
  void run_hands();
};

/// Waits until it is so; a minute, should it never be. Whether it is.
template <class Condition>
bool comes(Condition condition) {
  for (int i = 0; i < 60'000 && !condition(); ++i) sleep_ns(1'000'000);
  return condition();
}

void BlockApart::run_hands() {
  std::thread thread([this] { detail::run_hand({0, -1}, *hands[0]); });
  EXPECT_TRUE(comes([this] { return hands[0]->ticks > 3; }));
  shared.should_stop = true;
  thread.join();
}

TEST(WorldThreads, APagesHandIsAnsweredWhileAStepOfTheWorldTakesLong) {
  WorldBench bench;
  const WorldSessionConfig config = one_block(bench);
  PageHand hand;
  HapticDevice* device = &hand;
  LivePorts ports;
  ports.aim.publish({1, Vec3(0.01, 0.0, 0.0), 0});
  WorldShell shell{.live = &ports};
  std::vector<std::int32_t> held;
  bool is_answered = false, is_let_go = false;
  shell.sink = [&](const WorldFrame& frame) {
    held.push_back(frame.grips[0].body);
    if (frame.frame == 100) {
      // It is as if this step took until the hand has been answered a hundred times.
      const std::uint64_t before = hand.reads;
      is_answered = hand.force > 0.0 && comes([&] { return hand.reads > before + 100; });
    }
    if (frame.frame == 150) {
      // And this one until its page is lost: nothing is felt, nothing ends.
      hand.is_lost = true;
      is_let_go = comes([&] { return hand.force == 0.0; });
    }
    if (frame.frame == 170) hand.is_lost = false;  // another page is no fault
  };
  const WorldSummary run = run_world_on_threads(config, {&device, 1}, shell);
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_TRUE(is_answered);
  EXPECT_TRUE(is_let_go);
  ASSERT_EQ(held.size(), 200u);
  EXPECT_EQ(held[100], 1);
  EXPECT_EQ(held.back(), -1);
  EXPECT_GT(run.late_frames, 0u);
  EXPECT_GE(run.haptic[0].steps, run.frames + 100);
}

TEST(WorldThreads, StandStillWhilePausedAndGoStepByStep) {
  WorldBench bench;
  const WorldSessionConfig config = one_block(bench);
  PageHand hand;
  HapticDevice* device = &hand;
  LivePorts ports;
  ports.is_paused = true;
  std::atomic<bool> stop{false};
  WorldShell shell{.stop = &stop, .live = &ports};
  std::uint64_t frames = 0, reads = 0;
  int polls = 0;
  shell.sink = [&](const WorldFrame& frame) {
    frames = frame.frame + 1;
    EXPECT_EQ(frame.lost, 0u);
    EXPECT_EQ(frame.haptic.sent.size(), 1u);
  };
  shell.between = [&](WorldRun&) {
    ++polls;
    if (polls == 20) ports.steps = 5;
    // While it stands still it is called again and again, a thousand times a second at most.
    if (polls == 300) {
      reads = hand.reads;
      EXPECT_EQ(frames, 5u);
    }
    if (polls != 400) return;
    EXPECT_EQ(hand.reads, reads);
    stop = true;
  };
  const WorldSummary run = run_world_on_threads(config, {&device, 1}, shell);
  EXPECT_EQ(run.frames, 5u);
  EXPECT_EQ(run.haptic[0].steps, 5u);
  EXPECT_TRUE(run.was_stopped);
}

TEST(WorldThreads, TheWatchdogLetsGoOfEachDeviceWhoseThreadHangs) {
  WorldBench bench;
  const WorldSessionConfig config = with_two_hands(bench, false);
  BadDevice first(0.05, BadDevice::Trouble::none, 0.0), second(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&first, &second};
  WorldApart apart(config, devices);
  Wrench pull;
  pull.force.x() = 3.0;
  for (BadDevice* device : {&first, &second}) device->write(pull);
  detail::HandsShared shared;
  std::vector<std::unique_ptr<detail::HandThread>> hands;
  for (std::size_t i = 0; i < 2; ++i) {
    hands.push_back(std::make_unique<detail::HandThread>(i, SafetyLimits{}, apart, shared));
    hands[i]->last_step_ns = monotonic_ns();  // and never again
  }
  ASSERT_TRUE(hands[0]->token.try_take());
  std::thread watchdog([&] { detail::watch_hands(hands, {0, -1}, shared); });
  // A step that hangs in a device keeps it, and the other is let go.
  EXPECT_TRUE(comes([&] { return second.is_let_go && hands[1]->stops > 0; }));
  sleep_ns(60'000'000);
  EXPECT_FALSE(first.is_let_go);
  EXPECT_EQ(hands[0]->stops, 0u);
  EXPECT_TRUE(hands[0]->was_stopped);
  hands[0]->token.give_back();
  EXPECT_TRUE(comes([&] { return first.is_let_go && hands[0]->stops > 0; }));
  sleep_ns(60'000'000);
  for (const auto& hand : hands) {
    EXPECT_EQ(hand->stops, 1u);  // once a hang
    EXPECT_TRUE(hand->was_stopped);
  }
  EXPECT_EQ(shared.fault, Fault::none);  // nobody is held
  shared.should_stop = true;
  watchdog.join();
}

TEST(WorldThreads, AfterTheWatchdogHasActedForcesComeBackOverTheRamp) {
  BlockApart block;
  block.apart.ticks.push_back(std::make_unique<SpscRing<HandTick>>(1 << 16));
  block.hands[0]->was_stopped = true;
  block.run_hands();
  EXPECT_FALSE(block.hands[0]->was_stopped);
  // The first step was told of it, from which the ramp begins (haptic_step), and no other.
  for (int step = 0; step < 4; ++step) {
    const HandTick* tick = block.apart.ticks[0]->front();
    if (step > 0 && tick == nullptr) break;  // ticks that were missed are counted as well
    ASSERT_NE(tick, nullptr);
    EXPECT_EQ(tick->tick.external_fault, step == 0 ? Fault::watchdog : Fault::none) << step;
    block.apart.ticks[0]->pop();
  }
  EXPECT_EQ(block.apart.loops[0]->state.safety.fault, Fault::none);
  EXPECT_EQ(block.hands[0]->last_step_ns, 0);
}

TEST(WorldThreads, ASingleStepIsNotOwedToTheNextPause) {
  BlockApart block;
  block.shared.singles = 3;  // asked for as the pause ended
  block.run_hands();
  EXPECT_EQ(block.hands[0]->singles, 3u);
}

TEST(WorldThreads, AWatchdogThatIsOffLooksForTheEndAllTheSame) {
  BlockApart block;
  block.hands[0]->last_step_ns = monotonic_ns();
  std::thread watchdog([&] { detail::watch_hands(block.hands, {0, -1}, block.shared); });
  sleep_ns(50'000'000);
  EXPECT_EQ(block.hands[0]->stops, 0u);
  block.shared.should_stop = true;
  watchdog.join();
}

TEST(WorldThreads, NewsOfOneHandHaveRoomForTheWorldThatItGoesOnWith) {
  BlockApart block;
  const auto told = [&] {
    const WorldFrame* frame = block.apart.run->make_frame();
    publish_news(*frame, 1e-3, 0, block.apart);
    return block.apart.scratch[0].get();
  };
  const auto* before = told();
  EXPECT_EQ(told(), before);
  const std::vector<std::int32_t> was{0, 1};
  block.apart.run->go_on(block.config, WorldState(block.apart.run->state()), was);
  const auto* after = told();
  EXPECT_NE(after, before);
  EXPECT_EQ(told(), after);
}

TEST(WorldThreads, ALateWorldHasRoomForSixteenSecondsOfHapticSteps) {
  EXPECT_EQ(detail::tick_room(100.0), 16384u);
  EXPECT_EQ(detail::tick_room(4000.0), 64'000u);
}

TEST(WorldThreads, HapticStepsThatAreLeftOutAtTheEndAreCounted) {
  for (const std::size_t room : {std::size_t{16}, std::size_t{0}}) {
    WorldBench bench;
    WorldSessionConfig config = pushing(bench);
    BadDevice device(0.05, BadDevice::Trouble::none, 0.0);
    HapticDevice* list = &device;
    std::atomic<bool> stop{false};
    std::uint64_t told = 0;
    WorldShell shell;
    shell.stop = &stop;
    shell.tick_room = room;
    shell.ticks = [&](std::span<const HandTick> ticks) { told += ticks.size(); };
    shell.sink = [&](const WorldFrame& frame) {
      if (frame.frame < 3) return;
      sleep_ns(100'000'000);
      stop = true;
    };
    const WorldSummary run = run_world_on_threads(config, {&list, 1}, shell);
    ASSERT_EQ(run.haptic.size(), 1u);
    EXPECT_EQ(told + run.haptic_dropped, run.haptic[0].steps);
    EXPECT_EQ(run.haptic_dropped > 0, room > 0) << run.haptic_dropped;
  }
}

TEST(WorldThreads, AWorldThatNobodyHoldsGoesAsBefore) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  config.hands.clear();
  config.duration = 0.05;
  const WorldSummary run = run_world_on_threads(config, {}, {});
  EXPECT_EQ(run.state_hash, run_world(config, {}).state_hash);
  EXPECT_TRUE(run.haptic.empty());
}

}  // namespace
}  // namespace thigma
