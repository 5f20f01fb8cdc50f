#pragma once
// Gauss's least constraint in six unknowns: the velocity nearest to the free one that no row
// forbids, with Coulomb friction where rows press.

#include <array>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/math/types.h"

namespace thigma {

/// Rows that can press at once and be told apart in six unknowns.
inline constexpr int kMaxActive = 6;

/// Linear inequalities on u = (velocity of the centre of mass, angular velocity) [m/s, rad/s;
/// world]: gradient . u <= limit, row by row.
struct VelocityRows {
  int count = 0;
  std::array<std::array<double, kMaxRows>, 6> gradient;  // by unknown, then by row
  // of the speed along the gradient; below 0 the row has to open, and rows may contradict each
  // other, else rest is allowed [m/s]
  std::array<double, kMaxRows> limit;
  std::array<Friction, kMaxRows> friction;
  // two unit directions across the row's normal and the arm they act at [world]; read where there
  // is friction
  std::array<Vec3, kMaxRows> tangent, arm;
};

/// Impulses of the rows, kept from step to step: the warm start, and which of them slid. By row, in
/// the order of the rows.
struct RowImpulses {
  std::array<double, kMaxRows> normal{};                     // [N s]
  std::array<std::array<double, 2>, kMaxRows> tangential{};  // [N s]
  std::array<bool, kMaxRows> is_sliding{};                   // else the static coefficient holds
  std::array<std::int32_t, kMaxActive> active{};             // rows of the last solution
  int active_count = 0;
};

/// What a solve found.
struct RowSolution {
  Vec6 velocity = Vec6::Zero();  // u [m/s, rad/s]
  Vec6 impulse = Vec6::Zero();   // of all rows on the body, about the centre of mass [N s, N m s]
  int active = 0;                // rows that press
  int rounds = 0;                // rows added on the way
  int sweeps = 0;                // over the cones
  // largest speed at which a row is violated [m/s]; rounding where the solve was whole
  double residual = 0.0;
  SlipCount slip;        // of the rows that press
  bool is_whole = true;  // false: rounds ran out, or rows contradict each other
};

/// Velocity nearest to the free one, in the metric of the implicit step, that obeys every row.
///
/// metric    A = M + h B + h^2 K, symmetric positive definite (6 x 6) [kg, kg m, kg m^2]
/// free      u without rows [m/s, rad/s; world]
/// rows      count <= kMaxRows
/// impulses  warm start and result. Zeros are a valid start
/// returns   u = free + A^-1 (impulse). Rest (u = 0) obeys every row, so there is a solution
///           where no limit is negative; where rows with negative limits contradict each other,
///           is_whole is false
/// Thread    [haptic]; no failure, nothing allocated. The same bits for the same input.
/// Source    min 1/2 |u - free|_A^2 subject to the rows, by the dual method of Goldfarb and Idnani
///           (1983): exact, at most six rows press. Friction: projected Gauss-Seidel on the cones
///           of the rows that press, then the normals exactly with the friction impulses held. A
///           row that sticks has the cone of the static coefficient; one that still moves on it
///           slides from there on with the kinetic one, until its impulse lies inside that cone.
RowSolution solve_rows(const Mat6& metric, const Vec6& free, const VelocityRows& rows,
                       RowImpulses& impulses) THIGMA_RT;

}  // namespace thigma
