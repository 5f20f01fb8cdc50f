#pragma once
// CPU time, for reports and for budgets.

#include <time.h>

namespace thigma {

/// Reading of a clock of the system [s].
inline double clock_seconds(clockid_t clock) noexcept {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// CPU time of the calling thread so far [s]. A system call: not for the haptic step.
inline double thread_cpu_seconds() noexcept { return clock_seconds(CLOCK_THREAD_CPUTIME_ID); }

/// CPU time of all threads of the process so far [s].
inline double process_cpu_seconds() noexcept { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace thigma
