#include "thigma/session/world_threads.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "thigma/math/infinity.h"
#include "thigma/session/detail/hand_thread.h"
#include "thigma/session/detail/world_shell.h"
#include "thigma/session/world_apart.h"

namespace thigma {
namespace {

using detail::HandsShared;

/// The world's thread.
struct WorldSide {
  WorldApart& apart;
  HandsShared& shared;
  const WorldShell& shell;
  double period;
  std::uint64_t seen = 0;  // ticks of the hands that its last step knew
  std::vector<HandTick> ticks{};

  bool is_over() const {
    return detail::is_stopped(shell) || shared.fault.load(std::memory_order_acquire) != Fault::none;
  }

  /// Hands and world stand still until the pause ends, a single step is asked for or all ends;
  /// whether they did.
  bool hold_while_paused() {
    const bool was_paused = detail::is_paused(shell);
    shared.is_held.store(was_paused, std::memory_order_release);
    if (!was_paused) return false;
    if (detail::wait_out_pause(shell, *apart.run, [&] { return is_over(); }))
      shared.singles.fetch_add(1, std::memory_order_release);
    else
      shared.is_held.store(false, std::memory_order_release);
    return true;
  }

  /// Waits for a haptic step that the world has not had; how many ticks it has missed before that.
  std::uint64_t wait() {
    const auto period_ns = static_cast<std::int64_t>(1e9 * period);
    const std::int64_t expected = monotonic_ns() + period_ns / 2;
    while (shared.ticks.load(std::memory_order_acquire) == seen && !is_over())
      sleep_ns(look_again_in(monotonic_ns(), expected, period_ns));
    const std::uint64_t now = shared.ticks.load(std::memory_order_acquire);
    const std::uint64_t lost = now > seen ? now - seen - 1 : 0;
    seen = now;
    return lost;
  }

  WorldHapticNow haptic_now() const {
    WorldHapticNow now;
    now.ticks = seen;
    now.missed = shared.missed.load(std::memory_order_relaxed);
    now.step_cpu =
        1e-9 * static_cast<double>(shared.longest_ns.exchange(0, std::memory_order_relaxed));
    now.sent = apart.sent;
    now.seen = apart.seen;
    return now;
  }

  /// Hands over the steps that hands have made.
  void drain() {
    if (apart.ticks == nullptr) return;
    ticks.clear();
    for (std::size_t left = apart.ticks->capacity(); left > 0; --left) {
      const HandTick* tick = apart.ticks->front();
      if (tick == nullptr) break;
      ticks.push_back(*tick);
      apart.ticks->pop();
    }
    shell.ticks(ticks);
  }

  void go() {
    while (!is_over()) {
      const bool was_held = hold_while_paused();
      const std::uint64_t lost = wait();
      if (is_over()) break;
      // The hands may have been in a step as the pause began.
      apart.run->lose(was_held ? 0 : lost);
      detail::change(shell, *apart.run);
      WorldFrame* frame = apart.run->make_frame(shell.live != nullptr ? &shell.live->aim : nullptr);
      if (frame == nullptr) break;
      publish_news(*frame, period, apart);
      frame->haptic = haptic_now();
      if (shell.sink) shell.sink(*frame);
      drain();
    }
  }
};

/// Ends the other threads however the world's ends.
struct Joined {
  HandsShared& shared;
  std::thread hands{}, watchdog{};
  void end() {
    shared.should_stop.store(true, std::memory_order_release);
    if (hands.joinable()) hands.join();
    if (watchdog.joinable()) watchdog.join();
  }
  ~Joined() { end(); }
};

double watchdog_of(const WorldSessionConfig& config) {
  double least = kInfinity;
  for (const WorldHand& hand : config.hands) least = std::min(least, hand.limits.watchdog);
  return std::max(least, 3.0 / config.rate);
}

}  // namespace

WorldSummary run_world_on_threads(const WorldSessionConfig& config,
                                  std::span<HapticDevice* const> devices, const WorldShell& shell,
                                  const RtRequest& haptic_thread) {
  const bool has_hand = std::any_of(devices.begin(), devices.end(),
                                    [](const HapticDevice* device) { return device != nullptr; });
  if (!has_hand) return run_world_by_clock(config, devices, shell);
  WorldApart apart(config, devices);
  const std::size_t room =
      shell.tick_room > 0 ? shell.tick_room : detail::tick_room(config.rate, devices.size());
  if (shell.ticks) apart.ticks = std::make_unique<SpscRing<HandTick>>(room);
  HandsShared shared;
  const double period = 1.0 / config.rate, watchdog = watchdog_of(config);
  // Ticks are slept for, not polled: the world needs the processor as well.
  detail::HandThread hands{apart, shared, clock_of(config.rate, 0.0), period, watchdog};
  WorldSide world{apart, shared, shell, period};
  shared.is_held = detail::is_paused(shell);  // no step before the first that is asked for
  Joined joined{shared};
  joined.hands = std::thread([&] { detail::run_hands(haptic_thread, hands); });
  joined.watchdog =
      std::thread([&] { detail::watch_hands(watchdog, haptic_thread, apart, shared); });
  world.go();
  const bool was_stopped = detail::is_stopped(shell);
  joined.end();
  world.drain();
  WorldSummary summary = apart.run->end();
  summary.was_stopped = was_stopped;
  summary.refused = hands.refused;
  add_haptic(apart, shared.fault.load(std::memory_order_relaxed), summary);
  summary.haptic_missed = shared.missed.load(std::memory_order_relaxed);
  summary.haptic_cpu = hands.step_cpu;
  if (apart.ticks != nullptr) summary.haptic_dropped = apart.ticks->dropped();
  summary.haptic_stops = shared.stops.load(std::memory_order_relaxed);
  return summary;
}

}  // namespace thigma
