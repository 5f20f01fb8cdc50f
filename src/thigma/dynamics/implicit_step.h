#pragma once
// Semi-implicit backward Euler: one linear solve a step, stable where explicit schemes are not
// (Sec. 5.2).

#include "thigma/dynamics/body.h"

namespace thigma {

/// One step of length dt in tangent form; the step to use.
///
/// body      mass properties; its gravity is added
/// state     y_{n-1}
/// wrench    all that acts but gravity, at `state` and the device sample just read; about the
///           centre of mass [N, N m; world]
/// jacobian  d(force, torque)/dy of that wrench (6 x 13)
/// dt        step length > 0 [s]; any
/// returns   y_n with |q| = 1; not finite when an input is not. Without torque L is kept exactly
/// Thread    [haptic]; no failure.
/// Source    Eqs. 5.6-5.13 with q <- exp(phi) q: a 6 x 6 system in (dP, dL), without the radial
///           quaternion mode.
BodyState implicit_step(const RigidBody& body, const BodyState& state, const Wrench& wrench,
                        const WrenchJacobian& jacobian, double dt) THIGMA_RT;

/// The same, with the kinematics already at hand.
BodyState implicit_step(const BodyAtState& at, const Wrench& wrench, const WrenchJacobian& jacobian,
                        double dt) THIGMA_RT;

/// Eq. 5.7 as printed, all 13 unknowns at once: the twin the tests compare with. [haptic]
BodyState implicit_step_13(const RigidBody& body, const BodyState& state, const Wrench& wrench,
                           const WrenchJacobian& jacobian, double dt) THIGMA_RT;

/// Eq. 5.7 with x and q eliminated exactly: equal to implicit_step_13 but for rounding. [haptic]
BodyState implicit_step_6(const RigidBody& body, const BodyState& state, const Wrench& wrench,
                          const WrenchJacobian& jacobian, double dt) THIGMA_RT;

/// d(dy/dt)/dy (13 x 13, Eqs. 5.8-5.13).
/// Thread    [haptic].
Mat13 state_rate_jacobian(const RigidBody& body, const BodyState& state,
                          const WrenchJacobian& wrench_jacobian) THIGMA_RT;

}  // namespace thigma
