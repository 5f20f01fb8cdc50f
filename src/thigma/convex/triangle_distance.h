#pragma once
// Distance and intersection of triangles, and of the original triangles of two patches, in double
// precision.

#include "thigma/convex/hull_view.h"
#include "thigma/convex/pair.h"

namespace thigma {

/// Closest points of two triangles.
struct TriangleDistance {
  bool intersecting =
      false;  // they share a point; then distance is 0 and both points are (nearly) that point
  double distance = 0.0;  // [m]
  Vec3 point_a = Vec3::Zero();
  Vec3 point_b = Vec3::Zero();
};

/// Distance of triangles a[0..2] and b[0..2], degenerate ones (segments, points) included. Accuracy: a few
/// roundings of the coordinates about a local origin.
/// Thread    [contact]; no failure.
TriangleDistance triangle_distance(const Vec3 a[3], const Vec3 b[3]) noexcept;

/// Separation of the original triangles of two patches.
struct PatchSeparation {
  bool intersecting = false;    // some pair of original triangles shares a point
  double distance = 0.0;        // least over the triangle pairs, 0 when intersecting [m]
  Vec3 point_a = Vec3::Zero();  // closest points; intersecting: the mean point of the intersections
                                // [frame of a]
  Vec3 point_b = Vec3::Zero();
  int triangle_a = -1,
      triangle_b = -1;  // into the hulls' triangles; -1 farther than stop, points invalid
  std::uint32_t feature_a = 0,
                feature_b =
                    0;     // masks of the hull vertices that span the closest feature; 0 unknown
  int triangle_pairs = 0;  // measured
};

/// Least separation of the original triangles of two patches (not of their hulls, which have
/// virtual faces).
///
/// stop      pairs farther apart than this need not be exact: then distance is a lower bound > stop [m]
/// cache     of the hull pair
/// Thread    [contact]; no failure, no allocation.
PatchSeparation patch_separation(const HullView& a, const HullView& b, const RelativePose& a_from_b,
                                 double stop, GjkCache& cache) noexcept;

}  // namespace thigma
