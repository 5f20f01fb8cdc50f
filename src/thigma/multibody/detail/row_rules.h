#pragma once
// What a row of an island is at poses, and what counts as met, sliding or closed: of a step of the
// world and of a haptic step alike.

#include <algorithm>
#include <cmath>

#include "thigma/dynamics/constraint_model.h"
#include "thigma/multibody/detail/islands.h"
#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// Puts a row where its places are; its limit, friction and impulse stay.
///
/// at                 the row in the frame of its second body
/// world_from_second  of that body
/// position           of the first body's centre in that frame [m]
inline void place_row(const RowAtState& at, const Mat3& world_from_second, const Vec3& position,
                      IslandRow& row) noexcept {
  row.normal = world_from_second * at.normal;
  row.first = world_from_second * tangents_of(at.normal).first;
  row.arm_a = world_from_second * at.arm;
  row.arm_b = world_from_second * (position + at.arm);
}

/// Whether friction is at its bound, to rounding.
inline bool is_sliding(const IslandRow& row) noexcept {
  constexpr double kRounding = 1e-6;
  const double most = row.friction * row.impulse.x();
  return row.impulse.tail<2>().norm() >= (1.0 - kRounding) * most;
}

/// Whether a row came to press in its step, faster than what acts makes it.
///
/// slop  the gap that is kept [m]
inline bool has_met(const IslandRow& row, const RowSource& source, double slop) noexcept {
  constexpr double kTouch = 1e-6;  // of the gap that is kept: less is no way
  return row.impulse.x() > 0.0 && source.room > kTouch * slop;
}

/// Speeds at which a row's surfaces near each other [m/s].
struct Nearing {
  double start = 0.0;  // as a step begins
  double end = 0.0;    // as it would end without rows
};

/// Speed at which they meet over that at the end: what acts gives only the share until there. 0: no
/// impact, it is pressed together.
///
/// room  that was left as the step began [m]
inline double meeting_share(const Nearing& nearing, double room, double dt) noexcept {
  const double added = nearing.end - nearing.start;
  constexpr double kSteps = 4.0;  // an approach is an impact from so many times on what a step adds
  if (!(nearing.start > kSteps * std::fabs(added)) || !(nearing.end > 0.0)) return 0.0;
  const double square = nearing.start * nearing.start + 2.0 * added / dt * room;
  return std::sqrt(std::max(square, 0.0)) / nearing.end;
}

/// Energy of bodies that spring back by a share x of their bounces: slope x + bend x^2 [J].
struct EnergyShare {
  double slope = 0.0, bend = 0.0;
  double budget = 0.0;  // that it may be
};

/// The largest share, 0 to 1, within the budget.
inline double share_of(const EnergyShare& energy) noexcept {
  if (energy.slope + energy.bend <= energy.budget) return 1.0;
  if (!(energy.bend > 0.0)) return 0.0;
  // bend x^2 + slope x = budget, the larger root.
  const double inside = energy.slope * energy.slope + 4.0 * energy.bend * energy.budget;
  if (!(inside > 0.0)) return 0.0;
  return std::clamp((std::sqrt(inside) - energy.slope) / (2.0 * energy.bend), 0.0, 1.0);
}

/// By how much turning has closed a gap beyond half of what is to be kept [m]; 0: it has not.
inline double closed_by(double gap, double slop, const RowSource& source) noexcept {
  constexpr double kShort = 0.5;  // of what is kept
  const double kept = std::min(slop, source.gap);
  return gap >= kShort * kept || !(kept > 0.0) ? 0.0 : kept - gap;
}

}  // namespace thigma::detail
