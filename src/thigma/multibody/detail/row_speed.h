#pragma once
// How fast the two places of a row come together.

#include <algorithm>
#include <cmath>

#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// Violations of rows up to this share of the largest free speed are met.
inline constexpr double kRowsMet = 1e-6;

/// Velocity of a place of a body.
///
/// u    velocity of the centre of mass, then of turning [m/s, rad/s; world]
/// arm  from the centre of mass [m; world]
inline Vec3 velocity_at(const Vec6& u, const Vec3& arm) noexcept {
  const Vec3 turn = u.tail<3>();
  return u.head<3>() + turn.cross(arm);
}

/// Velocity of a row's place on its first body against that on its second [m/s; world]. Null: what
/// stands still.
inline Vec3 approach_of(const IslandRow& row, const Vec6* a, const Vec6* b) noexcept {
  Vec3 w = Vec3::Zero();
  if (a != nullptr) w += velocity_at(*a, row.arm_a);
  if (b != nullptr) w -= velocity_at(*b, row.arm_b);
  return w;
}

/// Of it what is along the normal, > 0 where they come together [m/s].
inline double normal_speed(const IslandRow& row, const Vec6* a, const Vec6* b) noexcept {
  return row.normal.dot(approach_of(row, a, b));
}

/// Speed of a body without rows, turning included by its energy [m/s].
inline double free_speed(const IslandBody& body) noexcept {
  const double square = body.free.dot(body.metric * body.free) / body.metric(0, 0);
  return std::sqrt(std::max(square, 0.0));
}

}  // namespace thigma::detail
