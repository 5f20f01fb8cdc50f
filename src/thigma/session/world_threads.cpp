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
using detail::HandThread;
using Hands = std::vector<std::unique_ptr<HandThread>>;  // null where there is no device

/// The world's thread.
struct WorldSide {
  WorldApart& apart;
  const Hands& hands;
  HandsShared& shared;
  const WorldShell& shell;
  double period;
  bool may_pause;            // no device holds a person
  std::uint64_t newest = 0;  // tick of any hand, that it had
  std::vector<std::uint64_t> seen = std::vector<std::uint64_t>(hands.size(), 0);  // ticks, by hand
  std::vector<std::uint8_t> was_late = std::vector<std::uint8_t>(hands.size(), 0);  // likewise
  std::vector<HandTick> ticks{};

  bool is_over() const {
    return detail::is_stopped(shell) || shared.fault.load(std::memory_order_acquire) != Fault::none;
  }

  /// Hands and world stand still until the pause ends, a single step is asked for or all ends;
  /// whether they did.
  bool hold_while_paused() {
    const bool was_paused = may_pause && detail::is_paused(shell);
    shared.is_held.store(was_paused, std::memory_order_release);
    if (!was_paused) return false;
    if (detail::wait_out_pause(shell, *apart.run, [&] { return is_over(); }))
      shared.singles.fetch_add(1, std::memory_order_release);
    else
      shared.is_held.store(false, std::memory_order_release);
    return true;
  }

  bool has_ticked(std::size_t i) const {
    return hands[i]->ticks.load(std::memory_order_acquire) != seen[i];
  }

  /// Whether a hand has ticked since the last step.
  bool has_any() const {
    for (std::size_t i = 0; i < hands.size(); ++i)
      if (hands[i] != nullptr && has_ticked(i)) return true;
    return false;
  }

  /// Whether all have that are not late anyway.
  bool has_all() const {
    for (std::size_t i = 0; i < hands.size(); ++i)
      if (hands[i] != nullptr && was_late[i] == 0 && !has_ticked(i)) return false;
    return true;
  }

  /// Waits for a haptic step that the world has not had, and a little for those of other hands at
  /// the same tick; how many ticks it has missed before that.
  std::uint64_t wait() {
    const auto period_ns = static_cast<std::int64_t>(1e9 * period);
    const std::int64_t expected = monotonic_ns() + period_ns / 2;
    while (!has_any() && !is_over()) sleep_ns(look_again_in(monotonic_ns(), expected, period_ns));
    const std::int64_t until = monotonic_ns() + period_ns / 4;
    while (!has_all() && monotonic_ns() < until && !is_over()) sleep_ns(period_ns / 40);
    std::uint64_t now = newest;
    for (std::size_t i = 0; i < hands.size(); ++i) {
      if (hands[i] == nullptr) continue;
      const std::uint64_t ticks_now = hands[i]->ticks.load(std::memory_order_acquire);
      was_late[i] = ticks_now == seen[i] ? 1 : 0;
      seen[i] = ticks_now;
      now = std::max(now, ticks_now);
    }
    const std::uint64_t lost = now > newest ? now - newest - 1 : 0;
    newest = now;
    return lost;
  }

  WorldHapticNow haptic_now() const {
    WorldHapticNow now;
    now.ticks = newest;
    std::uint64_t steps = 0;
    std::int64_t longest = 0;
    for (const auto& hand : hands) {
      if (hand == nullptr) continue;
      steps = std::max(steps, hand->steps.load(std::memory_order_relaxed));
      longest = std::max(longest, hand->longest_ns.exchange(0, std::memory_order_relaxed));
    }
    now.missed = newest - std::min(steps, newest);
    now.step_cpu = 1e-9 * static_cast<double>(longest);
    now.sent = apart.sent;
    now.seen = apart.seen;
    return now;
  }

