// A state machine over a target that moves along the approach (depth), across it and about it.
// Pressing is integral control of the felt force through the arm's spring: the target advances
// until the device pushes back hard enough.
#include "thigma/device/hand_program.h"

#include <algorithm>
#include <cmath>

#include "thigma/device/haptic_device.h"
#include "thigma/device/workspace.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

// [s] longer than the start ramp, so that the baseline is the full weight
constexpr double kFirstRest = 0.6;
constexpr double kLaterRest = 0.4;   // [s]
constexpr double kFeltTime = 0.005;  // [s] of the low pass on the felt force: a few device ticks
// [s] of the force control; slower than arm and coupling, so stable
constexpr double kPressTime = 0.08;
constexpr double kAcceleration = 3.0;  // [m/s^2] of the target along the approach
constexpr double kContactShare = 0.3;  // of the pressing force: this much felt is contact
// Nobody corrects a force more finely; without it the hand would hunt to and fro across the
// device's friction.
constexpr double kDeadShare = 0.03;
constexpr double kSteadyShare = 0.05;  // of the pressing force: this close is reached ...
constexpr double kSteadyTime = 0.2;    // ... when it lasts so long [s]
constexpr double kPressLimit = 2.0;    // [s] then the program goes on with what it has
constexpr double kCircleRate = kPi;    // [rad/s]: half a turn a second

// Smallest-jerk rise from 0 to 1 for u in [0, 1]; its steepest slope is 1.875.
double smooth(double u) THIGMA_RT {
  u = std::clamp(u, 0.0, 1.0);
  return u * u * u * (10.0 + u * (6.0 * u - 15.0));
}

void enter(HandProgram& s, HandPhase phase, double from = 0.0) THIGMA_RT {
  s.phase = phase;
  s.phase_time = 0.0;
  s.steady_time = 0.0;
  s.from = from;
}

void feel(const Vec3& force, double dt, HandProgram& s) THIGMA_RT {
  if (s.phase == HandPhase::rest) s.baseline += dt / (dt + 0.05) * (force - s.baseline);
  const double beyond = std::sqrt((force - s.baseline).squaredNorm());
  s.felt += dt / (dt + kFeltTime) * (beyond - s.felt);
}

void advance_depth(double speed, double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  s.speed += std::clamp(speed - s.speed, -kAcceleration * dt, kAcceleration * dt);
  s.depth += s.speed * dt;
  if (s.depth > p.reach || s.depth < 0.0) {
    s.depth = std::clamp(s.depth, 0.0, p.reach);
    s.speed = 0.0;
  }
}

double give(const HandProgramParams& p, double force) THIGMA_RT {
  return p.arm_stiffness > 0.0 ? force / p.arm_stiffness : 0.0;
}

void keep_pressing(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  const double missing = p.force - s.felt;
  const double slack = kDeadShare * p.force;
  const double beyond = missing - std::clamp(missing, -slack, slack);
  const double speed = give(p, beyond) / kPressTime;
  advance_depth(std::clamp(speed, -p.speed, p.speed), dt, p, s);
  s.steady_time = std::fabs(missing) <= kSteadyShare * p.force ? s.steady_time + dt : 0.0;
}

// Moves `value` from s.from to `goal` at most at `speed`; true when there.
bool glide(double goal, double speed, const HandProgram& s, double& value) THIGMA_RT {
  const double length = std::fabs(goal - s.from);
  const double time = speed > 0.0 ? 1.875 * length / speed : 0.0;
  if (s.phase_time >= time) {
    value = goal;
    return true;
  }
  value = s.from + (goal - s.from) * smooth(s.phase_time / time);
  return false;
}

void begin_lift(const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  // The target is force / stiffness deeper than the surface; a tap starts lift_height above that.
  s.lift_depth = std::max(0.0, s.depth - give(p, s.felt) - p.lift_height);
  enter(s, HandPhase::lift);
}

void advance_rest(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  s.speed = 0.0;
  if (p.path == HandPath::rest) return;
  const double time = s.rounds == 0 ? kFirstRest : kLaterRest;
  s.across = s.from * (1.0 - smooth(s.phase_time / kLaterRest));
  if (s.phase_time + dt < time) return;
  s.across = 0.0;
  const bool is_turn = p.path == HandPath::turn, is_circle = p.path == HandPath::circle;
  enter(s, is_turn ? HandPhase::turn : is_circle ? HandPhase::circle : HandPhase::approach);
}

void advance_approach(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  advance_depth(p.speed, dt, p, s);
  if (s.felt >= kContactShare * p.force) {
    if (p.path == HandPath::tap) {
      begin_lift(p, s);
    } else {
      enter(s, HandPhase::press);
    }
  } else if (s.depth >= p.reach) {
    enter(s, HandPhase::retract);
  }
}

void advance_press(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  keep_pressing(dt, p, s);
  if (p.path == HandPath::press) return;
  if (s.steady_time >= kSteadyTime || s.phase_time >= kPressLimit) {
    enter(s, HandPhase::slide, s.across);
  }
}

