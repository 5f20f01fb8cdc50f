// The threaded session: a haptic thread that keeps time, a contact thread that does what it can, a
// watchdog that looks after the first, and a drain that hands samples to whoever wants them. Two
// Latest and two rings are all they share.

#include "thigma/session/session.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "thigma/session/detail/check_config.h"
#include "thigma/session/detail/contact_frames.h"
#include "thigma/session/detail/event_detector.h"
#include "thigma/session/detail/frame_driver.h"
#include "thigma/session/detail/session_summary.h"
#include "thigma/session/detail/timed_device.h"
#include "thigma/session/live_ports.h"

namespace thigma {
namespace {

/// Who may talk to the device. The haptic thread holds it during a step, the watchdog while it
/// sends zero.
class DeviceToken {
 public:
  bool try_take() noexcept { return !is_taken_.exchange(true, std::memory_order_acquire); }
  void give_back() noexcept { is_taken_.store(false, std::memory_order_release); }

 private:
  std::atomic<bool> is_taken_{false};
};

}  // namespace

struct Session::Impl {
  Impl(SessionConfig config_in, HapticDevice& device_in, SessionSinks sinks_in)
      : config(std::move(config_in)),
        sinks(std::move(sinks_in)),
        faulty(make_faulty_device(device_in, config.faults)),
        device(std::make_unique<detail::TimedDevice>(*faulty)),
        params(config.haptic),
        haptic_ring(std::max<std::size_t>(config.telemetry_frames, 1)),
        contact_ring(std::max<std::size_t>(config.telemetry_models, 1)),
        events(sinks.event, detail::deep_contact_limits(config)) {
    use_device_limits(device_in.limits(), params);
    watchdog_ns = to_ns(detail::effective_watchdog(config));
    state = initial_state(params, config.world_from_body);
    ports = {device.get(), &models, &bodies, &haptic_ring};
  }

  void prepare_memory();
  void start_threads();
  void join_threads();
  void run_haptic();
  void run_contact();
  void run_watchdog();
  void run_drain();
  void contact_frame(const StampedBody& at, double now);
  void drain();
  void note_gap();
  std::int64_t behind() const;
  void hold_while_paused();
  void end_with_zero_force();
  void note(const std::string& text);

  // The shell of the frame driver (detail/frame_driver.h).
  detail::FrameTick next_tick();
  bool is_stopped() const { return should_stop.load(std::memory_order_relaxed); }
  bool hang(const FaultEvent& fault, double now);
  void prepare(const detail::Frame& frame);
  void step(const detail::Frame& frame);
  const HapticSample& sample(const detail::Frame&) const { return made; }
  void publish(const detail::Frame& frame, const HapticSample& sample);
  bool has_finished(const HapticSample& sample) const {
    return sample.device.status == DeviceStatus::finished;
  }

  SessionConfig config;  // constant but for .contact, the contact thread's while it runs
  const SessionSinks sinks;
  const std::unique_ptr<HapticDevice> faulty;
  const std::unique_ptr<detail::TimedDevice> device;
  HapticParams params;
  HapticPorts ports;

  // Haptic thread only, while it runs.
  HapticState state;
  HapticSample made;  // by the last step
  detail::FrameRecord record;
  DeadlineClock clock;
  std::int64_t watchdog_ns = 0;  // constant
  // Of the last step, which may have hung in the device: asked for, begun with the token, over.
  std::int64_t step_asked = 0, step_taken = 0, step_end = 0;
  std::int64_t hang_late_ns = 0;  // how late an injected hang made the frame it hit
  bool has_hung = false;          // as asked
  SessionEnd end = SessionEnd::duration;

  // Contact thread only, while it runs.
  detail::ContactFrames contacts;

  // Shared.
  Latest<LinearContactModel> models;
  Latest<StampedBody> bodies;
  SpscRing<HapticSample> haptic_ring;
  SpscRing<ContactSample> contact_ring;
  DeviceToken token;
  std::atomic<bool> should_stop{false};
  std::atomic<bool> haptic_done{false};
  std::atomic<bool> contact_done{false};
  std::atomic<bool> watchdog_fired{false};
  std::atomic<std::int64_t> last_step_ns{0};    // 0: not stepping
  std::atomic<std::int64_t> longest_gap_ns{0};  // between two steps, or the start and the first
  std::atomic<std::int64_t> epoch_ns{0};        // of session time 0

