// A session on threads (detail/session_threads.h): its start and its end.

#include "thigma/session/session.h"

#include <stdexcept>

#include "thigma/session/detail/session_threads.h"

namespace thigma {

void Session::Impl::note(const std::string& text) {
  if (text.empty()) return;
  const std::lock_guard lock(notes_mutex);
  notes.push_back(text);
}

/// Everything that is slow the first time, before a thread depends on it.
void Session::Impl::prepare_memory() {
  reserve_contact_scratch(config.contact, contacts.scratch);
  contact_frame({state.body, 0.0, 0}, 0.0);
  clock = clock_of(config.rate, config.spin);
}

void Session::Impl::start_threads() {
  // From the last to be needed to the first, so that the haptic thread finds all others running.
  try {
    drain_thread = std::thread([this] { run_drain(); });
    watchdog_thread = std::thread([this] { run_watchdog(); });
    contact_thread = std::thread([this] { run_contact(); });
    if (is_device_paced) start_device();
    haptic_thread = std::thread([this] { run_haptic(); });
  } catch (...) {
    driver.stop_ticks();
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
  if (s.was_started) throw std::logic_error("session: started twice");
  detail::check_config(s.config);
  detail::check_coupling(s.config);
  s.prepare_memory();
  s.was_started = true;  // what ends threads stays set, also where starting them fails
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
  SessionSummary summary = summarize(s.config, s.record.statistics, s.contacts.statistics, s.state);
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
  if (const std::string trouble = s.driver.trouble(); !trouble.empty())
    detail::add_note(s.driver.name() + ": " + trouble, trouble, summary.notes);
  return summary;
}

}  // namespace thigma
