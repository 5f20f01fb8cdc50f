#include "thigma/loop/safety.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

bool is_finite(const Wrench& w) THIGMA_RT { return w.force.allFinite() && w.torque.allFinite(); }

bool is_finite(const DeviceState& d) THIGMA_RT {
  return std::isfinite(d.time) && d.motion.pose.position.allFinite() &&
         d.motion.pose.orientation.coeffs().allFinite() && d.motion.twist.linear.allFinite() &&
         d.motion.twist.angular.allFinite() && d.weight >= 0.0 && d.weight <= 1.0;
}

/// Latches where a sample stamped `stamp` leaves the device silent for too long.
void check_silence(const SafetyLimits& limits, const DeviceState& device, double now,
                   SafetyState& safety) THIGMA_RT {
  const bool is_new = !safety.has_device || device.time != safety.last_stamp;
  if (is_new && device.status != DeviceStatus::not_ready) {
    safety.last_stamp = device.time;
    safety.last_time = now;
  } else if (safety.has_device && device.status != DeviceStatus::finished &&
             now - safety.last_time > limits.silent_device) {
    latch_fault(safety, Fault::device_lost, now);
  }
}

/// What a way or an angle is judged by, and the faults it is.
struct WayLimit {
  double speed;  // [m/s or rad/s]
  double jump;   // in a tick [m or rad]
  Fault too_far, too_fast;
};

/// Latches where `moved` since the last look [m or rad] is too far or too fast; `lead` is how far
/// ahead of the fastest that is allowed.
void check_way(const WayLimit& limit, double moved, const StepTime& step, double& lead,
               SafetyState& safety) THIGMA_RT {
  const auto [now, elapsed] = step;
  // A tick longer than the usual millisecond may go as far as the speed limit allows in it.
  const double reach = std::max(limit.jump, limit.speed * elapsed);
  if (moved > reach) latch_fault(safety, limit.too_far, now);
  // Fills with the way, empties at the speed limit: samples that come late or seldom do no harm, a
  // handle that is too fast for long cannot hide in steps below the jump.
  const double allowed = limit.speed * std::max(0.0, now - safety.last_look);
  lead = std::max(0.0, lead + moved - allowed);
  if (lead > limit.jump) latch_fault(safety, limit.too_fast, now);
}

/// Latches where the handle went or turned too far or too fast since the last look.
void check_ways(const SafetyLimits& limits, const Pose& pose, double now, double elapsed,
                SafetyState& safety) THIGMA_RT {
  const double moved = (pose.position - safety.last_position).norm();
  check_way({limits.max_speed, limits.pose_jump, Fault::pose_jump, Fault::too_fast}, moved,
            {now, elapsed}, safety.lead, safety);
  const double turned =
      vector_from_rotation(pose.orientation * safety.last_orientation.conjugate()).norm();
  check_way({limits.max_turn_speed, limits.orientation_jump, Fault::orientation_jump,
             Fault::turned_too_fast},
            turned, {now, elapsed}, safety.turn_lead, safety);
}

/// Where the handle is starts a new history.
void forget_way(SafetyState& safety) THIGMA_RT {
  safety.has_device = false;
  safety.lead = 0.0;
  safety.turn_lead = 0.0;
}

/// From `last` towards `v`: by at most `step` where the norm grows, all the way where it does not.
Vec3 grown(const Vec3& last, const Vec3& v, double step) THIGMA_RT {
  if (!(v.norm() > last.norm())) return v;
  return last + clamped(v - last, step);
}

}  // namespace

Vec3 clamped(const Vec3& v, double limit) THIGMA_RT {
  const double n = v.norm();
  if (n <= limit) return v;
  return (limit / n) * v;
}

