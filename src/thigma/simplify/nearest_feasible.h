#pragma once
// The point of a polytope nearest to where a vertex would go without it.

#include <optional>
#include <span>

#include "thigma/math/types.h"

namespace thigma {

/// normal . x <= offset, normal of unit length.
struct LinearConstraint {
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;  // [m]
};

/// More are refused: nothing is lost where a position is only one of several to try.
inline constexpr std::size_t kMostConstraints = 512;

/// The point that meets every constraint and is nearest to `target` in the norm of a matrix.
///
/// The constraints are taken one by one, in their order: one that the point so far violates holds
/// with equality at the next, which is then sought on its plane under those before it (Seidel 1991,
/// for a convex program instead of a linear one).
///
/// metric     symmetric, positive definite: the square of the distance is d^T metric d
/// tolerance  by how much the answer may violate a constraint [m]
/// returns    nothing when no point meets all of them
/// Thread     [offline]; time is linear in the constraints for most orders, cubic for the worst.
std::optional<Vec3> nearest_feasible(const Vec3& target, const Mat3& metric,
                                     std::span<const LinearConstraint> constraints,
                                     double tolerance);

}  // namespace thigma
