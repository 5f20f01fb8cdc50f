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

/// Depth of textured surfaces to first order in the object's motion, with its viscoelastic force
/// along the gradient. The depth is evaluated at the current state, so that the clamp against
/// pulling is natural; the gradient is that of the model's state (Gauss-Newton).
struct DepthTerm {
  double depth = 0.0;           // at the model's state [m]; positive = penetrating
  Vec3 linear = Vec3::Zero();   // gradient by the position of the centre of mass [-; world]
  Vec3 angular = Vec3::Zero();  // and by a rotation vector about it [m/rad; world]
  double stiffness = 0.0;       // k [N/m]
  double damping = 0.0;         // b [N s/m]
  double tolerance = 0.0;       // d: force starts at depth = -d [m]
  std::int32_t id = -1;         // of the cluster, persistent over frames
};

/// How the gradient of a depth term changes with the motion: by a way, then a rotation vector about
/// the centre of mass, rows as columns (6 x 6) [1/m, 1/rad, m/rad^2; world]. Not symmetric: the
/// gradient is that of the turned object.
using DepthBend = Mat6;

/// First-order term: wrench and Jacobian at the model's state.
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
  StaticVector<DepthTerm, kMaxClusters> depths;
  StaticVector<DepthBend, 8> bends;  // of the first depth terms; the others are of first order
  StaticVector<TaylorTerm, 4> taylors;
};
static_assert(RtPayload<LinearContactModel>);

/// One plane or depth term at one state.
struct PlaneForce {
  double depth = 0.0;      // n . (x + R r - p_0), or of the textures [m]; positive = penetrating
  double magnitude = 0.0;  // k (depth + d) + b times the rate of the depth [N]; > 0 pushes along -n
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

/// Evaluates a depth term at a state: with g = (linear, angular), depth + g . (way moved, 2 vec(q
/// q_0^-1)) is the depth, -(k (depth + d) + b g . velocity) g the wrench.
///
/// taken_at  state of the model the term is of
/// bend      null: the gradient stays as it is, and the Jacobian is Eq. 5.56 without the Hessian of
///           the depth; or how it changes: the depth is of second order then, the force along the
///           gradient at the state
/// others    as of plane_force
/// Thread    [haptic]; no failure.
/// Source    Eqs. 4.6, 4.7, 5.14, 5.56. Deviates: D79, D81.
PlaneForce depth_force(const DepthTerm& term, const BodyState& taken_at, const RigidBody& body,
                       const BodyState& state, const BodyKinematics& at, double scale = 1.0,
                       WrenchJacobian* jacobian = nullptr,
                       const DepthBend* bend = nullptr) THIGMA_RT;

/// Bend of depth term i, null without one.
/// Thread    [haptic].
inline const DepthBend* bend_of(const LinearContactModel& model, std::size_t i) THIGMA_RT {
  return i < model.bends.size() ? &model.bends[i] : nullptr;
}

/// Depth alone, as depth_force has it [m].
/// Thread    [haptic].
double depth_at(const DepthTerm& term, const BodyState& taken_at, const BodyState& state,
                const DepthBend* bend = nullptr) THIGMA_RT;

/// Wrench of a Taylor term, taken at state y_0, at a state y: W + J (y - y_0), where -q stands for
/// q when it is the nearer of the two (Eq. 5.14). Not clamped. `jacobian`: null, or the Jacobian at
/// y (6 x 13).
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
