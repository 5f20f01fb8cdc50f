// A world by the clock on the wall: the shell of WorldRun that waits.

#include "thigma/session/rt_thread.h"
#include "thigma/session/world_session.h"

namespace thigma {
namespace {

/// Ticks of the clock on the wall. They are slept for to the end, never polled: nobody's hand is
/// held, and the page needs the processor as well.
struct WallTicks {
  DeadlineClock clock;
  explicit WallTicks(double rate) : clock(clock_of(rate, 0.0)) { start_clock(clock); }
  std::uint64_t wait() noexcept {
    const std::uint64_t before = clock.missed;
    wait_for_tick(clock);
    return clock.missed - before;
  }
};

/// What happens between two frames. Hands are aimed by the numbers that bodies have before it.
void change(const WorldShell& shell, WorldRun& run) {
  if (shell.live != nullptr && shell.live->aim.fetch()) run.aim(shell.live->aim.value());
  if (shell.between) shell.between(run);
}

/// The world stands still until the pause ends, a single step is asked for or the session ends;
/// whether it did.
bool hold_while_paused(const WorldShell& shell, WorldRun& run) {
  LivePorts* live = shell.live;
  if (live == nullptr || !live->is_paused.load(std::memory_order_relaxed)) return false;
  while (live->is_paused.load(std::memory_order_relaxed) && !take_step(*live)) {
    if (shell.stop != nullptr && shell.stop->load(std::memory_order_relaxed)) break;
    change(shell, run);
    sleep_ns(1'000'000);
  }
  return true;
}

}  // namespace

WorldSummary run_world_by_clock(const WorldSessionConfig& config,
                                std::span<HapticDevice* const> devices, const WorldShell& shell) {
  WorldRun run(config, devices);
  WallTicks wall(config.rate);
  const auto is_stopped = [&] {
    return shell.stop != nullptr && shell.stop->load(std::memory_order_relaxed);
  };
  bool was_stopped = is_stopped();
  while (!was_stopped) {
    if (hold_while_paused(shell, run)) start_clock(wall.clock);
    run.lose(shell.wait_for_tick ? shell.wait_for_tick() : wall.wait());
    change(shell, run);
    const WorldFrame* frame = run.make_frame(shell.live != nullptr ? &shell.live->aim : nullptr);
    if (frame == nullptr) break;
    if (shell.sink) shell.sink(*frame);
    was_stopped = is_stopped();
  }
  WorldSummary summary = run.end();
  summary.was_stopped = was_stopped;
  return summary;
}

}  // namespace thigma
