#pragma once
// A session: the two steps run together, on threads or in lockstep on a virtual clock.

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/loop/contact_world.h"
#include "thigma/loop/haptic_params.h"
#include "thigma/loop/samples.h"
#include "thigma/session/fault_injection.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/session_summary.h"

namespace thigma {

struct LivePorts;

/// Of the grasped object's radius: deeper contacts on an old model raise the event deep_contact.
inline constexpr double kDeepShare = 0.05;

/// Everything a session needs but the device. Constant while it runs; hierarchies outlive it.
struct SessionConfig {
  HapticParams haptic;  // haptic.device is filled in from the device
  ContactWorld contact;
  Pose world_from_body;   // of the centre of mass at the start
  double rate = 1000.0;   // of the haptic frames; the watchdog waits for three at least [Hz]
  double duration = 0.0;  // 0: until told to stop or the device has finished [s]
  std::vector<FaultEvent> faults;
  double after_fault = 0.020;  // zero force is kept up this long, then the session ends [s]
  // a contact this deep that the model in use did not know raises an event; 0: kDeepShare of the
  // grasped object's radius, and never where a source stands for it [m]
  double deep_contact = 0.0;

  // lockstep
  int contact_every = 1;  // haptic frames from one contact step to the next
  // haptic frames from the state a model is taken at to its first use, >= 1
  int contact_latency = 1;

  // threads
  RtRequest haptic_thread{80, -1};
  // polled before each deadline [s]; below 0: as long as wake-ups ask for (clock_of)
  double spin = -1.0;
  RtRequest contact_thread{40, -1};
  std::size_t telemetry_frames = 8192;  // room of the rings; 8 s at 1 kHz
  std::size_t telemetry_models = 512;   // 40 KB each; half a second at 1 kHz

  // who watches and tunes (live_ports.h); outlives the session; null: nobody
  LivePorts* live = nullptr;
};

/// What is worth a line while a session runs.
enum class EventKind : std::uint8_t {
  began,            // a session; only for those who watch several, one after the other
  fault,            // latched; detail: its name
  resumed,          // a fault was cleared; detail: its name
  late,             // a step or a model, ridden out (SafetyLimits); detail: the fault it would be
  grasped,          // the hand took hold
  released,         // and let go
  armed,            // forces are on
  disarmed,         // and off
  not_armed,        // a hand holds the object and nothing arms; detail: why
  deep_contact,     // deeper than a model knew; detail: why
  held_back,        // the object waits at the end of what its models allow; detail: why
  squeezed,         // rows that contradict each other hold the object
  impact,           // of a simulated body; text: how hard
  at_rest,          // a simulated body
  recording_ended,  // before its session; detail: the file
};
inline constexpr int kEventKinds = 15;

/// Name as it stands in recordings, in messages to pages and in figures.
const char* event_name(EventKind kind) noexcept;

/// The kind of that name; nothing for any other.
std::optional<EventKind> event_of_name(std::string_view name) noexcept;

/// Something worth a line: a fault, grasping, arming, samples lost.
struct SessionEvent {
  double time = 0.0;  // session clock [s]
  std::uint64_t frame = 0;
  EventKind kind = EventKind::began;
  std::string detail{};  // see EventKind; else empty
  // more, for a person: how long nothing stepped, why nothing arms, how deep; or empty
  std::string text{};
};

/// Where samples go. Called from one thread that is not real time (lockstep: the caller's), in
/// order of frames; every model comes before the first frame that used it. Empty ones are skipped.
/// What a sink throws ends the session and comes out of run_lockstep or finish().
struct SessionSinks {
  std::function<void(const HapticSample&)> haptic;
  std::function<void(const ContactSample&)> contact;
  std::function<void(const SessionEvent&)> event;
};

/// Why devices that may hold a person are refused on a virtual clock.
inline constexpr const char* kNoPersonOffClock =
    "not in lockstep, whose ramps and limits hold on a virtual clock and not for a person's hand, "
    "expected hand:, script: or null:";

/// Runs a session on a virtual clock in the calling thread: no sleeping, no other thread,
/// bit-reproducible.
///
/// config   see there; device, limits taken from `device`
/// stop     null, or looked at every frame
/// errors   std::invalid_argument for a rate, latency, duration or limit that makes no sense;
///          DeviceUnavailable for a device that holds a person or sets the pace
/// Thread   [offline]. Ends with zero force written, whatever happens.
SessionSummary run_lockstep(const SessionConfig& config, HapticDevice& device,
                            const SessionSinks& sinks = {},
                            const std::atomic<bool>* stop = nullptr);

/// A session on threads: haptic, contact, watchdog, and one that drains the telemetry.
/// Invariant: between start() and the end of finish() the device belongs to the session.
/// Thread: every member from one thread.
class Session {
 public:
  /// device, and the hierarchies of config, outlive the session.
  Session(SessionConfig config, HapticDevice& device, SessionSinks sinks = {});
  ~Session();  // stops, with zero force
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Once, also where it fails. Throws std::invalid_argument as run_lockstep, std::system_error
  // without threads, DeviceUnavailable where a device that sets the pace does not start,
  // std::logic_error the second time.
  void start();
  void request_stop() noexcept;  // asynchronous; also safe from a signal handler
  bool is_running() const noexcept;
  SessionSummary finish();  // waits for the end; call once after start(); throws what a sink threw

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace thigma
