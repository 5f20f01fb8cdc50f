#include "thigma/session/simulated_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "thigma/session/detail/session_parts.h"
#include "thigma/session/live_ports.h"
#include "thigma/simulation/free_motion.h"

namespace thigma {
namespace {

constexpr std::int64_t kPausePoll = 5'000'000;  // [ns]

void add(SimulationCounts& sum, const SimulationCounts& more) {
  sum.steps += more.steps;
  sum.events += more.events;
  sum.impulses += more.impulses;
  sum.supported += more.supported;
  sum.interpolated += more.interpolated;
  sum.doubted += more.doubted;
  sum.unresolved += more.unresolved;
  sum.query_cpu += more.query_cpu;
  sum.front += more.front;
  sum.deepest = std::max(sum.deepest, more.deepest);
  sum.beyond_bound = std::max(sum.beyond_bound, more.beyond_bound);
}

class SimulatedSession {
 public:
  SimulatedSession(const SessionConfig& config, const SimulationWorld& world,
                   const SimulationState& start, const SessionSinks& sinks)
      : config_(config),
        world_(world),
        state_(start),
        sinks_(sinks),
        scratch_(reserve_simulation(world)) {
    reserve_contact_scratch(config.contact, contacts_);
    reported_impact_speed_ = std::sqrt(2.0 * world.body.gravity.norm() * world.tolerance);
    ports_.event = [this](const CollisionEvent& event) { on_collision(event); };
    summary_.energy_start = mechanical_energy(world.body, start.body);
  }

  void frame(std::int64_t wake_late_ns) {
    const BodyState before = state_.body;
    const double energy = mechanical_energy(world_.body, before);
    const std::int64_t begin = thread_cpu_ns();
    const bool was_resting = state_.is_resting;
    const SimulationCounts counts = simulate(world_, 1.0 / config_.rate, state_, scratch_, ports_);
    const std::int64_t cpu = thread_cpu_ns() - begin;
    add(summary_.counts, counts);
    const double growth = mechanical_energy(world_.body, state_.body) - energy;
    summary_.growth_max = std::max(summary_.growth_max, growth);
    tell_contacts(counts.query_cpu);
    tell_frame(before, cpu, wake_late_ns);
    if (state_.is_resting && !was_resting && sinks_.event)
      sinks_.event({time(), frame_, "at_rest", "", {}});
    ++frame_;
  }

  bool is_resting() const { return state_.is_resting; }

  SimulatedSummary finish(SessionEnd end, std::uint64_t missed) {
    SimulatedSummary summary = summary_;
    summary.session = detail::summarize(config_, *haptic_, *contact_, HapticState{});
    summary.session.end = end;
    summary.session.missed = missed;
    summary.is_resting = state_.is_resting;
    summary.energy_end = mechanical_energy(world_.body, state_.body);
    summary.body = state_.body;
    return summary;
  }

 private:
  double time() const { return static_cast<double>(frame_) / config_.rate; }

  void on_collision(const CollisionEvent& event) {
    if (!sinks_.event || !(event.approach > reported_impact_speed_)) return;
    char text[96];
    std::snprintf(text, sizeof text, "impact at %.3f s: %.3g m/s, %.3g N s", event.time,
                  event.approach, event.impulse.norm());
    sinks_.event({time(), frame_, "impact", "", text});
  }

  void tell_contacts(double query_cpu) {
    contacts_.contacts.contacts.assign(scratch_.contacts.contacts.begin(),
                                       scratch_.contacts.contacts.end());
    contacts_.contacts.dropped = scratch_.contacts.dropped;
    contacts_.contacts.stats = scratch_.contacts.stats;
    make_model(config_.contact, {state_.body, time(), frame_}, contacts_, sample_);
    sample_.published = time();
    sample_.query_cpu = sample_.step_cpu = query_cpu;
    accumulate(*contact_, sample_);
    if (config_.live != nullptr) {
      view_contacts(config_.contact, contacts_, time(), config_.live->contacts.draft());
      config_.live->contacts.publish();
    }
    if (sinks_.contact) sinks_.contact(sample_);
  }

  void tell_frame(const BodyState& before, std::int64_t cpu, std::int64_t wake_late) {
    HapticSample sample;
    sample.frame = frame_;
    sample.time = sample.device.time = time();
    sample.elapsed = 1.0 / config_.rate;
    sample.model_sequence = contacts_.sequence;
    sample.body = state_.body;
    sample.handle.pose = {state_.body.position, state_.body.orientation};
    sample.contact.force = config_.rate * (state_.body.linear_momentum - before.linear_momentum) -
                           world_.body.mass * world_.body.gravity;
    sample.contact.torque = config_.rate * (state_.body.angular_momentum - before.angular_momentum);
    if (state_.is_resting) sample.contact = {-world_.body.mass * world_.body.gravity, Vec3::Zero()};
    sample.penetration = sample_.depth_max;
    for (const Contact& c : contacts_.contacts.contacts)
      sample.touching += -c.depth <= 0.25 * world_.tolerance;
    sample.step_cpu = 1e-9f * static_cast<float>(cpu);
    sample.wake_late = 1e-9f * static_cast<float>(std::max<std::int64_t>(wake_late, 0));
    sample.input_digest = input_digest(sample);
    accumulate(*haptic_, sample, cpu, wake_late);
    if (sinks_.haptic) sinks_.haptic(sample);
  }

  const SessionConfig& config_;
  const SimulationWorld& world_;
  SimulationState state_;
  const SessionSinks& sinks_;
  SimulationScratch scratch_;
  SimulationPorts ports_;
  ContactScratch contacts_;
  ContactSample sample_;
  std::unique_ptr<HapticStatistics> haptic_ = std::make_unique<HapticStatistics>();
  std::unique_ptr<ContactStatistics> contact_ = std::make_unique<ContactStatistics>();
  SimulatedSummary summary_;
  std::uint64_t frame_ = 0;
  double reported_impact_speed_ = 0.0;  // speed of an impact worth an event [m/s]
};

// Holds while paused, but for single frames asked for; false when told to stop meanwhile. is_held:
// the clock stood.
bool hold_while_paused(LivePorts* live, const std::atomic<bool>* stop, bool& is_held) {
  is_held = false;
  while (live != nullptr && live->is_paused.load(std::memory_order_relaxed) && !take_step(*live)) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return false;
    is_held = true;
    sleep_ns(kPausePoll);
  }
  return true;
}

}  // namespace

SimulatedSummary run_simulated(const SessionConfig& config, const SimulationWorld& world,
                               const SimulationState& start, bool is_paced,
                               const SessionSinks& sinks, const std::atomic<bool>* stop) {
  detail::check_config(config);
  SimulatedSession session(config, world, start, sinks);
  DeadlineClock clock = clock_of(config.rate, 0.0);  // nobody feels a late frame
  start_clock(clock);
  const std::uint64_t last = detail::frame_limit(config);
  const bool ends_at_rest = config.duration <= 0.0 && config.live == nullptr;
  for (std::uint64_t k = 0; k < last; ++k) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed))
      return session.finish(SessionEnd::stopped, clock.missed);
    std::int64_t late = -1;
    if (is_paced) {
      bool is_held = false;
      if (!hold_while_paused(config.live, stop, is_held))
        return session.finish(SessionEnd::stopped, clock.missed);
      if (is_held) start_clock(clock);
      late = wait_for_tick(clock);
    }
    session.frame(late);
    if (ends_at_rest && session.is_resting())
      return session.finish(SessionEnd::device_finished, clock.missed);
  }
  return session.finish(SessionEnd::duration, clock.missed);
}

}  // namespace thigma
