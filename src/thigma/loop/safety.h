#pragma once
// What keeps the hand safe: every limit with its number, the faults, and the two places they act.

#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Every number of the safety layer, in device space. Constant while a session runs.
/// docs/safety.md lists them.
struct SafetyLimits {
  double max_force = 1e9;     // norm; the device's own limit holds as well [N]
  double max_torque = 1e9;    // norm; the device's own limit holds as well [N m]
  double force_slew = 200.0;  // fastest change of the force outside contact onset [N/s]
  double torque_slew = 6.0;   // the same for the torque: full scale in the same time [N m/s]
  // after the first touch changes are not slowed down, so that taps stay crisp; a touch is a first
  // one after kOnsetFreeWindows times as long without any [s]
  double onset_window = 0.010;
  double start_ramp = 0.5;  // from armed to full wrench [s]
  // free of contact this long, so that bouncing is not taken for leaving [s]
  double clear_before_arming = 0.05;
  double max_speed = 1.5;          // of the handle, reported or moved; faster is a fault [m/s]
  double pose_jump = 0.005;        // of the handle in a tick; farther is a fault [m]
  double max_turn_speed = 25.0;    // the same for turning, reported or done [rad/s]
  double orientation_jump = 0.1;   // and for the angle turned in a tick [rad]
  double silent_device = 0.050;    // without a new device sample: a fault [s]
  double model_full_age = 0.025;   // a contact model up to this age counts fully [s]
  double model_stale_age = 0.050;  // and not at all from here on, where contact_stale latches [s]
  // Models of rows that come slowly are not wrong, the object waits where they hold, and a force
  // that fades and comes back is felt: they count fully up to three times the longest interval of
  // late, at least as above and at most up to here [s]
  double rows_full_age = 0.1;
  double rows_stale_age = 0.2;
  double watchdog = 0.020;  // without a haptic step the second thread sends zero force [s]
  // a late frame or model is no fault: zero force, then start_ramp anew; only where the device
  // holds nobody (use_device_limits)
  bool rides_out_gaps = false;
};

/// Free of contact for so many onset windows before a touch opens another: a contact that chatters
/// stays under the slew limits.
inline constexpr double kOnsetFreeWindows = 2.0;

enum class Fault : std::uint8_t {
  none,
  device_lost,  // unplugged, closed, or silent
  not_finite,   // NaN or infinity from the device, in the state or in the wrench; a step without
                // a time or a length
  too_fast,     // handle speed
  pose_jump,    // handle moved too far in a tick
  turned_too_fast,   // speed of the handle's turning
  orientation_jump,  // handle turned too far in a tick
  contact_stale,     // the contact thread did not answer in time
  watchdog,          // the haptic thread did not step in time
};

/// Name as it stands in summaries, recordings and messages.
const char* fault_name(Fault fault) noexcept;

/// What the safety layer remembers between steps.
struct SafetyState {
  Fault fault = Fault::none;  // latched: the first one, until clear_fault
  double fault_time = 0.0;    // [s; session clock]
  bool is_armed = false;      // only then anything but zero is sent
  double armed_time = 0.0;    // [s]
  bool was_in_contact = false;
  double contact_time = -1e300;  // last in contact [s]
  double onset_time = -1e300;    // of the last first touch [s]
  double weight = 1.0;           // last of model_weight
  double model_time = 0.0;       // of the last contact model [s; session clock]
  std::uint64_t model_sequence = 0;
  double model_interval = 0.0;  // the longest between two models of late [s]
  Wrench slewed;  // after ramp, clamp and slew, before fading; about the handle [device frame]
  Wrench sent;    // slewed times the weight of the contact model; growing no faster than the slew
  bool has_device = false;            // a good sample has been seen
  Vec3 last_position = Vec3::Zero();  // of the handle [m; device frame]
  double last_stamp = 0.0;            // DeviceState::time of the last new sample
  double last_time = 0.0;             // when the last new sample came [s; session clock]
  double last_look = 0.0;             // when a sample was last looked at [s; session clock]
  double lead = 0.0;  // how far the handle is ahead of one that moves at max_speed [m]
  Quat last_orientation = Quat::Identity();  // of the handle [device frame]
  double turn_lead = 0.0;  // how far it is ahead of one that turns at max_turn_speed [rad]
};

