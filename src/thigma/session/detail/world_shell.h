#pragma once
// What every shell of a world by the clock does between two of its frames.

#include "thigma/session/rt_thread.h"
#include "thigma/session/world_session.h"

namespace thigma::detail {

inline bool is_stopped(const WorldShell& shell) noexcept {
  return shell.stop != nullptr && shell.stop->load(std::memory_order_relaxed);
}

inline bool is_paused(const WorldShell& shell) noexcept {
  return shell.live != nullptr && shell.live->is_paused.load(std::memory_order_relaxed);
}

/// What happens between two frames. Hands are aimed by the numbers that bodies have before it.
inline void change(const WorldShell& shell, WorldRun& run) {
  if (shell.live != nullptr && shell.live->aim.fetch()) run.aim(shell.live->aim.value());
  if (shell.between) shell.between(run);
}

/// Waits, while what happens between two frames goes on, until the pause ends, a single step is
/// asked for or all is over; whether a single step is.
template <class IsOver>
bool wait_out_pause(const WorldShell& shell, WorldRun& run, const IsOver& is_over) {
  while (is_paused(shell) && !is_over()) {
    if (take_step(*shell.live)) return true;
    change(shell, run);
    sleep_ns(1'000'000);
  }
  return false;
}

}  // namespace thigma::detail
