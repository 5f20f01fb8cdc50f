#pragma once
// How fast the two places of a row come together, and what an impulse there gives their bodies.

#include <algorithm>
#include <cmath>
#include <span>

#include "thigma/core/index.h"
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

/// Adds an impulse at a row's place to what acts on its first body, and takes it from its second.
///
/// p   [N s; world]
/// to  linear, then angular, by body
inline void add_impulse_at(const IslandRow& row, const Vec3& p, std::span<Vec6> to) noexcept {
  if (row.a >= 0) {
    Vec6& a = to[idx(row.a)];
    a.head<3>() += p;
    a.tail<3>() += row.arm_a.cross(p);
  }
  if (row.b < 0) return;
  Vec6& b = to[idx(row.b)];
  b.head<3>() -= p;
  b.tail<3>() -= row.arm_b.cross(p);
}

/// Speed of a body without rows, turning included by its energy [m/s].
inline double free_speed(const IslandBody& body) noexcept {
  const double square = body.free.dot(body.metric * body.free) / body.metric(0, 0);
  return std::sqrt(std::max(square, 0.0));
}

}  // namespace thigma::detail
