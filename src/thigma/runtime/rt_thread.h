#pragma once
// The few calls that make a thread keep time. Nothing here happens by itself: programs ask for it.

#include <cstdint>
#include <string>

#include "thigma/core/rt.h"
#include "thigma/runtime/histogram.h"

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

/// CPU time of the calling thread [ns]. A system call: for the shells around the steps, not within.
std::int64_t thread_cpu_ns() noexcept;

/// Ticks at a fixed rate, by absolute deadlines.
struct DeadlineClock {
  std::int64_t period_ns = 1'000'000;
  std::int64_t spin_ns = 150'000;  // sleep until this long before the deadline, then poll: wake-ups
                                   // are late, polls are not
  std::int64_t start_ns = 0;       // of tick 0
  std::int64_t tick = 0;           // the next to wait for
  std::uint64_t missed = 0;        // ticks that had passed before they could be waited for
};

/// Starts the clock one period from now.
void start_clock(DeadlineClock& clock) noexcept;

/// Waits for the next tick, leaving out those that are over by more than a period; returns how late
/// it woke [ns]. clock.tick is then the tick after it, at start_ns + tick * period_ns. Thread: the
/// shell of the haptic thread.
std::int64_t wait_for_tick(DeadlineClock& clock) noexcept;

/// What a thread that does nothing achieves on this machine: the floor for missed frames and
/// lateness.
struct EmptyLoop {
  std::uint64_t ticks = 0, missed = 0;
  DurationHistogram wake_late;
};

/// Ticks at `rate` [Hz] for `seconds` in a thread of its own with the schedule asked for.
/// Thread    [offline].
EmptyLoop measure_empty_loop(const RtRequest& request, double rate, double seconds);

/// Sleeps about this long.
/// Thread    [any but haptic].
void sleep_ns(std::int64_t nanoseconds) noexcept;

}  // namespace thigma
