// The contact thread, the watchdog and the drain of a session.

#include <algorithm>
#include <exception>

#include "thigma/session/detail/session_threads.h"

namespace thigma {

void Session::Impl::contact_frame(const StampedBody& body, double now) {
  if (config.live != nullptr) follow_live(body.time);
  detail::timed_contact_step(config.contact, body, contacts);
  detail::record_contacts(now, contacts);
  contact_ring.push(contacts.sample);  // before the model: whoever sees it used finds it here
  models.publish(contacts.sample.model);
  detail::show_contacts(config.live, config.contact, body.time, contacts);
}

/// What watchers have changed since the frame before: gains, surfaces.
void Session::Impl::follow_live(double now) {
  LivePorts& live = *config.live;
  const bool is_fading = levels_since >= 0.0;
  if (live.contact_tuning.fetch()) {
    apply_tuning(live.contact_tuning.value(), config.contact);
    asked_resolution = config.contact.resolution;
  }
  if (ContactReplacement* other = live.replacement.load(std::memory_order_acquire)) {
    const Resolution asked = config.contact.resolution;
    exchange_contacts(*other, config.contact, contacts.scratch);
    // As it was tuned meanwhile; exact or not is the surfaces' own.
    asked_resolution = is_fading ? asked_resolution : asked;
    asked_resolution.is_exact = config.contact.resolution.is_exact;
    levels_since = now;
    live.replacement.store(nullptr, std::memory_order_release);
  }
  if (levels_since < 0.0) return;
  const double share = (now - levels_since) / kLevelsFadeIn;
  config.contact.resolution = faded_in(asked_resolution, share);
  if (share >= 1.0) levels_since = -1.0;
}

void Session::Impl::run_contact() {
  const RtGrant grant = request_real_time(config.contact_thread);
  if (config.contact_thread.priority > 0)
    note(grant.refused.empty() ? "" : "contact thread: " + grant.refused);
  bool has_stalled = false;
  // The haptic thread may not wake this one: that would be a system call.
  const std::int64_t period = std::max<std::int64_t>(1, to_ns(1.0 / config.rate));
  std::int64_t expected = 0;
  while (!haptic_done.load(std::memory_order_acquire)) {
    if (!bodies.fetch()) {
      sleep_ns(look_again_in(monotonic_ns(), expected, period));
      continue;
    }
    expected = monotonic_ns() + period;
    const StampedBody& body = bodies.value();
    if (const FaultEvent* stall = active_fault(config.faults, InjectedFault::stall, body.time);
        stall != nullptr && !has_stalled) {
      has_stalled = true;
      sleep_ns(to_ns(stall->duration));
    }
    const std::int64_t begin = monotonic_ns();
    contact_frame(body,
                  1e-9 * static_cast<double>(begin - epoch_ns.load(std::memory_order_acquire)));
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
    // Not as long as a limit of an hour allows: whoever ends the session waits for this.
    sleep_ns(std::min<std::int64_t>(limit / 20, 50'000'000));
    if (noted_step(last_step_ns).ago <= limit) continue;
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
      events.observe(*sample);
      if (sinks.contact) sinks.contact(*sample);
      contact_ring.pop();
    }
  };
  while (const HapticSample* sample = haptic_ring.front()) {
    drain_contacts();
    force_steps.observe(*sample);
    if (sinks.haptic) sinks.haptic(*sample);
    events.observe(*sample,
                   1e-9 * static_cast<double>(longest_gap_ns.load(std::memory_order_acquire)),
                   driver.trouble());
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

}  // namespace thigma
