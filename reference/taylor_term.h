#pragma once
// A contact as the text hands it to the haptic thread: wrench and Jacobian at one state, followed
// to first order (Eq. 5.14). The engine hands over planes and depths (docs/deviations.md, D8, D81).

#include "thigma/dynamics/body.h"

namespace thigma {

/// First-order term: wrench and Jacobian at the state it was taken at.
struct TaylorTerm {
  Wrench wrench;                                     // about the centre of mass [N, N m; world]
  WrenchJacobian jacobian = WrenchJacobian::Zero();  // d(force, torque)/dy
  Vec3 normal = Vec3::UnitZ();  // of the contact, out of the object: nothing may pull along it
};

/// Wrench of a Taylor term, taken at state y_0, at a state y: W + J (y - y_0), where -q stands for
/// q when it is the nearer of the two (Eq. 5.14). Not clamped.
///
/// jacobian  null, or the Jacobian at y (6 x 13)
/// Thread    [haptic].
Wrench extrapolate(const TaylorTerm& term, const BodyState& taken_at, const BodyState& state,
                   WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// The same, dropped where it would pull: no wrench and no Jacobian then.
/// Thread    [haptic].
Wrench pushing_wrench(const TaylorTerm& term, const BodyState& taken_at, const BodyState& state,
                      WrenchJacobian* jacobian = nullptr) THIGMA_RT;

}  // namespace thigma
