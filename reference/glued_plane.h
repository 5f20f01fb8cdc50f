#pragma once
// The plane of Eq. 5.37 without the clamp against pulling: a spring and damper glued to the plane.

#include "thigma/dynamics/linear_contact_model.h"

namespace thigma {

/// As plane_force, but active at any depth and in either direction.
///
/// jacobian  null, or where d(force, torque)/dy is added (6 x 13)
/// Thread    [haptic]; no failure.
/// Source    Eqs. 5.36-5.46, corrected: omega x (R r).
PlaneForce glued_plane_force(const PlaneTerm& term, const BodyAtState& at,
                             WrenchJacobian* jacobian = nullptr) THIGMA_RT;

}  // namespace thigma
