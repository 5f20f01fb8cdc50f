#pragma once
// The few calls that make a thread keep time. Nothing here happens by itself: programs ask for it.

#include <atomic>
#include <cstdint>
#include <string>

#include "thigma/core/rt.h"
#include "thigma/session/histogram.h"

namespace thigma {

/// What to ask the system for.
struct RtRequest {
  int priority = 80;  // SCHED_FIFO priority 1..99; 0: stay an ordinary thread
  int cpu = -1;       // pin to this processor; -1: anywhere
};

/// What the system granted, and a sentence for the user where it did not ("" when all was granted).
struct RtGrant {
  bool is_fifo = false;
  bool is_pinned = false;
  std::string refused;
};

/// Gives the calling thread a real-time schedule.
/// Thread    [offline].
RtGrant request_real_time(const RtRequest& request);

/// Locks the memory of the whole process, now and to come; "" or why not. For programs, never
/// called by the library.
std::string lock_process_memory();

/// CLOCK_MONOTONIC [ns].
/// Thread    [haptic]: no system call where the kernel offers the vDSO.
std::int64_t monotonic_ns() noexcept;

/// A step that another thread has noted: when, 0 for none, and how long ago that is [ns].
struct NotedStep {
  std::int64_t at = 0, ago = 0;
};

/// The clock is read first: put to sleep between the two, the caller must not see a step as old
/// that was made meanwhile. Thread any; no failure.
inline NotedStep noted_step(const std::atomic<std::int64_t>& at_ns) noexcept {
  const std::int64_t now = monotonic_ns();
  const std::int64_t at = at_ns.load(std::memory_order_acquire);
  return {at, at == 0 ? 0 : now - at};
}

/// CPU time of the calling thread [ns]. A system call: for the shells around the steps, not within.
std::int64_t thread_cpu_ns() noexcept;

/// Ticks at a fixed rate, by absolute deadlines. It sleeps until a margin before each and polls
/// from there: wake-ups are late, polls are not. The margin follows how late wake-ups were of late,
/// between two bounds.
struct DeadlineClock {
  std::int64_t period_ns = 1'000'000;
  std::int64_t margin_ns = 150'000;
  std::int64_t least_margin_ns = 20'000, most_margin_ns = 250'000;  // equal: the margin is fixed
  std::int64_t start_ns = 0;                                        // of tick 0
  std::int64_t tick = 0;                                            // the next to wait for
  std::uint64_t missed = 0;    // ticks that had passed before they could be waited for
  std::int64_t polled_ns = 0;  // CPU time that was spent on being punctual
};

/// Clock of a rate [Hz].
/// margin    polled before each deadline, at most the period [s]; below 0: as long as this
///           machine's wake-ups ask for, from 20 us to 250 us or half the period
/// Thread    [any].
DeadlineClock clock_of(double rate, double margin = -1.0) noexcept;

/// The margin after a wake-up that was `overslept_ns` late: twice that at once where it is more
/// than now; forgotten by 1/256 a tick where it is less.
std::int64_t next_margin(std::int64_t margin_ns, std::int64_t overslept_ns, std::int64_t least_ns,
                         std::int64_t most_ns) noexcept;

/// How long to sleep before looking again for what comes every period from a thread that may not
/// call the system to say so: until shortly before it is due, then every 50 us, and the rarer the
/// longer it is overdue, at least once a period [ns].
///
/// expected_ns   when it is due [ns]
std::int64_t look_again_in(std::int64_t now_ns, std::int64_t expected_ns,
                           std::int64_t period_ns) noexcept;

/// Starts the clock one period from now.
void start_clock(DeadlineClock& clock) noexcept;

/// Waits for the next tick, leaving out those that are over by more than a period; returns how late
/// it woke [ns]. clock.tick is then the tick after it, at start_ns + tick * period_ns. Thread: the
/// shell of the haptic thread.
std::int64_t wait_for_tick(DeadlineClock& clock) noexcept;

/// The tick that a device which owns the clock has come to, counted by the clock's rate: those that
/// are over by more than a period are left out, and a device that is faster than that is half a
/// period ahead at most. Returns how many were left out; clock.tick is then the tick after it.
///
/// has_begun  false: this is the first
/// Thread     [haptic]
std::uint64_t come_to_tick(std::int64_t now_ns, bool has_begun, DeadlineClock& clock) THIGMA_RT;

/// What a thread that does nothing achieves on this machine: the floor for missed frames and
/// lateness.
struct EmptyLoop {
  std::uint64_t ticks = 0, missed = 0;
  DurationHistogram wake_late;
  double polled_share = 0.0;  // of the time
};

/// Ticks at `rate` [Hz] for `seconds` in a thread of its own with the schedule asked for; margin as
/// of clock_of.
/// Thread    [offline].
EmptyLoop measure_empty_loop(const RtRequest& request, double rate, double seconds,
                             double margin = -1.0);

/// Sleeps about this long.
/// Thread    [any but haptic].
void sleep_ns(std::int64_t nanoseconds) noexcept;

}  // namespace thigma
