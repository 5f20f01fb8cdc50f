#pragma once
// Distance and intersection of two triangles, in double precision.

#include "thigma/math/types.h"

namespace thigma {

/// Closest points of two triangles.
struct TriangleDistance {
  // they share a point; then distance is 0 and both points are (nearly) that point
  bool intersecting = false;
  double distance = 0.0;  // [m]
  Vec3 point_a = Vec3::Zero();
  Vec3 point_b = Vec3::Zero();
};

/// Distance of triangles a[0..2] and b[0..2], degenerate ones (segments, points) included.
/// Accuracy: a few roundings of the coordinates about a local origin.
/// Thread    [contact]; no failure.
TriangleDistance triangle_distance(const Vec3 a[3], const Vec3 b[3]) noexcept;

}  // namespace thigma
