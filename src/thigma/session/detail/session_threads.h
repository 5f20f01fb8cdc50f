#pragma once
// The threads of a session: a haptic thread that keeps time, a contact thread that does what it
// can, a watchdog that looks after the first, and a drain that hands samples to whoever wants them.
// Two Latest and two rings are all they share. The haptic thread is in haptic_thread.cpp, or,
// where a device owns the clock, in device_ticks.cpp; the others are in helper_threads.cpp.

#include <algorithm>
#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "thigma/session/detail/check_config.h"
#include "thigma/session/detail/contact_frames.h"
#include "thigma/session/detail/device_token.h"
#include "thigma/session/detail/event_detector.h"
#include "thigma/session/detail/frame_driver.h"
#include "thigma/session/detail/timed_device.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/session.h"

namespace thigma {
struct Session::Impl {
  Impl(SessionConfig config_in, HapticDevice& device_in, SessionSinks sinks_in)
      : config(std::move(config_in)),
        sinks(std::move(sinks_in)),
        driver(device_in),
        faulty(make_faulty_device(device_in, config.faults)),
        device(std::make_unique<detail::TimedDevice>(*faulty)),
        params(config.haptic),
        haptic_ring(std::max<std::size_t>(config.telemetry_frames, 1)),
        contact_ring(std::max<std::size_t>(config.telemetry_models, 1)),
        events(sinks.event, detail::deep_contact_limits(config)) {
    use_device_limits(device_in.limits(), params);
    is_device_paced = device_in.limits().clock == DeviceClock::device;
    watchdog_ns = to_ns(detail::effective_watchdog(config));
    state = initial_state(params, config.world_from_body);
    ports = {device.get(), &models, &bodies, &haptic_ring, monotonic_ns};
  }

  void prepare_memory();
  void start_threads();
  void join_threads();
  void run_haptic();
  void run_beside_device();
  void start_device();
  void device_tick() noexcept;
  void take_over();
  detail::FrameTick next_device_tick();
  void run_contact();
  void run_watchdog();
  void run_drain();
  void contact_frame(const StampedBody& body, double now);
  void follow_live(double now);
  void drain();
  void note_gap();
  std::int64_t behind() const;
  void hold_while_paused();
  void end_with_zero_force();
  void note(const std::string& text);

  // The shell of the frame driver (detail/frame_driver.h).
  detail::FrameTick next_tick();
  // A system call, which nothing of ours makes in the vendor's thread.
  std::int64_t cpu_ns() const { return is_device_paced ? -1 : thread_cpu_ns(); }
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
  HapticDevice& driver;  // the device itself; the others stand before it
  const std::unique_ptr<HapticDevice> faulty;
  const std::unique_ptr<detail::TimedDevice> device;
  HapticParams params;
  HapticPorts ports;

  // Haptic thread only, while it runs. Where the device owns the clock that is its own thread,
  // within the token; once the ticks are over, the session's.
  bool is_device_paced = false;  // frames are made in ticks of the device; read within the token
  bool are_ticks_over = false;   // what still ticks sends zero
  std::int64_t first_tick_ns = 0, last_tick_ns = 0;
  std::uint64_t ticks = 0;
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
  double levels_since = -1.0;   // session time at which levels came that fade in; below 0: none do
  Resolution asked_resolution;  // what they fade in to

  // Shared.
  Latest<LinearContactModel> models;
  Latest<StampedBody> bodies;
  SpscRing<HapticSample> haptic_ring;
  SpscRing<ContactSample> contact_ring;
  detail::DeviceToken token;
  std::atomic<bool> should_stop{false};
  std::atomic<bool> haptic_done{false};
  std::atomic<bool> have_ticks_ended{false};
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
  bool is_started = false, was_started = false;  // runs, or finish() has to be called; ever
};

}  // namespace thigma