/// When a step is made, and how long it is.
struct StepTime {
  double now = 0.0;      // [s; session clock]
  double elapsed = 0.0;  // since the last step [s], > 0
};

/// How old a contact model is, and of which kind.
struct ModelAge {
  double seconds = 0.0;        // NaN counts as stale
  double time = 0.0;           // of the state it was made for [s; session clock]
  std::uint64_t sequence = 0;  // 0: none yet
  bool has_rows = false;       // of the constraint response
};

/// A wrench that is asked for.
struct AskedWrench {
  Wrench wanted;        // on the hand about the handle [N, N m; device frame]
  double weight = 1.0;  // of model_weight
  // change since the last step that is not slowed down, as it is of a transient of known slope
  double force_change = 0.0, torque_change = 0.0;  // >= 0 [N, N m]
};

/// Shortened to `limit`, direction kept.
/// Thread    [haptic].
Vec3 clamped(const Vec3& v, double limit) THIGMA_RT;

/// Latches the first fault and disarms; later ones change nothing.
/// Thread    [haptic].
void latch_fault(SafetyState& safety, Fault fault, double now) THIGMA_RT;

/// Forgets a fault; nothing is armed by that.
/// Thread    [haptic].
void clear_fault(SafetyState& safety) THIGMA_RT;

/// The force is zero from now on and comes back over start_ramp, inside a contact as well; nothing
/// latches. For rides_out_gaps.
/// Thread    [haptic].
void ramp_anew(SafetyState& safety, double now) THIGMA_RT;

/// The same after a gap without steps, in which the handle may have gone anywhere.
/// Thread    [haptic].
void ride_out_gap(SafetyState& safety, double now) THIGMA_RT;

/// Looks at a device sample and latches what is wrong with it. The speed is judged by what the
/// device reports and by the way its handle went: a way that gets ahead of max_speed by pose_jump
/// is too fast as well, however it was divided into ticks. Its turning is judged the same way, by
/// max_turn_speed and orientation_jump; q and -q are one orientation. A sample with the stamp of
/// the one before is not a new one, whatever its status.
///
/// now      [s; session clock]; elapsed: since the last step [s], > 0
/// returns  whether the sample may be used
/// Thread   [haptic]
bool check_device(const SafetyLimits& limits, const DeviceState& device, double now, double elapsed,
                  SafetyState& safety) THIGMA_RT;

/// How much a contact model of this age counts, 1 to 0; latches contact_stale where it reaches 0
/// while armed, or with rides_out_gaps begins the ramp anew. The same factor multiplies the device
/// wrench, so that a fading contact never turns into a pull. It falls as the age says; while armed
/// it rises no faster than it fades, so that a late model brings the force back as gently as it
/// left.
///
/// age      of rows: the limits follow how often models come, see SafetyLimits::rows_full_age
/// elapsed  since the last step [s]
/// Thread   [haptic]
double model_weight(const SafetyLimits& limits, const ModelAge& age, double now, double elapsed,
                    SafetyState& safety) THIGMA_RT;

/// Arms when the hand holds the object and nothing has touched it for a while; disarms when it lets
/// go.
/// Thread    [haptic].
void update_arming(const SafetyLimits& limits, bool is_grasped, bool is_in_contact, double now,
                   SafetyState& safety) THIGMA_RT;

/// The wrench that may be sent: zero unless armed, ramped, weighted, clamped by norm, slowed by the
/// slew limits.
///
/// returns  axes the device does not actuate are still in it; NaN or infinity, going in or coming
///          out, latches a fault and gives zero
/// Thread   [haptic]
Wrench limit_wrench(const SafetyLimits& limits, const DeviceLimits& device,
                    const AskedWrench& asked, const StepTime& step, SafetyState& safety) THIGMA_RT;

}  // namespace thigma
