// A session in the calling thread, on a virtual clock: frame k happens at k / rate, whatever the
// computer does.

#include <algorithm>
#include <cmath>
#include <deque>

#include "thigma/session/detail/session_parts.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/session.h"

namespace thigma {
namespace {

using detail::EventDetector;

/// Zero force on every way out, exceptions of sinks included.
class ZeroForceOnExit {
 public:
  explicit ZeroForceOnExit(HapticDevice& device) : device_(device) {}
  ~ZeroForceOnExit() { device_.write(Wrench{}); }
  ZeroForceOnExit(const ZeroForceOnExit&) = delete;
  ZeroForceOnExit& operator=(const ZeroForceOnExit&) = delete;

 private:
  HapticDevice& device_;
};

/// The contact thread of a lockstep session: a step now and then, its model in use some frames
/// later.
struct LockstepContacts {
  const SessionConfig& config;
  const SessionSinks& sinks;
  ContactScratch scratch;
  ContactStatistics tally;
  ContactSample sample;
  ForceSteps force_steps;
  struct Pending {
    std::uint64_t from_frame = 0;
    LinearContactModel model;
  };
  std::deque<Pending> pending;

  void step(const StampedBody& at, double now, std::uint64_t use_from) {
    detail::timed_contact_step(config, at, scratch, sample);
    sample.published = now;
    thigma::accumulate(tally, sample);
    if (config.live != nullptr) {
      view_contacts(config.contact, scratch, at.time, config.live->contacts.draft());
      config.live->contacts.publish();
    }
    force_steps.observe(sample);
    if (sinks.contact) sinks.contact(sample);
    pending.push_back({use_from, sample.model});
  }

  void publish_due(std::uint64_t frame, Latest<LinearContactModel>& models) {
    while (!pending.empty() && pending.front().from_frame <= frame) {
      models.publish(pending.front().model);
      pending.pop_front();
    }
  }
};

/// Ticks until something ends the session; returns what.
SessionEnd run_frames(const SessionConfig& config, const HapticParams& params,
                      const HapticPorts& ports, const SessionSinks& sinks,
                      const std::atomic<bool>* stop, HapticState& state,
                      HapticStatistics& haptic_tally, LockstepContacts& contacts,
                      EventDetector& events) {
  const std::uint64_t last = detail::frame_limit(config);
  const auto fault_frames = static_cast<std::uint64_t>(std::ceil(config.after_fault * config.rate));
  std::uint64_t previous = 0, fault_frame = 0, longest_gap = 0;
  Fault external = Fault::none;
  for (std::uint64_t k = 0; k < last; ++k) {
    if (stop != nullptr && stop->load(std::memory_order_relaxed)) return SessionEnd::stopped;
    const double now = static_cast<double>(k) / config.rate;
    if (const FaultEvent* hang = active_fault(config.faults, InjectedFault::hang, now)) {
      // What the watchdog of a threaded session does, at the frame where it would.
      if (now - hang->time >= detail::effective_watchdog(config)) {
        ports.device->write(Wrench{});
        external = Fault::watchdog;
      }
      continue;
    }
    contacts.publish_due(k, *ports.models);
    const double elapsed = detail::step_length(config, k - previous);
    const std::int64_t begin = thread_cpu_ns();
    const HapticSample sample = haptic_step(params, ports, {now, elapsed, external}, state);
    const std::int64_t cpu = thread_cpu_ns() - begin;
    accumulate(haptic_tally, sample, cpu, -1);
    state.step_cpu = static_cast<float>(1e-9 * static_cast<double>(cpu));
    if (params.safety.rides_out_gaps) external = Fault::none;  // told once a gap
    longest_gap = std::max(longest_gap, k - previous);
    previous = k;
    contacts.force_steps.observe(sample);
    if (sinks.haptic) sinks.haptic(sample);
    events.observe(sample, static_cast<double>(longest_gap) / config.rate);
    if (sample.fault != Fault::none && !is_resumable(params, sample.fault)) {
      if (fault_frame == 0) fault_frame = k + 1;
      if (k + 1 - fault_frame >= fault_frames) return SessionEnd::fault;
    }
    if (sample.device.status == DeviceStatus::finished) return SessionEnd::device_finished;
    const bool is_contact_frame = k % static_cast<std::uint64_t>(config.contact_every) == 0;
    if (is_contact_frame && active_fault(config.faults, InjectedFault::stall, now) == nullptr) {
      ports.bodies->fetch();
      contacts.step(ports.bodies->value(), now,
                    k + static_cast<std::uint64_t>(config.contact_latency));
    }
  }
  const bool is_fault =
      state.safety.fault != Fault::none && !is_resumable(params, state.safety.fault);
  return is_fault ? SessionEnd::fault : SessionEnd::duration;
}

}  // namespace

SessionSummary run_lockstep(const SessionConfig& config, HapticDevice& device,
                            const SessionSinks& sinks, const std::atomic<bool>* stop) {
  detail::check_config(config);
  const std::unique_ptr<HapticDevice> faulty = make_faulty_device(device, config.faults);
  const ZeroForceOnExit zero_force(*faulty);
  HapticParams params = config.haptic;
  use_device_limits(device.limits(), params);

  const auto models = std::make_unique<Latest<LinearContactModel>>();
  const auto bodies = std::make_unique<Latest<StampedBody>>();
  const HapticPorts ports{faulty.get(), models.get(), bodies.get(), nullptr};
  HapticState state = initial_state(params, config.world_from_body);
  const auto haptic_tally = std::make_unique<HapticStatistics>();
  const auto contacts = std::make_unique<LockstepContacts>(config, sinks);
  reserve_contact_scratch(config.contact, contacts->scratch);
  EventDetector events(sinks.event, detail::deep_contact_limits(config));

  contacts->step({state.body, 0.0, 0}, 0.0, 0);  // the first frame has a model
  const SessionEnd end =
      run_frames(config, params, ports, sinks, stop, state, *haptic_tally, *contacts, events);

  SessionSummary summary = detail::summarize(config, *haptic_tally, contacts->tally, state);
  summary.end = end;
  summary.force_steps = contacts->force_steps;
  summary.safety_events = events.take_safety_events();
  summary.notes = events.texts();
  return summary;
}

}  // namespace thigma
