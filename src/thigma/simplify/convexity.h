#pragma once
// How far a vertex may follow smoothness while patches stay convex (Sec. 3.3.4 steps 4 and 5).

#include <span>

#include "thigma/math/types.h"

namespace thigma {

/// Edge va-vc of triangle (va, v3, vc), counter-clockwise, must be convex or flat towards vd:
/// ((v3 - va) x (vc - va)) . (vd - va) <= slack. Any four points of a patch make such a condition,
/// and it is linear in v3; of an edge that ends in v3, that edge is va-v3 (docs/sources.md, Eq.
/// 3.4).
struct ConvexityConstraint {
  Vec3 va = Vec3::Zero(), vc = Vec3::Zero(), vd = Vec3::Zero();  // [m]
  double slack = 0.0;                                            // >= 0 [m^3]
};

/// Values of u for which v3 = u v_hat + (1 - u) v_tilde meets every constraint (Eq. 3.3).
struct UnitInterval {
  double low = 0.0, high = 1.0;
  bool is_feasible = true;
};

/// Narrows the interval by one constraint, A u + B >= 0 (Eq. 3.4).
void constrain(UnitInterval& interval, const ConvexityConstraint& constraint, const Vec3& v_hat,
               const Vec3& v_tilde);

/// The one-dimensional program: `low` is its solution, as near to v_tilde as the constraints allow.
/// u = 1 itself may violate them: `high` is as near to v_hat as they allow.
///
/// Thread  [offline]; no failure. Source Eqs. 3.2-3.4.
UnitInterval solve_convexity(const Vec3& v_hat, const Vec3& v_tilde,
                             std::span<const ConvexityConstraint> constraints);

/// Eq. 3.3.
Vec3 mix(double u, const Vec3& v_hat, const Vec3& v_tilde);

/// Outcome of the search for a position that also meets what cannot be written as a constraint.
struct BisectionResult {
  bool is_accepted = false;
  double u = 0.0;  // the last accepted value
};

/// Accepts `low` if it may be; else needs `high`, and halves between the two, `iterations` times,
/// towards `low` (Fig. 3.6). What is returned has been tested; nothing is assumed of the set.
template <class Accept>
BisectionResult bisect(double low, double high, int iterations, Accept accept) {
  if (accept(low)) return {true, low};
  if (!(high > low) || !accept(high)) return {};
  double good = high, bad = low;
  for (int i = 0; i < iterations; ++i) {
    const double middle = 0.5 * (good + bad);
    (accept(middle) ? good : bad) = middle;
  }
  return {true, good};
}

}  // namespace thigma
