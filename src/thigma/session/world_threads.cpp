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
  std::atomic<std::uint64_t> ticks{0};    // hands -> world: of their clock, so far
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
  std::uint64_t missed = 0;
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
    shared.ticks.fetch_add(skipped + 1, std::memory_order_release);
  }

  void run(const RtRequest& request) {
    if (request.priority > 0) refused = request_real_time(request).refused;
    start_clock(clock);
    while (!shared.should_stop.load(std::memory_order_acquire)) {
      const std::uint64_t before = clock.missed;
      wait_for_tick(clock);
      const std::uint64_t skipped = clock.missed - before;
      missed += skipped;
      now += static_cast<double>(skipped) * period;
      step(skipped);
      now += period;
      if (shared.fault.load(std::memory_order_relaxed) != Fault::none) break;
    }
    let_go(apart);  // now, and not when the world's step ends
  }
};

/// The world's thread.
struct WorldSide {
  WorldApart& apart;
  Shared& shared;
  const WorldShell& shell;
  double period;
  std::uint64_t seen = 0;  // ticks of the hands that its last step knew

  bool is_stopped() const {
    return shell.stop != nullptr && shell.stop->load(std::memory_order_relaxed);
  }
  bool is_over() const {
    return is_stopped() || shared.fault.load(std::memory_order_acquire) != Fault::none;
  }

  /// Waits for a haptic step that the world has not had; how many ticks it has missed before that.
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
      const std::uint64_t lost = wait();
      if (is_over()) break;
      apart.run->lose(lost);
      if (shell.between) shell.between(*apart.run);
      const WorldFrame* frame = apart.run->make_frame();
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
  // Ticks are slept for, not polled: the world needs the processor as well.
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
  summary.haptic_missed = hands.missed;
  summary.haptic_cpu = hands.step_cpu;
  return summary;
}

}  // namespace thigma
