#pragma once
// Rigid placements and motions. A transform is named a_from_b and maps coordinates of b to a.

#include "thigma/core/rt.h"
#include "thigma/math/types.h"

namespace thigma {

/// Rigid transform p -> orientation * p + position. Invariant of use: |orientation| = 1 to 1e-9.
struct Pose {
  Vec3 position = Vec3::Zero();         // [m]
  Quat orientation = Quat::Identity();  // unit
};

/// Velocity of a body: of its reference point and of its orientation [m/s, rad/s; world].
struct Twist {
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
};

/// Pose and velocity of a device or of a body at one instant.
struct Motion {
  Pose pose;
  Twist twist;
};

/// Force [N] and torque [N m] about a point that the name or docstring of the holder states; world
/// axes.
struct Wrench {
  Vec3 force = Vec3::Zero();
  Vec3 torque = Vec3::Zero();
};

inline Vec3 transform_point(const Pose& a_from_b, const Vec3& p_b) THIGMA_RT {
  return a_from_b.orientation._transformVector(p_b) + a_from_b.position;
}

/// a_from_c = a_from_b * b_from_c.
inline Pose operator*(const Pose& a_from_b, const Pose& b_from_c) THIGMA_RT {
  return {transform_point(a_from_b, b_from_c.position),
          a_from_b.orientation * b_from_c.orientation};
}

inline Pose inverse(const Pose& a_from_b) THIGMA_RT {
  const Quat q = a_from_b.orientation.conjugate();
  return {-(q._transformVector(a_from_b.position)), q};
}

inline Wrench operator+(const Wrench& a, const Wrench& b) THIGMA_RT {
  return {a.force + b.force, a.torque + b.torque};
}
inline Wrench operator-(const Wrench& a) THIGMA_RT { return {-a.force, -a.torque}; }
inline Wrench operator*(double s, const Wrench& a) THIGMA_RT { return {s * a.force, s * a.torque}; }

}  // namespace thigma
