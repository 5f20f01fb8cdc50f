// A session in the calling thread, on a virtual clock: frame k happens at k / rate, whatever the
// computer does.

#include <deque>
#include <memory>

#include "thigma/device/open_device.h"
#include "thigma/session/detail/check_config.h"
#include "thigma/session/detail/contact_frames.h"
#include "thigma/session/detail/event_detector.h"
#include "thigma/session/detail/frame_driver.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/session.h"

namespace thigma {
namespace {

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

/// The shell of a lockstep session (detail/frame_driver.h). A contact step is made now and then,
/// its model is in use some frames later.
class LockstepShell {
 public:
  LockstepShell(const SessionConfig& config, HapticDevice& device, const SessionSinks& sinks,
                const std::atomic<bool>* stop)
      : config_(config),
        device_(device),
        sinks_(sinks),
        stop_(stop),
        params_(config.haptic),
        events_(sinks.event, detail::deep_contact_limits(config)) {
    use_device_limits(device.limits(), params_);
    state_ = initial_state(params_, config.world_from_body);
    reserve_contact_scratch(config.contact, contacts_.scratch);
    contact_step({state_.body, 0.0, 0}, 0.0, 0);  // the first frame has a model
  }

  SessionSummary run() {
    const SessionEnd end = detail::drive_frames(config_, *this, record_);
    SessionSummary summary = summarize(config_, record_.statistics, contacts_.statistics, state_);
    summary.end = end;
    summary.force_steps = force_steps_;
    summary.safety_events = events_.take_safety_events();
    summary.notes = events_.texts();
    if (const std::string trouble = device_.trouble(); !trouble.empty())
      detail::add_note(device_.name() + ": " + trouble, trouble, summary.notes);
    return summary;
  }

  /// The contact step of the frame before comes first.
  detail::FrameTick next_tick() {
    if (has_frame_) follow_contacts();
    has_frame_ = false;
    return {next_++};
  }
  std::int64_t cpu_ns() const { return thread_cpu_ns(); }
  bool is_stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

  /// What the watchdog of a threaded session does, at the frame where it would.
  bool hang(const FaultEvent& fault, double now) {
    if (now - fault.time < detail::effective_watchdog(config_)) return true;
    device_.write(Wrench{});
    external_ = Fault::watchdog;
    return true;
  }

  void prepare(const detail::Frame& frame) {
    while (!pending_.empty() && pending_.front().from_frame <= frame.index) {
      models_.publish(pending_.front().model);
      pending_.pop_front();
    }
  }

  void step(const detail::Frame& frame) {
    sample_ = haptic_step(params_, {&device_, &models_, &bodies_, nullptr, monotonic_ns},
                          {frame.now, frame.elapsed, external_}, state_);
  }
  const HapticSample& sample(const detail::Frame&) const { return sample_; }

  void publish(const detail::Frame& frame, const HapticSample& sample) {
    detail::note_times(frame, state_);
    if (params_.safety.rides_out_gaps) external_ = Fault::none;  // once a gap
    force_steps_.observe(sample);
    if (sinks_.haptic) sinks_.haptic(sample);
    events_.observe(sample, static_cast<double>(record_.longest_gap) / config_.rate,
                    device_.trouble());
    has_frame_ = true;
  }
  bool has_finished(const HapticSample& sample) const {
    return sample.device.status == DeviceStatus::finished;
  }

 private:
  void follow_contacts() {
    const std::uint64_t frame = record_.previous;
    if (frame % static_cast<std::uint64_t>(config_.contact_every) != 0) return;
    if (active_fault(config_.faults, InjectedFault::stall, sample_.time) != nullptr) return;
    bodies_.fetch();
    contact_step(bodies_.value(), sample_.time,
                 frame + static_cast<std::uint64_t>(config_.contact_latency));
  }

  void contact_step(const StampedBody& body, double now, std::uint64_t use_from) {
    detail::timed_contact_step(config_.contact, body, contacts_);
    detail::record_contacts(now, contacts_);
    detail::show_contacts(config_.live, config_.contact, body.time, contacts_);
    force_steps_.observe(contacts_.sample);
    events_.observe(contacts_.sample);
    if (sinks_.contact) sinks_.contact(contacts_.sample);
    pending_.push_back({use_from, contacts_.sample.model});
  }

  struct PendingModel {
    std::uint64_t from_frame = 0;
    LinearContactModel model;
  };

  const SessionConfig& config_;
  HapticDevice& device_;
  const SessionSinks& sinks_;
  const std::atomic<bool>* stop_;
  HapticParams params_;
  HapticState state_;
  HapticSample sample_;  // of the last step
  detail::FrameRecord record_;
  detail::ContactFrames contacts_;
  std::deque<PendingModel> pending_;
  Latest<LinearContactModel> models_;
  Latest<StampedBody> bodies_;
  ForceSteps force_steps_;
  detail::EventDetector events_;
  std::uint64_t next_ = 0;        // frame
  bool has_frame_ = false;        // one was made that no contact step has followed yet
  Fault external_ = Fault::none;  // for the next step
};

}  // namespace

SessionSummary run_lockstep(const SessionConfig& config, HapticDevice& device,
                            const SessionSinks& sinks, const std::atomic<bool>* stop) {
  detail::check_config(config);
  detail::check_coupling(config);
  if (device.limits().clock == DeviceClock::device)
    throw DeviceUnavailable(device.name() + ": sets the pace by its own clock, which --lockstep " +
                            "cannot follow, expected a run without it");
  if (device.limits().holds_person)
    throw DeviceUnavailable(device.name() + ": " + kNoPersonOffClock);
  const std::unique_ptr<HapticDevice> faulty = make_faulty_device(device, config.faults);
  const ZeroForceOnExit zero_force(*faulty);
  return std::make_unique<LockstepShell>(config, *faulty, sinks, stop)->run();
}

}  // namespace thigma
