#pragma once
// The depth of textured surfaces to second order: Eq. 5.56 with the Hessian of the depth, which the
// engine leaves out (docs/deviations.md, D79; docs/textures.md).

#include "thigma/dynamics/linear_contact_model.h"

namespace thigma {

/// How the gradient of a depth term changes with the motion: by a way, then a rotation vector about
/// the centre of mass, rows as columns (6 x 6) [1/m, 1/rad, m/rad^2; world]. Not symmetric: the
/// gradient is that of the turned object. DepthHessian::gradient_by_motion is one.
using GradientByMotion = Mat6;

/// Evaluates a depth term at a state, its gradient following the motion: the depth is of second
/// order, the force along the gradient at the state. Nothing where the gradient has turned to the
/// other side, as it is that of no surface near.
///
/// taken_at  state of the model the term is of
/// jacobian  null, or where d(force, torque)/dy is added (6 x 13)
/// Thread    [haptic]; no failure.
/// Source    Eqs. 4.6, 4.7, 5.14, 5.56.
PlaneForce bent_depth_force(const DepthTerm& term, const BodyState& taken_at,
                            const GradientByMotion& bend, const BodyAtState& at,
                            WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// Depth alone, as bent_depth_force has it [m].
/// Thread    [haptic].
double bent_depth_at(const DepthTerm& term, const BodyState& taken_at, const GradientByMotion& bend,
                     const BodyState& state) THIGMA_RT;

}  // namespace thigma