  // Drain thread only, while it runs.
  detail::EventDetector events;
  ForceSteps force_steps;
  std::exception_ptr sink_error;

  std::mutex notes_mutex;  // start-up and shut-down only
  std::vector<std::string> notes;
  std::thread haptic_thread, contact_thread, watchdog_thread, drain_thread;
  bool is_started = false;
};

void Session::Impl::note(const std::string& text) {
  if (text.empty()) return;
  const std::lock_guard lock(notes_mutex);
  notes.push_back(text);
}

void Session::Impl::contact_frame(const StampedBody& at, double now) {
  if (config.live != nullptr && config.live->contact_tuning.fetch())
    apply_tuning(config.live->contact_tuning.value(), config.contact);
  detail::timed_contact_step(config.contact, at, contacts);
  detail::record_contacts(now, contacts);
  contact_ring.push(contacts.sample);  // before the model: whoever sees it used finds it here
  models.publish(contacts.sample.model);
  detail::show_contacts(config.live, config.contact, at.time, contacts);
}

/// Everything that is slow the first time, before a thread depends on it.
void Session::Impl::prepare_memory() {
  reserve_contact_scratch(config.contact, contacts.scratch);
  contact_frame({state.body, 0.0, 0}, 0.0);
  clock = clock_of(config.rate, config.spin);
}

/// How long the last step is ago, for whoever wants to know why the watchdog acted. Thread
/// [haptic].
void Session::Impl::note_gap() {
  const std::int64_t gap = monotonic_ns() - last_step_ns.load(std::memory_order_relaxed);
  if (gap > longest_gap_ns.load(std::memory_order_relaxed))
    longest_gap_ns.store(gap, std::memory_order_release);
}

/// Session time stands still until the pause ends, a single frame is asked for or the session ends.
/// Only simulated devices are paused (docs/protocol.md): nothing pulls at a hand meanwhile.
void Session::Impl::hold_while_paused() {
  LivePorts* live = config.live;
  if (live == nullptr || !live->is_paused.load(std::memory_order_relaxed)) return;
  const std::int64_t begin = monotonic_ns();
  last_step_ns.store(0, std::memory_order_release);  // nothing to watch
  while (live->is_paused.load(std::memory_order_relaxed) && !take_step(*live) &&
         !should_stop.load(std::memory_order_relaxed)) {
    sleep_ns(1'000'000);
  }
  const std::int64_t resumed = monotonic_ns();
  clock.start_ns += resumed - begin;
  epoch_ns.store(clock.start_ns, std::memory_order_release);
  last_step_ns.store(resumed, std::memory_order_release);
}

/// How long ago the present tick was [ns].
std::int64_t Session::Impl::behind() const {
  return monotonic_ns() - (clock.start_ns + (clock.tick - 1) * clock.period_ns);
}

/// Waits for the next tick. One that was slept through for longer than the watchdog waits is left
/// out: its step would stamp what the watchdog did with a time before it.
detail::FrameTick Session::Impl::next_tick() {
  std::int64_t late = wait_for_tick(clock);
  hold_while_paused();
  constexpr int kMostAgain = 10;  // a machine that is always late is to be told of as well
  for (int again = 0; again < kMostAgain && behind() > watchdog_ns; ++again) {
    late = std::max(late, behind());
    ++clock.missed;
    wait_for_tick(clock);
  }
  late = std::max(late, std::exchange(hang_late_ns, 0));
  return {static_cast<std::uint64_t>(clock.tick - 1), late};
}

/// Sleeps, once. A frame that the watchdog has acted in is left out, as in next_tick.
bool Session::Impl::hang(const FaultEvent& fault, double) {
  if (has_hung) return false;
  has_hung = true;
  sleep_ns(to_ns(fault.duration));
  hang_late_ns = behind();
  if (hang_late_ns <= watchdog_ns) {
    hang_late_ns = 0;
    return false;
  }
  ++clock.missed;
  return true;
}

void Session::Impl::prepare(const detail::Frame&) {
  if (config.live != nullptr && config.live->haptic_tuning.fetch())
    apply_tuning(config.live->haptic_tuning.value(), params, state);
}

void Session::Impl::step(const detail::Frame& frame) {
  const std::int64_t asked = monotonic_ns();
  while (!token.try_take()) sleep_ns(20'000);  // only while the watchdog is sending zero
  HapticTick tick{frame.now, frame.elapsed, Fault::none};
  const std::int64_t begin = monotonic_ns();
  const std::int64_t gap = begin - last_step_ns.load(std::memory_order_relaxed);
  note_gap();
  // Ridden out, a gap is reported once, by the one who was late: the watchdog may have been late as
  // well.
  const std::int64_t last = step_end - step_taken;
  const std::int64_t skipped = to_ns(tick.now - state.time);
  const bool is_late = params.safety.rides_out_gaps
                           ? std::max({gap, last, skipped}) > watchdog_ns
                           : watchdog_fired.load(std::memory_order_acquire);
  if (is_late) tick.external_fault = Fault::watchdog;
  made = haptic_step(params, ports, tick, state);
  step_asked = asked;
  step_taken = begin;
  step_end = monotonic_ns();
  token.give_back();
}

/// Thread [haptic]. The sample is in its ring already.
void Session::Impl::publish(const detail::Frame& frame, const HapticSample&) {
  note_gap();  // again: a step may have hung in the device
  last_step_ns.store(monotonic_ns(), std::memory_order_release);
  accumulate(record.statistics,
             {.device_read = device->read_ns,
              .device_write = device->write_ns,
              .whole = step_end - step_asked,
              .is_overrun = step_end > clock.start_ns + clock.tick * clock.period_ns});
  detail::note_times(frame, state);
}

void Session::Impl::end_with_zero_force() {
  while (!token.try_take()) sleep_ns(20'000);
  device->write(Wrench{});
  last_step_ns.store(0, std::memory_order_release);  // nothing to watch any more
  token.give_back();
}

void Session::Impl::run_haptic() {
  note(request_real_time(config.haptic_thread).refused);
  start_clock(clock);
  epoch_ns.store(clock.start_ns, std::memory_order_release);
  last_step_ns.store(monotonic_ns(), std::memory_order_release);  // watched from here on
  end = detail::drive_frames(config, *this, record);
  end_with_zero_force();
  haptic_done.store(true, std::memory_order_release);
}

void Session::Impl::run_contact() {
  const RtGrant grant = request_real_time(config.contact_thread);
  if (config.contact_thread.priority > 0)
    note(grant.refused.empty() ? "" : "contact thread: " + grant.refused);
  bool has_stalled = false;
  while (!haptic_done.load(std::memory_order_acquire)) {
    if (!bodies.fetch()) {
      sleep_ns(50'000);
      continue;
    }
    const StampedBody& at = bodies.value();
    if (const FaultEvent* stall = active_fault(config.faults, InjectedFault::stall, at.time);
        stall != nullptr && !has_stalled) {
      has_stalled = true;
      sleep_ns(to_ns(stall->duration));
    }
    const std::int64_t begin = monotonic_ns();
    contact_frame(at, 1e-9 * static_cast<double>(begin - epoch_ns.load(std::memory_order_acquire)));
    // A real-time thread that never rests is put to sleep by the kernel for 50 ms each second;
    // better a little often.
    if (grant.is_fifo) sleep_ns((monotonic_ns() - begin) / 8);
  }
  contact_done.store(true, std::memory_order_release);
}

void Session::Impl::run_watchdog() {
  // Above the haptic thread: it must run when that one never gives way.
  request_real_time(
      {config.haptic_thread.priority > 0 ? std::min(config.haptic_thread.priority + 1, 99) : 0,
       -1});
  const std::int64_t limit = watchdog_ns;
  while (!haptic_done.load(std::memory_order_acquire)) {
    sleep_ns(limit / 20);
    const std::int64_t last = last_step_ns.load(std::memory_order_acquire);
    if (last == 0 || monotonic_ns() - last <= limit) continue;
    watchdog_fired.store(true, std::memory_order_release);
    // Stuck inside a step the haptic thread keeps the token: two threads in one driver would be
    // worse than one.
    if (!token.try_take()) continue;
    // Past the stop-watch, which belongs to the haptic thread.
    if (last_step_ns.load(std::memory_order_acquire) != 0) faulty->write(Wrench{});
    token.give_back();
  }
}

void Session::Impl::drain() {
  const auto drain_contacts = [this] {
    while (const ContactSample* sample = contact_ring.front()) {
      force_steps.observe(*sample);
      if (sinks.contact) sinks.contact(*sample);
      contact_ring.pop();
    }
  };
  while (const HapticSample* sample = haptic_ring.front()) {
    drain_contacts();
    force_steps.observe(*sample);
    if (sinks.haptic) sinks.haptic(*sample);
    events.observe(*sample,
                   1e-9 * static_cast<double>(longest_gap_ns.load(std::memory_order_acquire)));
    haptic_ring.pop();
  }
  drain_contacts();
}

void Session::Impl::run_drain() {
  try {
    while (!haptic_done.load(std::memory_order_acquire) ||
           !contact_done.load(std::memory_order_acquire)) {
      drain();
      sleep_ns(2'000'000);
    }
    drain();
  } catch (...) {
    // A sink failed, as on a full disk: the session ends in order, finish() passes the reason on.
    sink_error = std::current_exception();
    should_stop.store(true, std::memory_order_relaxed);
  }
}

void Session::Impl::start_threads() {
  // From the last to be needed to the first, so that the haptic thread finds all others running.
  try {
    drain_thread = std::thread([this] { run_drain(); });
    watchdog_thread = std::thread([this] { run_watchdog(); });
    contact_thread = std::thread([this] { run_contact(); });
    haptic_thread = std::thread([this] { run_haptic(); });
  } catch (...) {
    haptic_done.store(true, std::memory_order_release);
    contact_done.store(true, std::memory_order_release);
    join_threads();
    throw;
  }
}

void Session::Impl::join_threads() {
  for (std::thread* thread : {&haptic_thread, &contact_thread, &watchdog_thread, &drain_thread}) {
    if (thread->joinable()) thread->join();
  }
}

Session::Session(SessionConfig config, HapticDevice& device, SessionSinks sinks)
    : impl_(std::make_unique<Impl>(std::move(config), device, std::move(sinks))) {}

Session::~Session() {
  if (!impl_->is_started) return;
  request_stop();
  try {
    finish();
  } catch (...) {  // of a sink; who wanted to know called finish()
  }
}

void Session::start() {
  Impl& s = *impl_;
  if (s.is_started) throw std::logic_error("session: started twice");
  detail::check_config(s.config);
  s.prepare_memory();
  s.start_threads();
  s.is_started = true;
}

void Session::request_stop() noexcept { impl_->should_stop.store(true, std::memory_order_relaxed); }

bool Session::is_running() const noexcept {
  return impl_->is_started && !impl_->haptic_done.load(std::memory_order_acquire);
}

SessionSummary Session::finish() {
  Impl& s = *impl_;
  if (!s.is_started) throw std::logic_error("session: finish without start");
  s.is_started = false;
  s.join_threads();
  if (s.sink_error) std::rethrow_exception(s.sink_error);
  SessionSummary summary =
      detail::summarize(s.config, s.record.statistics, s.contacts.statistics, s.state);
  summary.end = s.end;
  summary.seconds = s.record.time;
  summary.force_steps = s.force_steps;
  summary.missed = s.clock.missed;
  const std::int64_t whole = std::max<std::int64_t>(1, s.clock.tick * s.clock.period_ns);
  summary.deadlines.polled_share =
      static_cast<double>(s.clock.polled_ns) / static_cast<double>(whole);
  summary.dropped_samples = s.haptic_ring.dropped() + s.contact_ring.dropped();
  summary.safety_events = s.events.take_safety_events();
  summary.notes = s.notes;
  summary.notes.insert(summary.notes.end(), s.events.texts().begin(), s.events.texts().end());
  return summary;
}

}  // namespace thigma
