#pragma once
// Where two patches face each other: the area they share seen along a normal, weighed by how near
// they are.

#include "thigma/convex/gjk.h"
#include "thigma/convex/hull_view.h"

namespace thigma::detail {

/// The shared area as its moments, each point weighing depth + tolerance there.
struct SharedArea {
  double size = 0.0;    // unweighed [m^2]
  double weight = 0.0;  // integral of depth + tolerance [m^3]; 0: nothing is shared
  // weighted mean of the points, on a or beside its hollow [m; frame of a]
  Vec3 middle = Vec3::Zero();
  // Principal axes of the points about the middle, across the normal, as long as their standard
  // deviation; the second is the shorter one [m; frame of a].
  Vec3 axis[2] = {Vec3::Zero(), Vec3::Zero()};
};

/// The part of the plane across `normal` in which a triangle of a that faces along it lies above,
/// or less than `tolerance` below, one of b that faces against it. Integrals are exact: depth is
/// linear wherever two triangles share the plane. Triangles seen at more than 84 degrees are left
/// out.
///
/// normal  unit, out of a [frame of a]
/// least_width  areas whose points deviate from their middle by no more, root mean square, need not
///              be found [m]
/// Thread  [contact]; no failure, no allocation.
SharedArea shared_area(const HullPair& pair, const Vec3& normal, double tolerance,
                       double least_width = 0.0) noexcept;

}  // namespace thigma::detail
