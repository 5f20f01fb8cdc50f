#pragma once
// Semi-implicit backward Euler: one linear solve a step, stable where explicit schemes are not
// (Sec. 5.2).

#include "thigma/dynamics/body.h"

namespace thigma {

/// Sum of all wrenches on the body but gravity, at y_{n-1}, and its derivative.
struct WrenchWithJacobian {
  Wrench wrench;                                     // about the centre of mass [N, N m; world]
  WrenchJacobian jacobian = WrenchJacobian::Zero();  // d(force, torque)/dy
};

/// One step of length dt in tangent form; the step to use.
///
/// body     mass properties; its gravity is added
/// state    y_{n-1}
/// at       kinematics(body, state)
/// forces   evaluated at `state` and at the device sample just read
/// dt       step length > 0 [s]; any
/// returns  y_n with |q| = 1; not finite when an input is not. Keeps L exactly when there is no
/// torque Thread   [haptic]; no failure. Source   Eqs. 5.6-5.13 with q <- exp(phi) q: a 6 x 6
/// system in (dP, dL), without the radial quaternion mode.
BodyState implicit_step(const RigidBody& body, const BodyState& state, const BodyKinematics& at,
                        const WrenchWithJacobian& forces, double dt) THIGMA_RT;
BodyState implicit_step(const RigidBody& body, const BodyState& state,
                        const WrenchWithJacobian& forces, double dt) THIGMA_RT;

/// Eq. 5.7 as printed, all 13 unknowns at once: the twin the tests compare with. Thread [haptic].
BodyState implicit_step_13(const RigidBody& body, const BodyState& state,
                           const WrenchWithJacobian& forces, double dt) THIGMA_RT;

/// Eq. 5.7 with x and q eliminated exactly: equal to implicit_step_13 but for rounding. Thread
/// [haptic].
BodyState implicit_step_6(const RigidBody& body, const BodyState& state,
                          const WrenchWithJacobian& forces, double dt) THIGMA_RT;

/// d(dy/dt)/dy (13 x 13, Eqs. 5.8-5.13). Thread [haptic].
Mat13 state_rate_jacobian(const RigidBody& body, const BodyState& state,
                          const WrenchJacobian& wrench_jacobian) THIGMA_RT;

}  // namespace thigma
