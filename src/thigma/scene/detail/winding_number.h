#pragma once
// Whether a point is inside a closed surface.

#include "thigma/clod/hierarchy.h"

namespace thigma::detail {

/// How often a surface goes around a point: 1 inside a closed one, 0 outside and in its cavities,
/// between them near an open one. Looks at every triangle of the finest level.
///
/// point     not on the surface [m; frame of the hierarchy]
/// Thread    [offline]
/// Source    Van Oosterom and Strackee (1983): the solid angle of a triangle; Jacobson et al.
///           (2013): winding numbers of any triangles
double winding_number(const ClodHierarchy& surface, const Vec3& point);

/// Whether a point lies in the solid that a surface bounds: the winding number is nearer to 1 than
/// an open surface makes it.
bool is_inside(const ClodHierarchy& surface, const Vec3& point);

}  // namespace thigma::detail
