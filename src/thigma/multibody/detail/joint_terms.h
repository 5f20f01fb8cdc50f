#pragma once
// What rows of joints add to the augmented Lagrangian of an island.

#include <span>

#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// Speed of a row at velocities [m/s].
double speed_of(const JointRow& row, std::span<const Vec6> u) noexcept;

/// The impulse that a trial speed gives a row, within its bounds [N s].
///
/// weight  impulse a speed: firmness of a soft row, the penalty of a hard one [kg]
double impulse_of(const JointRow& row, double speed, double weight) noexcept;

/// Whether the impulse at a speed changes with it: it is not at a bound.
bool is_within_bounds(const JointRow& row, double speed, double weight) noexcept;

/// Adds on times the impulse.
void add_impulse(const JointRow& row, double impulse, std::span<Vec6> to) noexcept;

/// Adds weight on on^T: blocks of the lower half.
void add_curvature(const JointRow& row, double weight, BlockMatrix& h) noexcept;

/// Speed of a row for a unit of impulse [1/kg].
double mobility_of(const JointRow& row, std::span<const Mat6> inverse_metrics) noexcept;

/// By how much a hard row is not obeyed at a speed [m/s]: one at a bound gives what it can.
double violation_of(const JointRow& row, double speed) noexcept;

}  // namespace thigma::detail
