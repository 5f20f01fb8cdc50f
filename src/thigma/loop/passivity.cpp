#include "thigma/loop/passivity.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/elementary.h"

namespace thigma {
namespace {

/// Rotation vector of a unit quaternion, the short way round [rad].
Vec3 rotation_vector(const Quat& q) THIGMA_RT {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const Vec3 v = sign * q.vec();
  const double n = v.norm();
  if (n == 0.0) return Vec3::Zero();
  return (2.0 * arc_tangent2(n, sign * q.w()) / n) * v;
}

}  // namespace

void observe_motion(EnergyObserver& observer, const Pose& handle) THIGMA_RT {
  if (observer.has_sample) {
    const Vec3 moved = handle.position - observer.last.position;
    const Vec3 turned = rotation_vector(handle.orientation * observer.last.orientation.conjugate());
    observer.energy -= observer.held.force.dot(moved) + observer.held.torque.dot(turned);
    observer.energy_min = std::min(observer.energy_min, observer.energy);
  }
  observer.has_sample = true;
  observer.last = handle;
}

void observe_wrench(EnergyObserver& observer, const Wrench& sent) THIGMA_RT {
  observer.held = sent;
}

}  // namespace thigma
