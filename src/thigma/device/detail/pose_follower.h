#pragma once
// A handle that follows poses which come seldom: critically damped, without steps in its velocity.

#include <algorithm>

#include "thigma/core/rt.h"
#include "thigma/math/elementary.h"
#include "thigma/math/pose.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {

/// Critically damped motion of an offset from rest, exact over a step.
struct Decay {
  Vec3 offset, rate;
};
inline Decay decayed(const Vec3& offset, const Vec3& rate, double omega, double h) THIGMA_RT {
  const double e = exponential(-omega * h);
  const Vec3 c = rate + omega * offset;
  return {e * (offset + h * c), e * (rate - omega * h * c)};
}

inline Vec3 at_most(const Vec3& v, double limit) THIGMA_RT {
  const double n = v.norm();
  if (n <= limit) return v;
  return (limit / n) * v;
}

/// A late tick does not make the handle leap.
inline double step_of(double elapsed) THIGMA_RT { return std::clamp(elapsed, 0.0, 0.010); }

/// Moves a handle's position toward a target's over h.
///
/// omega      natural frequency; lags by 2 / omega [rad/s]
/// most       speed [m/s]
/// h          above 0 [s]
/// Thread     [haptic].
inline void follow_position(const Vec3& target, double omega, double most, double h,
                            Motion& motion) THIGMA_RT {
  const Vec3 away = motion.pose.position - target;
  const Decay way = decayed(away, motion.twist.linear, omega, h);
  const Vec3 step = way.offset - away;
  const Vec3 moved = at_most(step, most * h);
  motion.pose.position += moved;
  motion.twist.linear = at_most(moved == step ? way.rate : Vec3(moved / h), most);
}

/// The same for its orientation, the shorter way round; most [rad/s].
/// Thread     [haptic].
inline void follow_orientation(const Quat& target, double omega, double most, double h,
                               Motion& motion) THIGMA_RT {
  Pose& pose = motion.pose;
  const Vec3 away = vector_from_rotation(pose.orientation * target.conjugate());
  const Decay turn = decayed(away, motion.twist.angular, omega, h);
  const Vec3 step = turn.offset - away;
  const Vec3 turned = at_most(step, most * h);
  pose.orientation = (rotation_from_vector(turned) * pose.orientation).normalized();
  motion.twist.angular = at_most(turned == step ? turn.rate : Vec3(turned / h), most);
}

}  // namespace thigma::detail
