#pragma once
// Motion of a rigid body between collisions: a parabola and the rotation of a free body, or under a
// constant push.

#include "thigma/dynamics/body.h"

namespace thigma {

/// Kinetic energy less the work gravity still has to give: constant between collisions [J].
double mechanical_energy(const RigidBody& body, const BodyState& state) noexcept;

/// The state a time later, under gravity alone.
///
/// Positions and momenta are exact to rounding. Orientation follows Eq. 5.2 by steps of the
/// fourth-order Runge-Kutta scheme of at most 0.05 rad, after each of which the body is turned, by
/// less than the error of the step, to where its kinetic energy is that of the start: energy does
/// not drift, however many steps are made.
/// time     >= 0 [s]
/// Thread   any; no failure. A time that takes more than 100,000 steps is cut into that many.
BodyState free_motion(const RigidBody& body, const BodyState& state, double time) noexcept;

/// The same under gravity and a constant wrench about the centre of mass [world].
///
/// Position and momenta are exact to rounding; the body turns as a free one does with the momentum
/// at half the time, so that orientation is right to second order.
BodyState pushed_motion(const RigidBody& body, const BodyState& state, const Wrench& push,
                        double time) noexcept;

}  // namespace thigma
