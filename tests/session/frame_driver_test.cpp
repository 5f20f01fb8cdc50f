#include "thigma/session/detail/frame_driver.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace thigma {
namespace {

/// Frames of a list of ticks, without a device.
struct ListedFrames {
  std::vector<std::uint64_t> ticks;
  std::uint64_t stop_at = 1000, fault_from = 1000, finished_at = 1000;
  Fault fault = Fault::too_fast;
  std::vector<detail::Frame> frames{};
  std::vector<std::uint64_t> hung{};
  std::size_t next = 0;
  HapticSample made{};

  detail::FrameTick next_tick() { return {ticks.at(next++), 7}; }
  std::int64_t cpu_ns() const { return -1; }
  bool is_stopped() const { return ticks[next - 1] >= stop_at; }
  bool hang(const FaultEvent&, double) {
    hung.push_back(ticks[next - 1]);
    return true;
  }
  void prepare(const detail::Frame&) {}
  void step(const detail::Frame& frame) {
    made.time = frame.now;
    if (frame.index >= fault_from) made.fault = fault;
  }
  const HapticSample& sample(const detail::Frame&) const { return made; }
  void publish(const detail::Frame& frame, const HapticSample&) { frames.push_back(frame); }
  bool has_finished(const HapticSample&) const { return frames.back().index >= finished_at; }
};

SessionConfig config_of(double duration) {
  SessionConfig config;
  config.rate = 100.0;
  config.duration = duration;
  config.after_fault = 0.03;
  return config;
}

std::vector<std::uint64_t> ticks_to(std::uint64_t last) {
  std::vector<std::uint64_t> ticks;
  for (std::uint64_t i = 0; i <= last; ++i) ticks.push_back(i);
  return ticks;
}

SessionEnd drive(const SessionConfig& config, ListedFrames& shell,
                 detail::FrameRecord* kept = nullptr) {
  const auto record = std::make_unique<detail::FrameRecord>();
  const SessionEnd end = detail::drive_frames(config, shell, *record);
  if (kept != nullptr) *kept = *record;
  return end;
}

TEST(FrameDriver, ends_after_the_duration) {
  ListedFrames shell{ticks_to(9)};
  EXPECT_EQ(drive(config_of(0.05), shell), SessionEnd::duration);
  EXPECT_EQ(shell.frames.size(), 5u);
}

TEST(FrameDriver, ends_when_stopped_and_when_finished) {
  ListedFrames stopped{ticks_to(9), 3};
  EXPECT_EQ(drive(config_of(0.0), stopped), SessionEnd::stopped);
  EXPECT_EQ(stopped.frames.size(), 3u);
  ListedFrames finished{ticks_to(9)};
  finished.finished_at = 3;
  EXPECT_EQ(drive(config_of(0.0), finished), SessionEnd::device_finished);
  EXPECT_EQ(finished.frames.size(), 4u);
}

TEST(FrameDriver, keeps_zero_force_up_after_a_fault) {
  ListedFrames shell{ticks_to(20)};
  shell.fault_from = 4;
  EXPECT_EQ(drive(config_of(0.0), shell), SessionEnd::fault);
  EXPECT_EQ(shell.frames.back().index, 7u);  // 3 frames after it
}

TEST(FrameDriver, a_fault_counts_before_any_other_end) {
  ListedFrames shell{ticks_to(20)};
  shell.fault_from = 4;
  shell.stop_at = 6;
  EXPECT_EQ(drive(config_of(0.0), shell), SessionEnd::fault);
  EXPECT_EQ(shell.frames.back().index, 5u);
}

TEST(FrameDriver, a_fault_that_may_be_cleared_ends_nothing) {
  ListedFrames shell{ticks_to(20)};
  shell.fault_from = 4;
  shell.fault = Fault::device_lost;
  SessionConfig config = config_of(0.1);
  config.haptic.resumes_lost_device = true;
  EXPECT_EQ(drive(config, shell), SessionEnd::duration);
}

TEST(FrameDriver, late_steps_catch_up_but_for_at_most_ten_ticks) {
  ListedFrames shell{{0, 1, 4, 30, 31, 100}};
  detail::FrameRecord record;
  drive(config_of(1.0), shell, &record);
  ASSERT_EQ(shell.frames.size(), 5u);
  EXPECT_DOUBLE_EQ(shell.frames[0].elapsed, 0.01);
  EXPECT_DOUBLE_EQ(shell.frames[2].elapsed, 0.03);
  EXPECT_DOUBLE_EQ(shell.frames[3].elapsed, 0.10);
  EXPECT_DOUBLE_EQ(shell.frames[3].now, 0.30);
  EXPECT_EQ(record.longest_gap, 26u);
  EXPECT_EQ(record.statistics.frames, 5u);
}

TEST(FrameDriver, makes_no_step_while_it_hangs) {
  ListedFrames shell{ticks_to(9)};
  SessionConfig config = config_of(0.08);
  config.faults = {{InjectedFault::hang, 0.02, 0.03}};
  EXPECT_EQ(drive(config, shell), SessionEnd::duration);
  EXPECT_EQ(shell.hung, (std::vector<std::uint64_t>{2, 3, 4}));
  EXPECT_EQ(shell.frames.size(), 5u);
}

}  // namespace
}  // namespace thigma
