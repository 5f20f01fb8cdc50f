#pragma once
// A round of an island's solve: the velocities at which its augmented Lagrangian is least.

#include <span>

#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// What a solve works on.
struct IslandWork {
  std::span<IslandBody> bodies;
  std::span<IslandRow> rows;
  std::span<JointRow> joints;
  IslandScratch& s;
  double speed = 0.0;  // the scale of all speeds [m/s]
  // Friction of a row is bounded by its own normal impulse, both at once (a cone), and not by
  // `radius`. Right where nothing slides: what slides would have to part as well.
  bool has_cones = false;
};

/// Speed of a against b at a row, along its normal and tangents [m/s].
Vec3 approach(const IslandRow& row, std::span<const Vec6> u) noexcept;

/// Adds an impulse along normal and tangents to what acts on a, and takes it from b.
void add_impulse(const IslandRow& row, const Vec3& impulse, std::span<Vec6> to) noexcept;

/// The nearest to z in Coulomb's cone: |tangential| <= friction * normal.
///
/// z         normal, then tangential
/// friction  > 0
Vec3 cone_force_of(const Vec3& z, double friction) noexcept;

/// Derivative of it by z; at the cone's boundaries that of either side.
Mat3 cone_slope_of(const Vec3& z, double friction) noexcept;

/// Least of the augmented Lagrangian, from the velocities that there are: a semismooth Newton's
/// method, never uphill. The scratch has the velocities, and the multipliers that they give rows
/// and joints (`force`, `joint_force`).
///
/// enough   of the gradient, in the energy's metric [sqrt(J)]
/// most     steps
/// returns  Newton's steps
/// Thread   [haptic]; no failure
int minimize(IslandWork& work, double enough, int most) noexcept;

}  // namespace thigma::detail
