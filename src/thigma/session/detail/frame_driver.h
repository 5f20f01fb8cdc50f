#pragma once
// The loop of a session's frames: what a frame is, and when a session ends. Threads, lockstep and
// simulation are shells around it: each brings a clock, a step and a place for results.

#include <concepts>
#include <cstdint>
#include <optional>

#include "thigma/loop/haptic_step.h"
#include "thigma/session/session.h"
#include "thigma/session/statistics.h"

namespace thigma::detail {

/// Ticks of a clock that one step makes up for, at most: a longer step would be another motion.
inline constexpr std::uint64_t kMostTicks = 10;

/// A frame the clock of a shell has come to.
struct FrameTick {
  std::uint64_t index = 0;         // it happens at index / rate
  std::int64_t wake_late_ns = -1;  // below 0: not measured
};

/// A frame as it is made.
struct Frame {
  std::uint64_t index = 0;
  double now = 0.0;      // [s; session clock]
  double elapsed = 0.0;  // length of its step [s]
  std::int64_t wake_late_ns = -1;
  std::int64_t cpu_ns = -1;  // of the step; known after it
};

/// What the frames of a session add up to. Thread: one writer; read after it has stopped.
struct FrameRecord {
  HapticStatistics statistics;
  double time = 0.0;              // of the last tick [s; session clock]
  std::uint64_t previous = 0;     // index of the last frame
  std::uint64_t longest_gap = 0;  // between two frames [frames]
  Fault fault = Fault::none;      // latched in the last frame
  bool has_fault_frame = false;
  std::uint64_t fault_frame = 0;  // first one with a fault that ends the session
};

/// What a session has of its own. Members are called in this order, once a frame.
template <class S>
concept FrameShell = requires(S& shell, const Frame& frame, const HapticSample& sample,
                              const FaultEvent& fault, double now) {
  { shell.next_tick() } -> std::same_as<FrameTick>;  // waits, where the clock does
  { shell.is_stopped() } -> std::convertible_to<bool>;
  { shell.hang(fault, now) } -> std::convertible_to<bool>;  // injected; true: there is no step
  shell.prepare(frame);  // what changes between two steps: gains, contact models
  // of the processor spent so far; the frame's is that of its step. Below 0: not measured
  { shell.cpu_ns() } -> std::same_as<std::int64_t>;
  shell.step(frame);
  { shell.sample(frame) } -> std::convertible_to<const HapticSample&>;  // of that step
  shell.publish(frame, sample);
  { shell.has_finished(sample) } -> std::convertible_to<bool>;  // nothing more will come
};

/// Frames of the whole session; practically endless without a duration.
std::uint64_t frame_limit(const SessionConfig& config) noexcept;

/// Begins the frame of a tick. A late step catches up, but for at most ten ticks: a body that has
/// been without control for longer is better advanced too little than too far.
/// Thread    [haptic].
Frame begin_frame(const SessionConfig& config, const FrameTick& tick,
                  FrameRecord& record) THIGMA_RT;

/// Takes a frame that was made into the record.
/// Thread    [haptic].
void end_frame(const SessionConfig& config, const Frame& frame, const HapticSample& sample,
               FrameRecord& record) THIGMA_RT;

/// Whether zero force has been kept up for SessionConfig::after_fault since a fault that ends the
/// session.
/// Thread    [haptic].
bool is_fault_over(const SessionConfig& config, const FrameRecord& record) THIGMA_RT;

/// How a session ended whose loop did for this reason: a latched fault counts before any other.
SessionEnd end_of_frames(const SessionConfig& config, const FrameRecord& record,
                         SessionEnd reason) noexcept;

/// Times of a frame, for the telemetry of the next.
inline void note_times(const Frame& frame, HapticState& state) THIGMA_RT {
  state.step_cpu = static_cast<float>(1e-9 * static_cast<double>(frame.cpu_ns));
  if (frame.wake_late_ns >= 0)
    state.wake_late = static_cast<float>(1e-9 * static_cast<double>(frame.wake_late_ns));
}

/// Makes the frame of the shell's next tick, or leaves it out; what ended the session, or nothing.
///
/// config   constant, but for what only the contact thread reads
/// shell    is called by this thread alone; what its members throw comes out
/// Thread   [haptic] where the shell's members are: nothing in here allocates, locks or logs
template <FrameShell Shell>
std::optional<SessionEnd> drive_frame(const SessionConfig& config, Shell& shell,
                                      FrameRecord& record) {
  const auto ended = [&](SessionEnd reason) { return end_of_frames(config, record, reason); };
  const FrameTick tick = shell.next_tick();
  record.time = static_cast<double>(tick.index) / config.rate;
  if (tick.index >= frame_limit(config)) return ended(SessionEnd::duration);
  if (shell.is_stopped()) return ended(SessionEnd::stopped);
  const FaultEvent* hang = active_fault(config.faults, InjectedFault::hang, record.time);
  if (hang != nullptr && shell.hang(*hang, record.time)) return std::nullopt;

  Frame frame = begin_frame(config, tick, record);
  shell.prepare(frame);
  const std::int64_t begin = shell.cpu_ns();
  shell.step(frame);
  frame.cpu_ns = begin < 0 ? -1 : shell.cpu_ns() - begin;
  const HapticSample& sample = shell.sample(frame);
  end_frame(config, frame, sample, record);
  shell.publish(frame, sample);

  if (is_fault_over(config, record)) return SessionEnd::fault;
  if (shell.has_finished(sample)) return ended(SessionEnd::device_finished);
  return std::nullopt;
}

/// Makes frames until something ends the session. Parameters and thread as of drive_frame.
template <FrameShell Shell>
SessionEnd drive_frames(const SessionConfig& config, Shell& shell, FrameRecord& record) {
  while (true) {
    if (const std::optional<SessionEnd> end = drive_frame(config, shell, record)) return *end;
  }
}

}  // namespace thigma::detail
