#pragma once
// Coulomb friction of a solve: the cones of the rows that press, by projected Gauss-Seidel.

#include <array>

#include "thigma/dynamics/detail/nearest_point.h"

namespace thigma::detail {

/// A row that may press, with its two tangents, in white coordinates.
struct Cone {
  int row = -1;
  bool has_friction = false;
  bool is_sliding = false;
  double friction = 0.0;   // its coefficient now
  double limit = 0.0;      // of the row
  double per_press = 0.0;  // impulse for a unit of the normal's multiplier
  Vec6 normal = Vec6::Zero(), first = Vec6::Zero(), second = Vec6::Zero();
  double tangent_square = 0.0;                     // the larger of the two tangents' squares
  double by_tangent = 0.0;                         // one over it
  double normal_first = 0.0, normal_second = 0.0;  // products with the normal
  // multipliers: of the unit normal, and of the tangents [N s]
  double press = 0.0, hold_first = 0.0, hold_second = 0.0;
};

/// Rows whose cones a solve looks at. What does not fit has no friction: more rows than press.
struct Cones {
  int count = 0;
  std::array<Cone, 64> cone;
};

/// What a solve over the cones works on.
struct ConeWork {
  const VelocityRows& rows;
  const WhiteRows& white;
  const Mat6& inverse;      // Factor::inverse
  const RowImpulses& warm;  // start
};

/// Adds the cone of a row, with the impulses it starts from; nothing where it is there or there is
/// no room.
/// Thread [haptic].
void add_cone(const ConeWork& work, int row, Cones& cones) THIGMA_RT;

/// Sweeps over the cones until y stays or there have been enough; rows that turn out to be violated
/// are taken in. Returns the sweeps.
/// Thread [haptic].
int solve_cones(const ConeWork& work, const Vec6& target, Cones& cones) THIGMA_RT;

/// Friction impulses on y, scaled.
/// Thread [haptic].
Vec6 friction_pull(const Cones& cones, double scale) THIGMA_RT;

/// Share of their friction that the cones of these normals allow in all: the normals found exactly
/// may press less than those of the sweeps.
/// Thread [haptic].
double allowed_share(const ConeWork& work, const Nearest& nearest, const Cones& cones) THIGMA_RT;

/// Friction impulse of a row [N s].
double hold_of(const Cone& c) THIGMA_RT;

/// Whether friction is within the cone: nothing slides. Thread [haptic].
bool is_held(const Cone& c) THIGMA_RT;

/// How friction, scaled, held at the end of a solve.
/// Thread [haptic].
SlipCount count_slip(const Cones& cones, double scale, const Vec6& y) THIGMA_RT;

}  // namespace thigma::detail
