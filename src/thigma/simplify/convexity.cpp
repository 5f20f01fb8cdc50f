#include "thigma/simplify/convexity.h"

#include <algorithm>

namespace thigma {

void constrain(UnitInterval& interval, const ConvexityConstraint& constraint, const Vec3& v_hat,
               const Vec3& v_tilde) {
  const Vec3& va = constraint.va;
  const Vec3 normal = (constraint.vd - va).cross(constraint.vc - va);
  const double a = normal.dot(v_hat - v_tilde);
  const double b = normal.dot(v_tilde - va) + constraint.slack;
  if (a > 0.0)
    interval.low = std::max(interval.low, -b / a);
  else if (a < 0.0)
    interval.high = std::min(interval.high, -b / a);
  else if (b < 0.0)
    interval.is_feasible = false;
  if (interval.low > interval.high) interval.is_feasible = false;
}

UnitInterval solve_convexity(const Vec3& v_hat, const Vec3& v_tilde,
                             std::span<const ConvexityConstraint> constraints) {
  UnitInterval interval;
  for (const ConvexityConstraint& c : constraints) {
    constrain(interval, c, v_hat, v_tilde);
    if (!interval.is_feasible) break;
  }
  return interval;
}

Vec3 mix(double u, const Vec3& v_hat, const Vec3& v_tilde) {
  return u * v_hat + (1.0 - u) * v_tilde;
}

}  // namespace thigma
