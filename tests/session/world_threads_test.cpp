// Worlds by the clock, their hands on a thread of their own: nothing here depends on how fast.

#include "thigma/session/world_threads.h"

#include <cmath>
#include <memory>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

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
