#include "thigma/session/world_threads.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "thigma/math/infinity.h"
#include "thigma/session/world_apart.h"

namespace thigma {
namespace {

/// What both threads look at.
struct Shared {
  std::atomic<bool> should_stop{false};   // world -> hands
  std::atomic<bool> is_held{false};       // world -> hands: paused
  std::atomic<std::uint64_t> singles{0};  // world -> hands: steps asked for while paused
  std::atomic<std::uint64_t> ticks{0};    // hands -> world: haptic steps made
  std::atomic<Fault> fault{Fault::none};  // hands -> world
};

/// The hands' thread.
struct Hands {
  WorldApart& apart;
  Shared& shared;
  DeadlineClock clock;
  double period;
  double watchdog;  // a gap that is no longer ridden over without a new ramp [s]
  double now = 0.0;
  std::uint64_t singles = 0, missed = 0;
  DurationHistogram step_cpu{};
  std::string refused{};

  void step(std::uint64_t skipped) {
    constexpr std::uint64_t kMost = 10;  // ticks that a step makes up for
    const double gap = static_cast<double>(skipped + 1) * period;
    HapticTick tick;
    tick.elapsed = static_cast<double>(std::min(skipped + 1, kMost)) * period;
    if (gap > watchdog) tick.external_fault = Fault::watchdog;
    tick.now = now;
    const std::int64_t begin = thread_cpu_ns();
    const Fault fault = step_hands(tick, apart);
    record(step_cpu, thread_cpu_ns() - begin);
    if (fault != Fault::none) shared.fault.store(fault, std::memory_order_release);
    shared.ticks.fetch_add(1, std::memory_order_release);
  }

  /// Waits for what is to be done next; false: nothing is, it is paused.
  bool wait(std::uint64_t& skipped) {
    skipped = 0;
    if (shared.is_held.load(std::memory_order_acquire)) {
      if (singles < shared.singles.load(std::memory_order_acquire)) {
        ++singles;
        return true;
      }
      sleep_ns(1'000'000);
      start_clock(clock);  // the session's time stands still
      return false;
    }
    const std::uint64_t before = clock.missed;
    wait_for_tick(clock);
    skipped = clock.missed - before;
    missed += skipped;
    return true;
  }

  void run(const RtRequest& request) {
    if (request.priority > 0) refused = request_real_time(request).refused;
    start_clock(clock);
    while (!shared.should_stop.load(std::memory_order_acquire)) {
      std::uint64_t skipped = 0;
      if (!wait(skipped)) continue;
      now += static_cast<double>(skipped) * period;
      step(skipped);
      now += period;
      if (shared.fault.load(std::memory_order_relaxed) != Fault::none) break;
    }
  }
};

/// The world's thread.
struct WorldSide {
  WorldApart& apart;
  Shared& shared;
  const WorldShell& shell;
  double period;
  std::uint64_t seen = 0;  // haptic steps that its last step knew

  bool is_stopped() const {
    return shell.stop != nullptr && shell.stop->load(std::memory_order_relaxed);
  }
  bool is_over() const {
    return is_stopped() || shared.fault.load(std::memory_order_acquire) != Fault::none;
  }

  /// What happens between two frames. Hands are aimed by the numbers that bodies have before it.
  void change() const {
    if (shell.live != nullptr && shell.live->aim.fetch()) apart.run->aim(shell.live->aim.value());
    if (shell.between) shell.between(*apart.run);
  }

  /// Hands and world stand still until the pause ends, a single step is asked for or all ends.
  void hold_while_paused() {
    LivePorts* live = shell.live;
    if (live == nullptr || !live->is_paused.load(std::memory_order_relaxed)) {
      shared.is_held.store(false, std::memory_order_release);
      return;
    }
    shared.is_held.store(true, std::memory_order_release);
    while (live->is_paused.load(std::memory_order_relaxed) && !is_over()) {
      if (take_step(*live)) {
        shared.singles.fetch_add(1, std::memory_order_release);
        return;
      }
      change();
      sleep_ns(1'000'000);
    }
    shared.is_held.store(false, std::memory_order_release);
  }

  /// Waits for a haptic step that the world has not had; how many it has missed before that.
  std::uint64_t wait() {
    const auto period_ns = static_cast<std::int64_t>(1e9 * period);
    const std::int64_t expected = monotonic_ns() + period_ns / 2;
    while (shared.ticks.load(std::memory_order_acquire) == seen && !is_over())
      sleep_ns(look_again_in(monotonic_ns(), expected, period_ns));
    const std::uint64_t ticks = shared.ticks.load(std::memory_order_acquire);
    const std::uint64_t lost = ticks > seen ? ticks - seen - 1 : 0;
    seen = ticks;
    return lost;
  }

  void go() {
    while (!is_over()) {
      hold_while_paused();
      const std::uint64_t lost = wait();
      if (is_over()) break;
      apart.run->lose(lost);
      change();
      const WorldFrame* frame =
          apart.run->make_frame(shell.live != nullptr ? &shell.live->aim : nullptr);
      if (frame == nullptr) break;
      publish_news(*frame, period, apart);
      if (shell.sink) shell.sink(*frame);
    }
  }
};

/// Ends the hands' thread however the world's ends.
struct Joined {
  Shared& shared;
  std::thread thread;
  void end() {
    shared.should_stop.store(true, std::memory_order_release);
    if (thread.joinable()) thread.join();
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
  Shared shared;
  const double period = 1.0 / config.rate;
  // Ticks are slept for, not polled: the page needs the processor as well.
  Hands hands{apart, shared, clock_of(config.rate, 0.0), period, watchdog_of(config)};
  WorldSide world{apart, shared, shell, period};
  Joined joined{shared, std::thread([&] { hands.run(haptic_thread); })};
  world.go();
  const bool was_stopped = world.is_stopped();
  joined.end();
  WorldSummary summary = apart.run->end();
  summary.was_stopped = was_stopped;
  summary.refused = hands.refused;
  add_haptic(apart, shared.fault.load(std::memory_order_relaxed), summary);
  for (WorldHapticSummary& hand : summary.haptic) {
    hand.missed = hands.missed;
    hand.step_cpu = hands.step_cpu;
  }
  return summary;
}

}  // namespace thigma
