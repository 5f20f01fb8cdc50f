#pragma once
// The grasped body: what never changes of it, and its state y.

#include "thigma/core/rt.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Mass properties. Constant.
struct RigidBody {
  double mass = 0.0;                        // [kg]
  Mat3 inertia = Mat3::Identity();          // about the centre of mass [kg m^2; body frame]
  Mat3 inverse_inertia = Mat3::Identity();  // of the above; set by make_body
  Vec3 gravity = Vec3::Zero();              // acceleration [m/s^2; world]
};

/// y = (x, q, P, L), 13 numbers in this order, world frame (Sec. 5.1.3).
/// Invariant: |orientation| = 1 to 1e-9. position is that of the centre of mass.
struct BodyState {
  Vec3 position = Vec3::Zero();          // x [m]
  Quat orientation = Quat::Identity();   // q, world from body
  Vec3 linear_momentum = Vec3::Zero();   // P [kg m/s]
  Vec3 angular_momentum = Vec3::Zero();  // L about the centre of mass [kg m^2/s]
};

/// What every force law needs of a state, computed once for all of them.
struct BodyKinematics {
  Mat3 rotation = Mat3::Identity();     // R(q), world from body
  Mat3 inverse_inertia = Mat3::Zero();  // R M^-1 R^T = d omega/dL [1/(kg m^2); world]
  Twist velocity;                       // of the centre of mass, and omega (Eq. 5.2) [world]
  Mat34 angular_velocity_by_q = Mat34::Zero();  // d omega/dq at fixed L (Eq. 5.13)
};

/// A body at a state, with what every force law needs of it. Refers to both.
struct BodyAtState {
  const RigidBody& body;
  const BodyState& state;
  BodyKinematics kinematics;
};

/// Body of this mass [kg], inertia tensor [kg m^2; body frame] and gravity [m/s^2; world].
/// Throws InputError unless the mass is positive and the tensor symmetric positive definite.
/// Thread [offline].
RigidBody make_body(double mass, const Mat3& inertia, const Vec3& gravity = Vec3::Zero());

/// Velocity of the centre of mass and angular velocity (Eq. 5.2), world.
/// Thread    [haptic].
Twist velocity(const RigidBody& body, const BodyState& state) THIGMA_RT;

/// The same and its derivatives; R(q) is the homogeneous form, so |q| = 1 matters.
/// Thread    [haptic].
BodyKinematics kinematics(const RigidBody& body, const BodyState& state) THIGMA_RT;
inline BodyAtState at_state(const RigidBody& body, const BodyState& state) THIGMA_RT {
  return {body, state, kinematics(body, state)};
}

/// Kinetic energy of translation and rotation [J].
/// Thread    [haptic].
double kinetic_energy(const RigidBody& body, const BodyState& state) THIGMA_RT;

/// dy/dt under a wrench about the centre of mass; gravity is added here, nowhere else (Eq. 5.1).
/// Thread [haptic].
Vec13 state_rate(const RigidBody& body, const BodyState& state, const Wrench& wrench) THIGMA_RT;

/// y as a vector and back.
/// Thread    [haptic].
Vec13 to_vector(const BodyState& state) THIGMA_RT;
BodyState from_vector(const Vec13& y) THIGMA_RT;

}  // namespace thigma
