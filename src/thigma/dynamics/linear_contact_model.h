#pragma once
// The whole contact world as the haptic thread sees it: at most K terms, re-evaluated at any state.

#include <cstdint>

#include "thigma/core/static_vector.h"
#include "thigma/dynamics/body.h"
#include "thigma/dynamics/constraint_model.h"

namespace thigma {

inline constexpr int kMaxClusters = 16;

/// Viscoelastic plane, Eq. 5.37 evaluated exactly at the current state (not its Taylor expansion:
/// same cost, no truncation, and the clamp against pulling is natural).
struct PlaneTerm {
  Vec3 arm_body = Vec3::Zero();        // r: contact point from the centre of mass [m; body frame]
  Vec3 normal = Vec3::UnitZ();         // n: unit, out of the object [world]
  Vec3 scene_point = Vec3::Zero();     // p_0 on the plane [m; world]
  Vec3 scene_velocity = Vec3::Zero();  // of p_0 [m/s; world]; zero while the scene is static
  double stiffness = 0.0;              // k [N/m]
  double damping = 0.0;                // b [N s/m]
  double tolerance = 0.0;              // d: force starts at depth = -d [m]
  std::int32_t id = -1;                // of the cluster, persistent over frames
  std::int32_t body = 0;               // static object of the scene
  Friction friction{};                 // of the two materials
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
  std::int32_t body = 0;        // static object of the scene
  Friction friction{};          // of the two materials
  // where friction acts: from the centre of mass [m; body frame]
  Vec3 arm_body = Vec3::Zero();
};

/// Payload from the contact thread to the haptic thread.
struct LinearContactModel {
  BodyState state;             // y_0 the model was taken at
  double time = 0.0;           // of y_0 on the session's clock [s]
  std::uint64_t sequence = 0;  // counts publications; 0 = none yet
  StaticVector<PlaneTerm, kMaxClusters> planes;
  StaticVector<DepthTerm, kMaxClusters> depths;
  // instead of planes and depths, where the object must not enter
  ConstraintModel constraints;
};
static_assert(RtPayload<LinearContactModel>);

inline constexpr int kMaxBristles = 2 * kMaxClusters;

/// Bristles as a step has left them, by the terms they are of: the next step takes them up,
/// whatever model it has.
struct BristleMemory {
  struct Entry {
    std::int32_t id = -1, body = 0;  // of the term
    bool is_relief = false;          // it is a depth term
    bool is_sliding = false;         // else the static coefficient holds
    double stiffness = 0.0;          // k_t when it was bent [N/m]
    Vec3 normal = Vec3::UnitZ();     // it lies across this, unit [world]
    // e: how far the object is from where the bristle was straight [m; world]
    Vec3 bend = Vec3::Zero();
  };
  StaticVector<Entry, kMaxBristles> entries;
  Wrench wrench;   // on the body at the end of the step, about the centre of mass [N, N m; world]
  SlipCount slip;  // of the step
};
static_assert(RtPayload<BristleMemory>);

/// One plane or depth term at one state.
struct PlaneForce {
  double depth = 0.0;      // n . (x + R r - p_0), or of the textures [m]; positive = penetrating
  double magnitude = 0.0;  // k (depth + d) + b times the rate of the depth [N]; > 0 pushes along -n
  bool is_active = false;  // depth + d > 0 and magnitude > 0: it never pulls
  Wrench wrench;           // about the centre of mass [N, N m; world]; zero when inactive
};

/// Evaluates a plane term exactly at a state.
///
/// jacobian  null, or where `scale` times d(force, torque)/dy is added (6 x 13)
/// Thread    [haptic]; no failure.
/// Source    Eqs. 5.36-5.46, corrected: omega x (R r), clamp.
PlaneForce plane_force(const PlaneTerm& term, const BodyAtState& at, double scale = 1.0,
                       WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// The matrix that takes q to the rotation vector from q_0 to q to second order, 2 vec(q q_0^-1),
/// with -q for q when that is nearer.
/// Thread    [haptic].
Mat34 turn_by_orientation(const Quat& from, const Quat& to) THIGMA_RT;

/// Motion between two states as depth terms have it: the way of the centre of mass, and `turn`
/// times the orientation [m; -].
/// Thread    [haptic].
Vec6 motion_between(const BodyState& from, const BodyState& to, const Mat34& turn) THIGMA_RT;

/// Evaluates a depth term at a state: with g = (linear, angular), depth + g . (way moved, 2 vec(q
/// q_0^-1)) is the depth, -(k (depth + d) + b g . velocity) g the wrench. The gradient stays as it
/// is: the Jacobian is Eq. 5.56 without the Hessian of the depth (reference/bent_depth.h has it).
///
/// taken_at  state of the model the term is of
/// others    as of plane_force
/// Thread    [haptic]; no failure.
/// Source    Eqs. 4.6, 4.7, 5.14, 5.56. Deviates: D79, D81.
PlaneForce depth_force(const DepthTerm& term, const BodyState& taken_at, const BodyAtState& at,
                       double scale = 1.0, WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// Depth alone, as depth_force has it [m].
/// Thread    [haptic].
double depth_at(const DepthTerm& term, const BodyState& taken_at, const BodyState& state) THIGMA_RT;

/// Wrench of the model on the body at a state, and its Jacobian.
///
/// model     terms; those that would pull contribute nothing
/// scale     0..1, fading of a stale model: multiplies the wrench and the Jacobian
/// jacobian  null, or d(force, torque)/dy (6 x 13)
/// returns   force [N] and torque about the centre of mass [N m]; world
/// Thread    [haptic]; no failure.
/// Source    Eqs. 5.37-5.46 as corrected in docs/deviations.md.
Wrench contact_wrench(const LinearContactModel& model, const RigidBody& body,
                      const BodyState& state, double scale = 1.0,
                      WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// The same, with the kinematics already at hand.
Wrench contact_wrench(const LinearContactModel& model, const BodyAtState& at, double scale = 1.0,
                      WrenchJacobian* jacobian = nullptr) THIGMA_RT;

}  // namespace thigma