const char* fault_name(Fault fault) noexcept {
  switch (fault) {
    case Fault::none:
      return "none";
    case Fault::device_lost:
      return "device_lost";
    case Fault::not_finite:
      return "not_finite";
    case Fault::too_fast:
      return "too_fast";
    case Fault::pose_jump:
      return "pose_jump";
    case Fault::turned_too_fast:
      return "turned_too_fast";
    case Fault::orientation_jump:
      return "orientation_jump";
    case Fault::contact_stale:
      return "contact_stale";
    case Fault::watchdog:
      return "watchdog";
  }
  return "unknown";
}

void latch_fault(SafetyState& safety, Fault fault, double now) THIGMA_RT {
  safety.is_armed = false;
  if (safety.fault != Fault::none || fault == Fault::none) return;
  safety.fault = fault;
  safety.fault_time = now;
}

void clear_fault(SafetyState& safety) THIGMA_RT {
  safety.fault = Fault::none;
  safety.fault_time = 0.0;
  forget_way(safety);  // the jump that caused the fault is not to be seen again
}

void ramp_anew(SafetyState& safety, double now) THIGMA_RT {
  safety.armed_time = now;
  safety.slewed = Wrench{};
  safety.sent = Wrench{};
}

void ride_out_gap(SafetyState& safety, double now) THIGMA_RT {
  ramp_anew(safety, now);
  forget_way(safety);
}

bool check_device(const SafetyLimits& limits, const DeviceState& device, double now, double elapsed,
                  SafetyState& safety) THIGMA_RT {
  if (device.status == DeviceStatus::lost) {
    latch_fault(safety, Fault::device_lost, now);
    return false;
  }
  if (device.status == DeviceStatus::not_ready) {
    check_silence(limits, device, now, safety);
    return safety.has_device && safety.fault == Fault::none;
  }
  if (!is_finite(device) || !(device.motion.pose.orientation.squaredNorm() > 0.25)) {
    latch_fault(safety, Fault::not_finite, now);
    return false;
  }
  if (device.motion.twist.linear.norm() > limits.max_speed)
    latch_fault(safety, Fault::too_fast, now);
  if (device.motion.twist.angular.norm() > limits.max_turn_speed)
    latch_fault(safety, Fault::turned_too_fast, now);
  check_silence(limits, device, now, safety);
  if (safety.has_device) check_ways(limits, device.motion.pose, now, elapsed, safety);
  safety.has_device = true;
  safety.last_position = device.motion.pose.position;
  safety.last_orientation = device.motion.pose.orientation;
  safety.last_look = now;
  return safety.fault == Fault::none;
}

namespace {

constexpr double kIntervalMemory = 1.0;  // [s]
constexpr double kIntervals = 3.0;       // a model may be old; two pass where none is late

void note_interval(const ModelAge& age, double elapsed, SafetyState& safety) THIGMA_RT {
  safety.model_interval -= safety.model_interval * std::min(elapsed / kIntervalMemory, 1.0);
  if (age.sequence == safety.model_sequence) return;
  if (safety.model_sequence != 0)
    safety.model_interval = std::max(safety.model_interval, age.time - safety.model_time);
  safety.model_sequence = age.sequence;
  safety.model_time = age.time;
}

struct AgeLimits {
  double full, stale;  // [s]
};

AgeLimits age_limits(const SafetyLimits& limits, const ModelAge& age,
                     const SafetyState& safety) THIGMA_RT {
  const AgeLimits usual{limits.model_full_age, limits.model_stale_age};
  if (!age.has_rows) return usual;
  const double wanted = kIntervals * safety.model_interval;
  const AgeLimits most{std::max(limits.rows_full_age, usual.full),
                       std::max(limits.rows_stale_age, usual.stale)};
  if (!(wanted > usual.full)) return usual;
  const double share = most.full > usual.full
                           ? std::min((wanted - usual.full) / (most.full - usual.full), 1.0)
                           : 0.0;
  return {usual.full + share * (most.full - usual.full),
          usual.stale + share * (most.stale - usual.stale)};
}

}  // namespace

