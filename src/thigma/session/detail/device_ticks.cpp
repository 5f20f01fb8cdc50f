// The haptic thread of a session whose device owns the clock: frames are made in the device's
// thread, one a tick. A thread of the session stands beside it: it ends the ticks, and makes the
// last frames itself when the ticks stay away.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "thigma/session/detail/session_threads.h"

namespace thigma {
namespace {

constexpr std::int64_t kFirstTick = 1'000'000'000;  // a scheduler may take this long to start [ns]
constexpr std::int64_t kZeroTime = 20'000'000;      // zero is sent this long before the stop [ns]
constexpr double kRateShare = 0.02;                 // of the rate that nobody needs to be told

}  // namespace

/// The index of a tick: session time is counted in ticks of the device. Thread [haptic].
detail::FrameTick Session::Impl::next_device_tick() {
  const std::int64_t now = monotonic_ns(), period = clock.period_ns;
  const bool is_first = ticks++ == 0;
  if (is_first) {
    first_tick_ns = now;
    last_tick_ns = now - period;
  }
  come_to_tick(now, !is_first, clock);
  epoch_ns.store(clock.start_ns, std::memory_order_release);
  const std::int64_t late = std::max<std::int64_t>(0, now - last_tick_ns - period);
  last_tick_ns = now;
  return {static_cast<std::uint64_t>(clock.tick - 1), late};
}

/// One tick of the device's own thread. Left out while the watchdog sends zero: a tick that writes
/// nothing sends zero too. Thread [haptic].
void Session::Impl::device_tick() noexcept {
  if (!token.try_take()) return;
  if (last_step_ns.load(std::memory_order_relaxed) == 0 && ticks == 0)
    last_step_ns.store(monotonic_ns(), std::memory_order_release);  // watched from here on
  if (!are_ticks_over) {
    if (const auto ended = detail::drive_frame(config, *this, record)) {
      end = *ended;
      are_ticks_over = true;
    }
  }
  if (are_ticks_over && is_device_paced) {
    device->write(Wrench{});
    last_step_ns.store(0, std::memory_order_release);  // nothing to watch any more
    have_ticks_ended.store(true, std::memory_order_release);
  } else if (are_ticks_over) {
    faulty->write(Wrench{});  // past the stop-watch: the frames are another thread's
  }
  token.give_back();
}

void Session::Impl::start_device() {
  driver.start_ticks(config.rate,
                     {[](void* self) noexcept { static_cast<Impl*>(self)->device_tick(); }, this});
}

/// The ticks stay away: the session goes on by the engine's clock, without the device, until it has
/// ended in order.
void Session::Impl::take_over() {
  const std::int64_t tick = clock.tick;
  const std::uint64_t missed = clock.missed;
  start_clock(clock);
  clock.start_ns -= tick * clock.period_ns;
  clock.tick = tick;
  clock.missed = missed;
  if (last_step_ns.load(std::memory_order_relaxed) == 0)  // no tick has ever come
    last_step_ns.store(monotonic_ns(), std::memory_order_release);
  end = detail::drive_frames(config, *this, record);
  end_with_zero_force();
}

/// Ends the ticks in order: zero force in them for a while, then the vendor's stop.
void Session::Impl::run_beside_device() {
  const std::int64_t begin = monotonic_ns();
  const std::int64_t silent = std::max(to_ns(config.haptic.safety.silent_device), watchdog_ns);
  while (!have_ticks_ended.load(std::memory_order_acquire)) {
    sleep_ns(500'000);
    const NotedStep last = noted_step(last_step_ns);
    if (last.at == 0 ? monotonic_ns() - begin < kFirstTick : last.ago < silent) continue;
    if (!token.try_take()) continue;  // stuck inside a step, or just ticking
    const bool is_mine = !are_ticks_over;
    are_ticks_over = true;
    if (is_mine) is_device_paced = false;
    token.give_back();
    if (is_mine) {
      take_over();
      break;
    }
  }
  sleep_ns(kZeroTime);
  driver.stop_ticks();
  last_step_ns.store(0, std::memory_order_release);
  const double seconds = 1e-9 * static_cast<double>(last_tick_ns - first_tick_ns);
  const double measured = ticks > 1 ? static_cast<double>(ticks - 1) / seconds : 0.0;
  if (seconds > 0.5 && std::abs(measured - config.rate) > kRateShare * config.rate) {
    char text[120];
    std::snprintf(text, sizeof text, "the device ticks at %.0f Hz, %.0f Hz were asked for",
                  measured, config.rate);
    note(text);
  }
  haptic_done.store(true, std::memory_order_release);
}

}  // namespace thigma
