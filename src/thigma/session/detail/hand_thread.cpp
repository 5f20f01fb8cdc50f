#include "thigma/session/detail/hand_thread.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "thigma/session/detail/check_config.h"
#include "thigma/session/detail/frame_driver.h"
#include "thigma/session/detail/world_hands.h"

namespace thigma::detail {
namespace {

constexpr double kZeroTime = 0.020;  // zero is sent so long after a fault, before a stop [s]

void fail(Fault fault, HandsShared& shared) {
  Fault none = Fault::none;
  if (fault != Fault::none)
    shared.fault.compare_exchange_strong(none, fault, std::memory_order_acq_rel);
}

bool has_failed(const HandsShared& shared) {
  return shared.fault.load(std::memory_order_acquire) != Fault::none;
}

/// A step of the hand, within the token.
void step(std::uint64_t skipped, HandThread& hand) {
  const std::uint64_t index = hand.ticks.load(std::memory_order_relaxed) + skipped;
  const double gap = static_cast<double>(skipped + 1) * hand.period;
  HapticTick tick;
  tick.elapsed = static_cast<double>(std::min(skipped + 1, kMostTicks)) * hand.period;
  tick.now = static_cast<double>(index) * hand.period;
  const bool was_stopped = hand.was_stopped.exchange(false, std::memory_order_acquire);
  if (was_stopped || gap > hand.watchdog) tick.external_fault = Fault::watchdog;
  hand.last_step_ns.store(monotonic_ns(), std::memory_order_release);
  fail(step_hand(tick, hand.hand, hand.apart), hand.shared);
  hand.last_step_ns.store(monotonic_ns(), std::memory_order_release);
  hand.steps.fetch_add(1, std::memory_order_relaxed);
  hand.ticks.store(index + 1, std::memory_order_release);
}

/// The same with what it takes of the processor, which a device's own thread may not ask for.
void timed_step(std::uint64_t skipped, HandThread& hand) {
  const std::int64_t begin = thread_cpu_ns();
  step(skipped, hand);
  const std::int64_t took = thread_cpu_ns() - begin;
  record(hand.step_cpu, took);
  if (took > hand.longest_ns.load(std::memory_order_relaxed))
    hand.longest_ns.store(took, std::memory_order_relaxed);
}

/// Starts its clock so that those of all hands tick at the same moments.
void start(HandThread& hand) {
  start_clock(hand.clock);
  hand.clock.start_ns -= hand.clock.start_ns % hand.clock.period_ns;
}

/// Waits for the next tick, which is there when asked for while paused; false: it is paused.
bool wait(std::uint64_t& skipped, HandThread& hand) {
  HandsShared& shared = hand.shared;
  skipped = 0;
  if (shared.is_held.load(std::memory_order_acquire) && !has_failed(shared)) {
    hand.last_step_ns.store(0, std::memory_order_release);
    if (hand.singles < shared.singles.load(std::memory_order_acquire)) {
      ++hand.singles;
      return true;
    }
    sleep_ns(1'000'000);
    start(hand);
    return false;
  }
  // None is owed to a later pause.
  hand.singles = shared.singles.load(std::memory_order_acquire);
  const std::uint64_t before = hand.clock.missed;
  wait_for_tick(hand.clock);
  skipped = hand.clock.missed - before;
  return true;
}

/// Leaves zero force.
void leave(HandThread& hand) {
  hand.token.take();
  let_go(&hand.device);
  hand.last_step_ns.store(0, std::memory_order_release);
  hand.token.give_back();
}

/// A tick of a device that owns the clock. Left out while the watchdog sends zero: a tick that
/// writes nothing sends zero too.
/// Thread   [haptic]: the device's own.
void device_tick(void* self) noexcept {
  HandThread& hand = *static_cast<HandThread*>(self);
  if (!hand.token.try_take()) return;
  if (hand.is_over || has_failed(hand.shared))
    let_go(&hand.device);
  else
    step(come_to_tick(monotonic_ns(), hand.has_ticked, hand.clock), hand);
  hand.has_ticked = true;
  hand.token.give_back();
}

/// Beside a device that owns the clock: ends its ticks in order. That they stay away once there
/// were some is the watchdog's.
void run_beside_device(HandThread& hand) {
  constexpr std::int64_t kFirstTick =
      1'000'000'000;  // a scheduler may take this long to start [ns]
  const std::int64_t begin = monotonic_ns();
  while (!hand.shared.should_stop.load(std::memory_order_acquire) && !has_failed(hand.shared)) {
    sleep_ns(500'000);
    if (hand.last_step_ns.load(std::memory_order_acquire) != 0) continue;
    if (monotonic_ns() - begin < kFirstTick) continue;
    hand.hung_ns.store(monotonic_ns() - begin, std::memory_order_relaxed);
    fail(Fault::device_lost, hand.shared);
  }
  hand.token.take();
  hand.is_over = true;
  hand.last_step_ns.store(0, std::memory_order_release);
  hand.token.give_back();
  sleep_ns(static_cast<std::int64_t>(1e9 * kZeroTime));
  hand.device.stop_ticks();
  leave(hand);
}

/// Whether a hand has made no step for too long; then its device is let go, where it is not in it.
void look_after(HandThread& hand, std::int64_t& stopped_ns) {
  const auto limit_ns = static_cast<std::int64_t>(1e9 * std::min(hand.watchdog, kLongestWatchdog));
  const auto [seen, hung] = noted_step(hand.last_step_ns);
  if (seen == 0 || seen == stopped_ns || hung <= limit_ns) return;
  hand.was_stopped.store(true, std::memory_order_release);
  if (hand.holds_person && !has_failed(hand.shared)) {
    hand.hung_ns.store(hung, std::memory_order_relaxed);
    fail(Fault::watchdog, hand.shared);
  }
  if (!hand.token.try_take()) return;
  if (hand.last_step_ns.load(std::memory_order_acquire) == seen) {
    let_go(&hand.device);
    hand.stops.fetch_add(1, std::memory_order_relaxed);
    stopped_ns = seen;
  }
  hand.token.give_back();
}

}  // namespace

HandThread::HandThread(std::size_t of, const SafetyLimits& limits, WorldApart& in,
                       HandsShared& with)
    : hand(of),
      apart(in),
      shared(with),
      device(*in.devices[of]),
      period(1.0 / in.config->rate),
      watchdog(std::max(limits.watchdog, 3.0 / in.config->rate)),
      holds_person(device.limits().holds_person),
      is_device_paced(device.limits().clock == DeviceClock::device),
      // A wake-up that is late is felt by a person alone; else the world needs the processor more.
      clock(clock_of(in.config->rate, holds_person ? -1.0 : 0.0)) {}

HandThread::~HandThread() {
  if (is_device_paced) device.stop_ticks();
}

std::size_t tick_room(double rate) {
  constexpr double kLate = 16.0;  // [s]
  return std::max<std::size_t>(16384, static_cast<std::size_t>(std::ceil(kLate * rate)));
}

void start_hand(HandThread& hand) {
  if (hand.is_device_paced) hand.device.start_ticks(1.0 / hand.period, {device_tick, &hand});
}

void run_hand(const RtRequest& request, HandThread& hand) {
  if (hand.is_device_paced) return run_beside_device(hand);
  HandsShared& shared = hand.shared;
  if (request.priority > 0) hand.refused = request_real_time(request).refused;
  const auto zeros = static_cast<std::uint64_t>(std::ceil(kZeroTime / hand.period));
  std::uint64_t sent = 0;  // zeros
  start(hand);
  while (has_failed(shared) ? sent < zeros : !shared.should_stop.load(std::memory_order_acquire)) {
    std::uint64_t skipped = 0;
    if (!wait(skipped, hand)) continue;
    hand.token.take();
    if (has_failed(shared)) {
      let_go(&hand.device);
      ++sent;
    } else {
      timed_step(skipped, hand);
    }
    hand.token.give_back();
  }
  leave(hand);
}

void watch_hands(HandThreads hands, const RtRequest& request, HandsShared& shared) {
  // Above the hands' threads: it must run when one of them never gives way.
  if (request.priority > 0) request_real_time({std::min(request.priority + 1, 99), -1});
  constexpr double kEnd = 0.2;  // the end is looked for as well [s]
  double least = kEnd;
  for (const auto& hand : hands)
    if (hand != nullptr) least = std::min(least, hand->watchdog);
  std::vector<std::int64_t> stopped_ns(hands.size(), 0);  // the last step of a hang that is known
  while (!shared.should_stop.load(std::memory_order_acquire)) {
    sleep_ns(static_cast<std::int64_t>(1e9 * least / 20.0));
    for (std::size_t i = 0; i < hands.size(); ++i)
      if (hands[i] != nullptr) look_after(*hands[i], stopped_ns[i]);
  }
}

}  // namespace thigma::detail