double model_weight(const SafetyLimits& limits, const ModelAge& age, double now, double elapsed,
                    SafetyState& safety) THIGMA_RT {
  note_interval(age, elapsed, safety);
  const AgeLimits may = age_limits(limits, age, safety);
  const double fade = may.stale - may.full;
  double weight = 0.0;
  if (!(age.seconds < may.stale)) {  // NaN counts as stale
    if (safety.is_armed && limits.rides_out_gaps) {
      ramp_anew(safety, now);
    } else if (safety.is_armed) {
      latch_fault(safety, Fault::contact_stale, now);
    }
  } else if (age.seconds <= may.full) {
    weight = 1.0;
  } else {
    weight = (may.stale - age.seconds) / fade;
  }
  // Unarmed nothing is felt, and nothing arms below 1: no need to wait.
  if (safety.is_armed && fade > 0.0) weight = std::min(weight, safety.weight + elapsed / fade);
  safety.weight = weight;
  return weight;
}

void update_arming(const SafetyLimits& limits, bool is_grasped, bool is_in_contact, double now,
                   SafetyState& safety) THIGMA_RT {
  const double free_time = now - safety.contact_time;
  const bool is_clear = !is_in_contact && free_time >= limits.clear_before_arming;
  if (!is_grasped || safety.fault != Fault::none) {
    safety.is_armed = false;
  } else if (!safety.is_armed && is_clear) {
    safety.is_armed = true;
    safety.armed_time = now;
  }
  const bool is_first = is_in_contact && !safety.was_in_contact;
  if (is_first && free_time >= kOnsetFreeWindows * limits.onset_window) safety.onset_time = now;
  if (is_in_contact) safety.contact_time = now;
  safety.was_in_contact = is_in_contact;
}

Wrench limit_wrench(const SafetyLimits& limits, const DeviceLimits& device,
                    const AskedWrench& asked, const StepTime& step, SafetyState& safety) THIGMA_RT {
  const auto [now, elapsed] = step;
  const Wrench& wanted = asked.wanted;
  if (!is_finite(wanted)) latch_fault(safety, Fault::not_finite, now);
  if (safety.fault != Fault::none || !safety.is_armed) {
    safety.slewed = Wrench{};
    safety.sent = Wrench{};
    return safety.sent;
  }
  const double ramp = limits.start_ramp > 0.0
                          ? std::clamp((now - safety.armed_time) / limits.start_ramp, 0.0, 1.0)
                          : 1.0;
  const double force_limit = std::min(limits.max_force, device.max_force);
  // A torque the device cannot give is still computed and shown: its limit of zero says nothing
  // about it.
  const double torque_limit =
      device.actuates_rotation ? std::min(limits.max_torque, device.max_torque) : limits.max_torque;
  // Clamp first, then ramp: a saturated wrench ramps as well.
  Wrench w{ramp * clamped(wanted.force, force_limit), ramp * clamped(wanted.torque, torque_limit)};
  const double force_step = limits.force_slew * elapsed + asked.force_change;
  const double torque_step = limits.torque_slew * elapsed + asked.torque_change;
  const bool is_slow = now - safety.onset_time > limits.onset_window;
  if (is_slow) {
    const Wrench& last = safety.slewed;
    w.force = last.force + clamped(w.force - last.force, force_step);
    w.torque = last.torque + clamped(w.torque - last.torque, torque_step);
  }
  // The slew limit keeps within the ball of the clamp only up to rounding.
  safety.slewed = {clamped(w.force, force_limit), clamped(w.torque, torque_limit)};
  Wrench sent = asked.weight * safety.slewed;
  if (is_slow) {  // the weight changes the wrench as well; the fade to zero is never slowed
    sent.force = grown(safety.sent.force, sent.force, force_step);
    sent.torque = grown(safety.sent.torque, sent.torque, torque_step);
  }
  if (!is_finite(sent)) {  // numbers of a caller's: elapsed, the limits of a device
    latch_fault(safety, Fault::not_finite, now);
    safety.slewed = Wrench{};
    sent = Wrench{};
  }
  safety.sent = sent;
  return sent;
}

}  // namespace thigma
