// The haptic thread of a session: the shell of the frame driver (frame_driver.h) that keeps time.

#include <algorithm>
#include <utility>

#include "thigma/session/detail/session_threads.h"

namespace thigma {

/// How long the last step is ago, for whoever wants to know why the watchdog acted. Thread
/// [haptic].
void Session::Impl::note_gap() {
  const std::int64_t gap = monotonic_ns() - last_step_ns.load(std::memory_order_relaxed);
  if (gap > longest_gap_ns.load(std::memory_order_relaxed))
    longest_gap_ns.store(gap, std::memory_order_release);
}

/// Session time stands still until the pause ends, a single frame is asked for or the session ends.
/// A device that holds a person is not paused: nothing would be written to its motors meanwhile,
/// nor watched.
void Session::Impl::hold_while_paused() {
  LivePorts* live = config.live;
  if (live == nullptr || params.device.holds_person) return;
  if (!live->is_paused.load(std::memory_order_relaxed)) return;
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
  if (is_device_paced) return next_device_tick();
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
  if (is_device_paced) {  // as a tick that does not come; the session may take over meanwhile
    token.give_back();
    sleep_ns(to_ns(fault.duration));
    token.take();
    return true;
  }
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
  if (!is_device_paced) token.take();
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
  if (!is_device_paced) token.give_back();
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
  token.take();
  device->write(Wrench{});
  last_step_ns.store(0, std::memory_order_release);  // nothing to watch any more
  token.give_back();
}

void Session::Impl::run_haptic() {
  if (is_device_paced) return run_beside_device();
  note(request_real_time(config.haptic_thread).refused);
  start_clock(clock);
  epoch_ns.store(clock.start_ns, std::memory_order_release);
  last_step_ns.store(monotonic_ns(), std::memory_order_release);  // watched from here on
  end = detail::drive_frames(config, *this, record);
  end_with_zero_force();
  haptic_done.store(true, std::memory_order_release);
}

}  // namespace thigma
