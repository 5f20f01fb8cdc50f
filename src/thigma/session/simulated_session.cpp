#include "thigma/session/simulated_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "thigma/session/detail/check_config.h"
#include "thigma/session/detail/contact_frames.h"
#include "thigma/session/detail/frame_driver.h"
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

/// The shell of a session without a hand (detail/frame_driver.h).
class SimulatedShell {
 public:
  SimulatedShell(const SessionConfig& config, const SimulatedStart& start, bool is_paced,
                 const SessionSinks& sinks, const std::atomic<bool>* stop)
      : config_(config),
        world_(start.world),
        state_(start.state),
        is_paced_(is_paced),
        sinks_(sinks),
        stop_(stop),
        scratch_(reserve_simulation(start.world)),
        clock_(clock_of(config.rate, 0.0)) {  // nobody feels a late frame
    reserve_contact_scratch(config.contact, contacts_.scratch);
    reported_impact_speed_ = std::sqrt(2.0 * world_.body.gravity.norm() * world_.tolerance);
    ports_.event = [this](const CollisionEvent& event) { on_collision(event); };
    summary_.energy_start = mechanical_energy(world_.body, start.state.body);
  }

  SimulatedSummary run() {
    start_clock(clock_);
    const SessionEnd end = detail::drive_frames(config_, *this, record_);
    SimulatedSummary summary = summary_;
    summary.session = summarize(config_, record_.statistics, contacts_.statistics, HapticState{});
    summary.session.end = end;
    summary.session.missed = clock_.missed;
    summary.is_resting = state_.is_resting;
    summary.energy_end = mechanical_energy(world_.body, state_.body);
    summary.body = state_.body;
    return summary;
  }

  detail::FrameTick next_tick() {
    if (!is_paced_) return {next_++};
    if (hold_while_paused()) start_clock(clock_);
    const std::int64_t late = is_stopped() ? -1 : wait_for_tick(clock_);
    return {next_++, late};
  }
  std::int64_t cpu_ns() const { return thread_cpu_ns(); }
  bool is_stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }
  bool hang(const FaultEvent&, double) { return false; }

  void prepare(const detail::Frame& frame) {
    time_ = frame.now;
    frame_ = frame.index;
    before_ = state_.body;
    was_resting_ = state_.is_resting;
  }

  void step(const detail::Frame& frame) {
    counts_ = simulate(world_, frame.elapsed, state_, scratch_, ports_);
  }

  const HapticSample& sample(const detail::Frame& frame) {
    add(summary_.counts, counts_);
    const double energy = mechanical_energy(world_.body, before_);
    const double growth = mechanical_energy(world_.body, state_.body) - energy;
    summary_.growth_max = std::max(summary_.growth_max, growth);
    make_contacts();
    make_sample(frame);
    return sample_;
  }

  void publish(const detail::Frame&, const HapticSample& sample) {
    if (sinks_.haptic) sinks_.haptic(sample);
    if (state_.is_resting && !was_resting_ && sinks_.event)
      sinks_.event({time_, frame_, EventKind::at_rest});
  }
  /// Without a duration, and with nobody watching.
  bool has_finished(const HapticSample&) const {
    return config_.duration <= 0.0 && config_.live == nullptr && state_.is_resting;
  }

 private:
  void on_collision(const CollisionEvent& event) {
    if (!sinks_.event || !(event.approach > reported_impact_speed_)) return;
    char text[96];
    std::snprintf(text, sizeof text, "impact at %.3f s: %.3g m/s, %.3g N s", event.time,
                  event.approach, event.impulse.norm());
    sinks_.event({time_, frame_, EventKind::impact, "", text});
  }

  /// Of the simulation's own last query.
  void make_contacts() {
    ContactSet& found = contacts_.scratch.contacts;
    found.contacts.assign(scratch_.contacts.contacts.begin(), scratch_.contacts.contacts.end());
    found.dropped = scratch_.contacts.dropped;
    found.stats = scratch_.contacts.stats;
    ContactSample& sample = contacts_.sample;
    make_model(config_.contact, {state_.body, time_, frame_}, contacts_.scratch, sample);
    sample.query_cpu = sample.step_cpu = counts_.query_cpu;
    detail::record_contacts(time_, contacts_);
    detail::show_contacts(config_.live, config_.contact, time_, contacts_);
    if (sinks_.contact) sinks_.contact(sample);
  }

  void make_sample(const detail::Frame& frame) {
    sample_ = HapticSample{};
    sample_.frame = frame.index;
    sample_.time = sample_.device.time = frame.now;
    sample_.elapsed = frame.elapsed;
    sample_.model_sequence = contacts_.scratch.sequence;
    sample_.body = state_.body;
    sample_.handle.pose = {state_.body.position, state_.body.orientation};
    sample_.contact = mean_contact();
    sample_.penetration = contacts_.sample.depth_max;
    for (const Contact& c : contacts_.scratch.contacts.contacts)
      sample_.touching += -c.depth <= 0.25 * world_.tolerance;
    sample_.step_cpu = 1e-9f * static_cast<float>(frame.cpu_ns);
    sample_.wake_late = 1e-9f * static_cast<float>(std::max<std::int64_t>(frame.wake_late_ns, 0));
    sample_.input_digest = input_digest(sample_);
  }

  /// On the body over the frame.
  Wrench mean_contact() const {
    const Vec3 weight = world_.body.mass * world_.body.gravity;
    if (state_.is_resting) return {-weight, Vec3::Zero()};
    return {config_.rate * (state_.body.linear_momentum - before_.linear_momentum) - weight,
            config_.rate * (state_.body.angular_momentum - before_.angular_momentum)};
  }

  /// Holds but for single frames asked for, or until told to stop. Returns whether the clock stood.
  bool hold_while_paused() {
    bool is_held = false;
    LivePorts* const live = config_.live;
    while (live != nullptr && live->is_paused.load(std::memory_order_relaxed) &&
           !take_step(*live) && !is_stopped()) {
      is_held = true;
      sleep_ns(kPausePoll);
    }
    return is_held;
  }

  const SessionConfig& config_;
  const SimulationWorld& world_;
  SimulationState state_;
  const bool is_paced_;
  const SessionSinks& sinks_;
  const std::atomic<bool>* stop_;
  SimulationScratch scratch_;
  SimulationPorts ports_;
  SimulationCounts counts_;  // of the last frame
  BodyState before_;         // it
  bool was_resting_ = false;
  double time_ = 0.0;  // of the last frame [s]
  std::uint64_t frame_ = 0, next_ = 0;
  HapticSample sample_;
  detail::ContactFrames contacts_;
  detail::FrameRecord record_;
  DeadlineClock clock_;
  SimulatedSummary summary_;
  double reported_impact_speed_ = 0.0;  // speed of an impact worth an event [m/s]
};

}  // namespace

SimulatedSummary run_simulated(const SessionConfig& config, const SimulatedStart& start,
                               bool is_paced, const SessionSinks& sinks,
                               const std::atomic<bool>* stop) {
  detail::check_config(config);
  return std::make_unique<SimulatedShell>(config, start, is_paced, sinks, stop)->run();
}

}  // namespace thigma