  /// Hands over the steps that hands have made.
  void drain() {
    if (apart.ticks.empty()) return;
    ticks.clear();
    for (const auto& ring : apart.ticks) {
      for (std::size_t left = ring->capacity(); left > 0; --left) {
        const HandTick* tick = ring->front();
        if (tick == nullptr) break;
        ticks.push_back(*tick);
        ring->pop();
      }
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
  std::vector<std::thread> threads{};
  void end() {
    shared.should_stop.store(true, std::memory_order_release);
    for (std::thread& thread : threads) thread.join();
    threads.clear();
  }
  ~Joined() { end(); }
};

Hands hands_of(const WorldSessionConfig& config, WorldApart& apart, HandsShared& shared) {
  Hands hands(apart.loops.size());
  for (std::size_t i = 0; i < hands.size(); ++i)
    if (apart.loops[i] != nullptr)
      hands[i] = std::make_unique<HandThread>(i, config.hands[i].limits, apart, shared);
  return hands;
}

/// What the threads of the hands add to a summary once they have ended.
void add_threads(const Hands& hands, Fault fault, WorldSummary& summary) {
  for (std::size_t i = 0; i < hands.size(); ++i) {
    if (hands[i] == nullptr) continue;
    const HandThread& hand = *hands[i];
    WorldHandSummary& told = summary.hands[i];
    const std::int64_t hung = hand.hung_ns.load(std::memory_order_relaxed);
    if (hung > 0 && told.fault == Fault::none) told.fault = fault;
    told.hung = 1e-9 * static_cast<double>(hung);
    summary.haptic_missed +=
        hand.ticks.load(std::memory_order_relaxed) - hand.steps.load(std::memory_order_relaxed);
    summary.haptic_stops += hand.stops.load(std::memory_order_relaxed);
    if (summary.refused.empty()) summary.refused = hand.refused;
    add(hand.step_cpu, summary.haptic_cpu);
  }
}

}  // namespace

WorldSummary run_world_on_threads(const WorldSessionConfig& config,
                                  std::span<HapticDevice* const> devices, const WorldShell& shell,
                                  const RtRequest& haptic_thread) {
  const bool has_hand = std::any_of(devices.begin(), devices.end(),
                                    [](const HapticDevice* device) { return device != nullptr; });
  if (!has_hand) return run_world_by_clock(config, devices, shell);
  const bool has_person = std::any_of(devices.begin(), devices.end(), [](const HapticDevice* d) {
    return d != nullptr && d->limits().holds_person;
  });
  WorldApart apart(config, devices);
  const std::size_t room = shell.tick_room > 0 ? shell.tick_room : detail::tick_room(config.rate);
  for (std::size_t i = 0; shell.ticks && i < devices.size(); ++i)
    apart.ticks.push_back(std::make_unique<SpscRing<HandTick>>(room));
  HandsShared shared;
  const Hands hands = hands_of(config, apart, shared);
  WorldSide world{apart, hands, shared, shell, 1.0 / config.rate, !has_person};
  // No step before the first that is asked for.
  shared.is_held = !has_person && detail::is_paused(shell);
  Joined joined{shared};
  joined.threads.emplace_back([&] { detail::watch_hands(hands, haptic_thread, shared); });
  for (const auto& hand : hands) {
    if (hand == nullptr) continue;
    detail::start_hand(*hand);
    joined.threads.emplace_back([&] { detail::run_hand(haptic_thread, *hand); });
  }
  world.go();
  const bool was_stopped = detail::is_stopped(shell);
  joined.end();
  world.drain();
  WorldSummary summary = apart.run->end();
  summary.was_stopped = was_stopped;
  const Fault fault = shared.fault.load(std::memory_order_relaxed);
  add_haptic(apart, fault, summary);
  add_threads(hands, fault, summary);
  for (const auto& ring : apart.ticks) summary.haptic_dropped += ring->dropped();
  return summary;
}

}  // namespace thigma
