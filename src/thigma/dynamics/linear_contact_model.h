#pragma once
// The whole contact world as the haptic thread sees it: at most K terms, re-evaluated at any state.

#include <cstdint>

#include "thigma/core/static_vector.h"
#include "thigma/dynamics/body.h"

namespace thigma {

inline constexpr int kMaxClusters = 16;

/// Viscoelastic plane, Eq. 5.37 evaluated exactly at the current state (not its Taylor expansion:
/// same cost, no truncation, and the clamp against pulling is natural).
struct PlaneTerm {
  Vec3 arm_body = Vec3::Zero();        // r: contact point from the centre of mass [m; body frame]
  Vec3 normal = Vec3::UnitZ();         // n: unit, out of the object [world]
  Vec3 scene_point = Vec3::Zero();     // p_0 on the plane [m; world]
  Vec3 scene_velocity = Vec3::Zero();  // of p_0 [m/s; world]; zero while the scene is static
  Vec3 tangential_anchor = Vec3::Zero();  // room for friction [m; world]; unused
  double stiffness = 0.0;                 // k [N/m]
  double damping = 0.0;                   // b [N s/m]
  double tolerance = 0.0;                 // d: force starts at depth = -d [m]
  bool is_unilateral = true;              // never pulls; false: a glued spring, for tests
  std::int32_t id = -1;                   // of the cluster, persistent over frames
};

/// First-order term, for texture forces: wrench and Jacobian at the model's state.
struct TaylorTerm {
  Wrench wrench;                                     // about the centre of mass [N, N m; world]
  WrenchJacobian jacobian = WrenchJacobian::Zero();  // d(force, torque)/dy
  Vec3 normal = Vec3::UnitZ();  // the term is dropped when its extrapolation pulls along it
};

/// Payload from the contact thread to the haptic thread.
struct LinearContactModel {
  BodyState state;             // y_0 the model was taken at
  double time = 0.0;           // of y_0 on the session's clock [s]
  std::uint64_t sequence = 0;  // counts publications; 0 = none yet
  StaticVector<PlaneTerm, kMaxClusters> planes;
  StaticVector<TaylorTerm, 4> taylors;
};
static_assert(RtPayload<LinearContactModel>);

/// One plane term at one state.
struct PlaneForce {
  double depth = 0.0;  // n . (x + R r - p_0) [m]; positive = penetrating
  double magnitude =
      0.0;  // k (depth + d) + b n . (velocity relative to the scene) [N]; > 0 pushes along -n
  bool is_active = false;  // unilateral terms: depth + d > 0 and magnitude > 0
  Wrench wrench;           // about the centre of mass [N, N m; world]; zero when inactive
};

/// Evaluates a plane term exactly at a state.
///
/// at        kinematics(body, state)
/// jacobian  null, or where `scale` times d(force, torque)/dy is added (6 x 13)
/// Thread    [haptic]; no failure.
/// Source    Eqs. 5.36-5.46, corrected: omega x (R r), clamp.
PlaneForce plane_force(const PlaneTerm& term, const RigidBody& body, const BodyState& state,
                       const BodyKinematics& at, double scale = 1.0,
                       WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// Wrench of a Taylor term, taken at state y_0, at a state y: W + J (y - y_0), where -q stands for q when
/// it is the nearer of the two (Eq. 5.14). Not clamped. `jacobian`: null, or the Jacobian at y (6 x 13).
/// Thread    [haptic].
Wrench extrapolate(const TaylorTerm& term, const BodyState& taken_at, const BodyState& state,
                   WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// Wrench of the model on the body at a state, and its Jacobian.
///
/// model     terms; those that would pull contribute nothing
/// scale     0..1, fading of a stale model: multiplies the wrench and the Jacobian
/// jacobian  null, or d(force, torque)/dy (6 x 13)
/// returns   force [N] and torque about the centre of mass [N m]; world
/// Thread    [haptic]; no failure.
/// Source    Eqs. 5.14, 5.37-5.46 as corrected in docs/deviations.md.
Wrench contact_wrench(const LinearContactModel& model, const RigidBody& body,
                      const BodyState& state, double scale = 1.0,
                      WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// The same, with kinematics(body, state) already at hand.
Wrench contact_wrench(const LinearContactModel& model, const RigidBody& body,
                      const BodyState& state, const BodyKinematics& at, double scale,
                      WrenchJacobian* jacobian) THIGMA_RT;

}  // namespace thigma
