// A world by the clock on the wall: the shell of WorldRun that waits.

#include "thigma/session/detail/world_shell.h"

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

}  // namespace

WorldSummary run_world_by_clock(const WorldSessionConfig& config,
                                std::span<HapticDevice* const> devices, const WorldShell& shell) {
  WorldRun run(config, devices);
  WallTicks wall(config.rate);
  const auto is_over = [&] { return detail::is_stopped(shell); };
  bool was_stopped = is_over();
  while (!was_stopped) {
    if (detail::is_paused(shell)) {
      detail::wait_out_pause(shell, run, is_over);
      start_clock(wall.clock);
    }
    run.lose(shell.wait_for_tick ? shell.wait_for_tick() : wall.wait());
    detail::change(shell, run);
    const WorldFrame* frame = run.make_frame(shell.live != nullptr ? &shell.live->aim : nullptr);
    if (frame == nullptr) break;
    if (shell.sink) shell.sink(*frame);
    was_stopped = is_over();
  }
  WorldSummary summary = run.end();
  summary.was_stopped = was_stopped;
  return summary;
}

}  // namespace thigma
