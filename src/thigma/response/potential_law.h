#pragma once
// A contact force that is the gradient of one energy: an area integral over how deep it lies.

#include "thigma/core/static_vector.h"
#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/math/pose.h"
#include "thigma/response/penalty.h"

namespace thigma {

/// A point of the area of contact.
struct AreaPoint {
  double area = 0.0;         // it stands for [m^2]
  double depth = 0.0;        // w: depth + tolerance, > 0 [m]
  Vec3 push = Vec3::Zero();  // gradient of w by the way of the object [world]
  Vec3 turn = Vec3::Zero();  // and by a rotation vector about its centre of mass [m; world]
  Vec3 arm = Vec3::Zero();   // from the centre of mass [m; world]
};

using Mat7 = Eigen::Matrix<double, 7, 7>;

/// Sums over an area of contact. They add up over bodies.
struct PotentialMoments {
  // integral of w^(p-2) u u^T, u = (w, dw/dx, dw/dturn) by the object's centre of mass and a
  // rotation vector about it [m; world]
  Mat7 sum = Mat7::Zero();
  Vec3 place = Vec3::Zero();  // integral of w^(p-1) arm
  double deepest = 0.0;       // largest w [m]
};

/// exponent  p of the law, 2 or 4
/// Thread    [contact]; no failure.
void add_point(const AreaPoint& point, int exponent, PotentialMoments& moments) noexcept;
/// A triangle with depths of 0 or more at its corners, over which depths and gradients are linear:
/// integrated without error. The corners' areas are not read.
///
/// weight    of its area
void add_triangle(const AreaPoint& a, const AreaPoint& b, const AreaPoint& c, double weight,
                  int exponent, PotentialMoments& moments) noexcept;
void add_moments(const PotentialMoments& other, PotentialMoments& moments) noexcept;

/// The law at a state.
struct PotentialForce {
  double energy = 0.0;            // [J]
  Wrench wrench;                  // on the object about its centre of mass [N, N m; world]
  Mat6 jacobian = Mat6::Zero();   // d(force, torque) by (way, rotation vector), w being linear
  Mat6 curvature = Mat6::Zero();  // -jacobian - F F^T / (2 energy), positive semidefinite
};

/// stiffness  k [N/m]
/// law        area > 0
/// Thread     [contact]; no failure.
/// Source     Phi = k/2 S^(2/p); docs/potential.md.
PotentialForce potential_force(const PotentialMoments& moments, double stiffness,
                               const PotentialLaw& law) noexcept;

/// One-sided springs with the law's energy, force and Jacobian at the state: what the haptic thread
/// evaluates. As the energy is half the square of a convex function of w, they all are as deep as
/// the deepest place and none pulls; two a direction in which the Jacobian is more than one spring
/// has, at most twelve.
///
/// penalty   stiffness k, damping b in the same proportion, tolerance d
/// body_from_world  of the object, for where friction acts
/// terms     appended to; body -1, no friction
/// Thread    [contact]; no failure.
void add_springs(const PotentialMoments& moments, const PenaltyParams& penalty,
                 const PotentialLaw& law, const Mat3& body_from_world,
                 StaticVector<DepthTerm, kMaxClusters>& terms) noexcept;

}  // namespace thigma
