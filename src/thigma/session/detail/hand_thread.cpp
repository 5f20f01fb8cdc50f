#include "thigma/session/detail/hand_thread.h"

#include <algorithm>
#include <cmath>

#include "thigma/session/detail/frame_driver.h"

namespace thigma::detail {
namespace {

void step(std::uint64_t skipped, HandThread& hands) {
  HandsShared& shared = hands.shared;
  const double gap = static_cast<double>(skipped + 1) * hands.period;
  HapticTick tick;
  tick.elapsed = static_cast<double>(std::min(skipped + 1, kMostTicks)) * hands.period;
  tick.now = hands.now;
  shared.token.take();
  const bool was_stopped = shared.was_stopped.exchange(false, std::memory_order_acquire);
  if (was_stopped || gap > hands.watchdog) tick.external_fault = Fault::watchdog;
  shared.last_step_ns.store(monotonic_ns(), std::memory_order_release);
  const std::int64_t begin = thread_cpu_ns();
  const Fault fault = step_hands(tick, hands.apart);
  const std::int64_t took = thread_cpu_ns() - begin;
  shared.last_step_ns.store(monotonic_ns(), std::memory_order_release);
  shared.token.give_back();
  record(hands.step_cpu, took);
  if (took > shared.longest_ns.load(std::memory_order_relaxed))
    shared.longest_ns.store(took, std::memory_order_relaxed);
  if (fault != Fault::none) shared.fault.store(fault, std::memory_order_release);
  shared.missed.fetch_add(skipped, std::memory_order_relaxed);
  shared.ticks.fetch_add(skipped + 1, std::memory_order_release);
}

/// Waits for the next tick, which is there when asked for while paused; false: it is paused.
bool wait(std::uint64_t& skipped, HandThread& hands) {
  HandsShared& shared = hands.shared;
  skipped = 0;
  if (shared.is_held.load(std::memory_order_acquire)) {
    shared.last_step_ns.store(0, std::memory_order_release);
    if (hands.singles < shared.singles.load(std::memory_order_acquire)) {
      ++hands.singles;
      return true;
    }
    sleep_ns(1'000'000);
    start_clock(hands.clock);
    return false;
  }
  // None is owed to a later pause.
  hands.singles = shared.singles.load(std::memory_order_acquire);
  const std::uint64_t before = hands.clock.missed;
  wait_for_tick(hands.clock);
  skipped = hands.clock.missed - before;
  return true;
}

}  // namespace

std::size_t tick_room(double rate, std::size_t hands) {
  constexpr double kLate = 16.0;  // [s]
  return std::max<std::size_t>(16384, static_cast<std::size_t>(std::ceil(kLate * rate)) * hands);
}

void run_hands(const RtRequest& request, HandThread& hands) {
  HandsShared& shared = hands.shared;
  if (request.priority > 0) hands.refused = request_real_time(request).refused;
  start_clock(hands.clock);
  while (!shared.should_stop.load(std::memory_order_acquire)) {
    std::uint64_t skipped = 0;
    if (!wait(skipped, hands)) continue;
    hands.now += static_cast<double>(skipped) * hands.period;
    step(skipped, hands);
    hands.now += hands.period;
    if (shared.fault.load(std::memory_order_relaxed) != Fault::none) break;
  }
  shared.token.take();
  let_go(hands.apart);  // now, and not when the world's step ends
  shared.last_step_ns.store(0, std::memory_order_release);
  shared.token.give_back();
}

void watch_hands(double limit, const RtRequest& hands, WorldApart& apart, HandsShared& shared) {
  // Above the hands' thread: it must run when that one never gives way.
  if (hands.priority > 0) request_real_time({std::min(hands.priority + 1, 99), -1});
  constexpr double kLongest = 3600.0;  // [s]; no watchdog at all, for a person
  const auto limit_ns = static_cast<std::int64_t>(1e9 * std::min(limit, kLongest));
  const std::int64_t look_ns =
      std::min<std::int64_t>(limit_ns / 20, 10'000'000);  // the end as well
  std::int64_t stopped_ns = 0;                            // the last step of a hang that is known
  while (!shared.should_stop.load(std::memory_order_acquire)) {
    sleep_ns(look_ns);
    const std::int64_t seen = shared.last_step_ns.load(std::memory_order_acquire);
    if (seen == 0 || seen == stopped_ns || monotonic_ns() - seen <= limit_ns) continue;
    if (!shared.token.try_take()) continue;
    if (shared.last_step_ns.load(std::memory_order_acquire) == seen) {
      let_go(apart);
      shared.was_stopped.store(true, std::memory_order_release);
      shared.stops.fetch_add(1, std::memory_order_relaxed);
      stopped_ns = seen;
    }
    shared.token.give_back();
  }
}

}  // namespace thigma::detail
