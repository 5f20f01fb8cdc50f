#pragma once
// Penalty force and torque of textured contacts from their depth and its gradient (Sec. 4.3).

#include "thigma/depth/depth_gradient.h"
#include "thigma/math/pose.h"
#include "thigma/math/types.h"

namespace thigma {

/// Force and torque on the object at the energy U = k depth^2 / 2.
///
/// depth      directional depth [m]; nothing below or at 0
/// gradient   of it; nothing where it is not valid
/// stiffness  k [N/m]
/// returns    -k depth grad(depth) [N; N m about the contact's centre]; world
/// Thread     [contact]; no failure.
/// Source     Eqs. 4.4-4.7.
Wrench texture_wrench(double depth, const DepthGradient& gradient, double stiffness) noexcept;

/// Gauss-Newton Jacobian of that wrench: -k grad grad^T by position and orientation, 0 by the
/// momenta. Never adds energy and needs no second derivatives.
///
/// orientation  q of the object: the columns 3..6 are by its four numbers
/// returns      d(force, torque)/dy (6 x 13)
/// Source       Eqs. 5.51-5.56; corrected: docs/sources.md.
WrenchJacobian texture_jacobian(double depth, const DepthGradient& gradient, double stiffness,
                                const Quat& orientation) noexcept;

/// The same contact's wrench on the scene, if that is what one moves: the reaction, about a point
/// of the scene.
///
/// on_object     as returned by texture_wrench, about object_centre
/// scene_centre  [m; world]
/// Source        Eq. 4.7, "similarly on object B".
Wrench reaction(const Wrench& on_object, const Vec3& object_centre,
                const Vec3& scene_centre) noexcept;

}  // namespace thigma
