#pragma once
// The way out of a penetration: the direction of least overlap among those that real faces and
// edges allow.

#include <limits>

#include "thigma/convex/detail/corners.h"

namespace thigma::detail {

/// Two patches in the frame of a, about the centre of a.
struct PlacedPair {
  const HullView& a;
  const HullView& b;
  const RelativePose& pose;
  Vec3 origin;
  Corners pa, pb;

  explicit PlacedPair(const HullPair& pair)
      : a(pair.a), b(pair.b), pose(pair.a_from_b), origin(a.center) {
    place_corners(a, origin, pa);
    place_corners(b, pose, origin, pb);
  }
};

/// How far the hulls reach along a direction.
struct Extent {
  double top_a, bottom_b;  // max_a n.p, min_b n.p about the local origin [m]
  double overlap() const { return top_a - bottom_b; }
};

inline Extent extent_along(const PlacedPair& p, const Vec3& n) {
  return {top_along(p.pa, n), bottom_along(p.pb, n)};
}

/// A direction and the overlap along it.
struct WayOut {
  Vec3 normal = Vec3::UnitZ();
  double overlap = std::numeric_limits<double>::infinity();
};

/// The allowed direction of least overlap (see pair_contact); of equal ones the first of faces of
/// a, faces of b, edges.
/// last  null, or a direction: of those within 5 % of the least, itself among them, the one nearest
///       to it
WayOut least_overlap(const PlacedPair& p, const Vec3* last);

}  // namespace thigma::detail
