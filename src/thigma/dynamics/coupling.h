#pragma once
// The virtual coupling: a six-dimensional spring and damper between the hand and the grasped body
// (Sec. 5.3).

#include <optional>

#include "thigma/dynamics/body.h"

namespace thigma {

/// Spring whose force levels off: linear up to linear_range, then a cubic to max_force at
/// full_range, then constant (Fig. 5.4). Lengths are [m] and forces [N], or [rad] and [N m] for the
/// angular spring.
struct Saturation {
  double stiffness = 0.0;     // k_0
  double linear_range = 0.0;  // x_1
  double full_range = 0.0;    // x_2 > x_1
  double max_force = 0.0;     // F_max >= stiffness * linear_range
};

/// A saturation whose cubic has no inflection: x_2 = x_1 + 2 (F_max - k_0 x_1) / k_0.
/// Throws InputError unless stiffness > 0, linear_range >= 0, max_force > stiffness * linear_range.
/// Thread [offline].
Saturation make_saturation(double stiffness, double linear_range, double max_force);

/// Whether the force never decreases with the stretch.
/// Thread    [haptic].
bool is_monotone(const Saturation& spring) THIGMA_RT;

/// Force at a stretch >= 0 and its slope.
/// Thread    [haptic].
struct SpringForce {
  double force = 0.0;
  double slope = 0.0;
};
SpringForce spring_force(const Saturation& spring, double stretch) THIGMA_RT;

/// Force along a stretch vector and its symmetric derivative by the vector (Eqs. 5.30-5.31).
/// Thread [haptic].
struct SpringVector {
  Vec3 force = Vec3::Zero();
  Mat3 stiffness = Mat3::Zero();
};
SpringVector spring_force(const Saturation& spring, const Vec3& stretch) THIGMA_RT;

/// Gains of the coupling and where the hand holds the body. Changes only at grasp and release.
struct Coupling {
  double linear_stiffness = 0.0;                 // k_c [N/m]
  double linear_damping = 0.0;                   // b_c [N s/m]
  double angular_stiffness = 0.0;                // k_theta [N m/rad]
  double angular_damping = 0.0;                  // b_theta [N m s/rad]
  Pose body_from_grasp;                          // c and q_c: the handle as it was taken hold of
  bool is_grasped = true;                        // released: no wrench on either side
  std::optional<Saturation> linear_saturation;   // when set, its stiffness stands for k_c
  std::optional<Saturation> angular_saturation;  // when set, its stiffness stands for k_theta
};

/// Grasp frame for a hand that takes hold of the body as both are now: both springs start at rest,
/// wherever the hand is (Eq. 5.17).
/// Thread    [haptic].
Pose grasp(const BodyState& state, const Pose& world_from_device) THIGMA_RT;

/// Takes hold, or lets go, at run time.
/// Thread    [haptic].
void grasp(Coupling& coupling, const BodyState& state, const Pose& world_from_device) THIGMA_RT;
void release(Coupling& coupling) THIGMA_RT;

/// The coupling of a hand that counts only by `weight`, 1 to 0: springs weaker by it at every
/// stretch; dampers as they are, so that what the springs let go of comes to rest. A weight of 1
/// changes no bit.
/// Thread    [haptic].
Coupling faded(const Coupling& coupling, double weight) THIGMA_RT;

/// Stretch of both springs: from the grasp point to the hand [m; world] and the rotation vector u_c
/// that turns the grasp frame onto the hand's, the shorter way [rad; world], with du_c/dq
/// (Eqs. 5.18-5.20, 5.25 corrected).
struct CouplingStretch {
  Vec3 linear = Vec3::Zero();
  Vec3 angular = Vec3::Zero();
  Mat34 angular_by_q = Mat34::Zero();
};
CouplingStretch coupling_stretch(const Coupling& coupling, const Pose& world_from_device,
                                 const BodyState& state) THIGMA_RT;

/// Wrench of the virtual coupling on the grasped body, about its centre of mass.
///
/// coupling  gains and grasp frame
/// device    pose and twist of the hand [m, rad, m/s, rad/s; world]
/// body      mass properties
/// state     y = (x, q, P, L), |q| = 1 to 1e-9
/// jacobian  null, or d(force, torque)/dy (6 x 13)
/// returns   force [N], torque [N m]; world. Zero when released.
/// Thread    [haptic]; no failure. The torque jumps where hand and body are half a turn apart.
/// Source    Sec. 5.3.1-5.3.2, Eqs. 5.15-5.31, corrected: omega x (R c), rotation vector.
Wrench coupling_wrench(const Coupling& coupling, const Motion& device, const RigidBody& body,
                       const BodyState& state, WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// The same, with the kinematics already at hand.
Wrench coupling_wrench(const Coupling& coupling, const Motion& device, const BodyAtState& at,
                       WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// What the hand feels: the reaction of both springs and dampers about the handle [N, N m; world].
/// This is not the negative of coupling_wrench, whose torque is about the centre of mass and holds
/// the lever arm of the force.
/// Thread    [haptic].
Wrench coupling_reaction(const Coupling& coupling, const Motion& device, const RigidBody& body,
                         const BodyState& state) THIGMA_RT;

}  // namespace thigma
