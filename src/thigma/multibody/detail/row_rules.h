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
  return std::hypot(row.impulse.y(), row.impulse.z()) >= (1.0 - kRounding) * most;
}

/// Whether a row came to press in its step, faster than what acts makes it.
///
/// slop  the gap that is kept [m]
inline bool has_met(const IslandRow& row, const RowSource& source, double slop) noexcept {
  constexpr double kTouch = 1e-6;  // of the gap that is kept: less is no way
  return row.impulse.x() > 0.0 && source.room > kTouch * slop;
}

/// By how much turning has closed a gap beyond half of what is to be kept [m]; 0: it has not.
inline double closed_by(double gap, double slop, const RowSource& source) noexcept {
  constexpr double kShort = 0.5;  // of what is kept
  const double kept = std::min(slop, source.gap);
  return gap >= kShort * kept || !(kept > 0.0) ? 0.0 : kept - gap;
}

}  // namespace thigma::detail