void advance_slide(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  keep_pressing(dt, p, s);
  const bool goes_out = s.from < 0.5 * p.slide_length;
  const bool is_there = glide(goes_out ? p.slide_length : 0.0, p.slide_speed, s, s.across);
  if (!is_there) return;
  if (p.path == HandPath::slide) {
    enter(s, HandPhase::slide, s.across);
  } else {
    enter(s, HandPhase::twist, s.angle);
  }
}

// Peak rate of a smallest-jerk twist that takes twist_time; a turn button has its own constant
// rate.
void advance_twist(double goal, HandPhase next, double dt, const HandProgramParams& p,
                   HandProgram& s) THIGMA_RT {
  keep_pressing(dt, p, s);
  bool is_there = false;
  if (p.twist_by_buttons) {
    is_there = s.phase_time >= std::fabs(p.twist_angle) / kButtonTurnRate;
  } else {
    const double rate = p.twist_time > 0.0 ? 1.875 * std::fabs(p.twist_angle) / p.twist_time : 0.0;
    is_there = glide(goal, rate, s, s.angle);
  }
  if (!is_there) return;
  if (next == HandPhase::lift) {
    s.taps = 0;
    begin_lift(p, s);
  } else {
    enter(s, next, s.angle);
  }
}

void advance_lift(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  advance_depth(-p.tap_speed, dt, p, s);
  if (s.depth <= s.lift_depth) enter(s, HandPhase::tap);
}

void advance_tap(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  advance_depth(p.tap_speed, dt, p, s);
  // A surface that is no longer there must not be chased.
  const double limit = s.lift_depth + 2.0 * p.lift_height + give(p, 2.0 * p.force);
  const bool is_turning = s.felt >= 0.5 * p.force && s.phase_time > 2.0 * kFeltTime;
  if (!is_turning && s.depth < std::min(limit, p.reach)) return;
  ++s.taps;
  if (p.path == HandPath::demo && s.taps >= 2) {
    enter(s, HandPhase::retract);
  } else {
    enter(s, HandPhase::lift);
  }
}

void advance_retract(double dt, const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  advance_depth(-p.speed, dt, p, s);
  if (s.depth > 0.0) return;
  ++s.rounds;
  enter(s, HandPhase::rest, s.across);
}

void advance_turn(const HandProgramParams& p, HandProgram& s) THIGMA_RT {
  if (!(p.twist_time > 0.0)) return;
  s.angle = 0.5 * p.twist_angle * (1.0 - sin_cos(kPi * s.phase_time / p.twist_time).cos);
}

HandTarget target_of(const HandProgramParams& p, const HandProgram& s) THIGMA_RT {
  HandTarget target;
  target.buttons = kClutchButton;
  target.pose.position = p.start.position + s.depth * p.approach + s.across * p.slide;
  target.pose.orientation = unit(rotation_from_vector(s.angle * p.approach) * p.start.orientation);
  if (s.phase == HandPhase::circle) {
    const double t = s.phase_time;
    const SinCos turn = sin_cos(kCircleRate * t * t / (t + 0.3));  // starts from rest
    target.pose.position +=
        p.slide_length * ((turn.cos - 1.0) * p.slide + turn.sin * p.approach.cross(p.slide));
  }
  const bool is_twisting = s.phase == HandPhase::twist || s.phase == HandPhase::untwist;
  if (p.twist_by_buttons && is_twisting) {
    int axis = 0;
    p.approach.cwiseAbs().maxCoeff(&axis);
    const bool is_negative =
        (p.approach[axis] * p.twist_angle < 0.0) != (s.phase == HandPhase::untwist);
    target.buttons |= kTurnButtons[2 * axis + (is_negative ? 1 : 0)];
  }
  return target;
}

}  // namespace

HandProgramParams scale_to_object(HandProgramParams params, double radius) {
  params.slide_length = std::min(params.slide_length, radius / 5.0);
  params.lift_height = std::min(params.lift_height, radius / 5.0);
  params.reach = 1.5 * params.clearance + radius;
  return params;
}

HandTarget advance_program(const HandProgramParams& params, const Vec3& force, double dt,
                           HandProgram& program) THIGMA_RT {
  HandProgram& s = program;
  feel(force, dt, s);
  s.phase_time += dt;
  switch (s.phase) {
    case HandPhase::rest:
      advance_rest(dt, params, s);
      break;
    case HandPhase::approach:
      advance_approach(dt, params, s);
      break;
    case HandPhase::press:
      advance_press(dt, params, s);
      break;
    case HandPhase::slide:
      advance_slide(dt, params, s);
      break;
    case HandPhase::twist:
      advance_twist(params.twist_angle, HandPhase::untwist, dt, params, s);
      break;
    case HandPhase::untwist:
      advance_twist(0.0, HandPhase::lift, dt, params, s);
      break;
    case HandPhase::lift:
      advance_lift(dt, params, s);
      break;
    case HandPhase::tap:
      advance_tap(dt, params, s);
      break;
    case HandPhase::retract:
      advance_retract(dt, params, s);
      break;
    case HandPhase::turn:
      advance_turn(params, s);
      break;
    case HandPhase::circle:
    case HandPhase::script:
      break;
  }
  return target_of(params, s);
}

}  // namespace thigma
