#pragma once
// Convex hull of a point set, degenerate ones included.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/math/types.h"

namespace thigma {

/// Hull of a finite, non-empty point set.
/// Invariant: vertices are extreme points in the order of the input; triangles are
/// counter-clockwise seen from outside and closed for dimension 3; a flat hull (dimension 2) lists
/// its triangles on both sides; dimensions 0 and 1 have no triangle.
struct ConvexHull {
  std::vector<Vec3> vertices;                          // [m; frame of the input]
  std::vector<std::int32_t> source;                    // index in the input of each vertex
  std::vector<std::array<std::int32_t, 3>> triangles;  // into vertices
  int dimension = 0;                                   // 0 point, 1 segment, 2 flat, 3 solid
};

/// Convex hull of points.
///
/// points              at least one, finite [m]
/// relative_tolerance  points not higher than this times the extent of the set over every face
///                     count as inside; at least 1e-12
/// returns             the hull; no input point is higher than the tolerance over a face
/// Thread              [offline]; throws InputError on an empty or non-finite set.
ConvexHull build_hull(std::span<const Vec3> points, double relative_tolerance = 1e-10);

struct Quickhull;

/// The hull as it has grown so far over the points it was started with.
/// Thread    [offline]; no failure.
ConvexHull to_hull(const Quickhull& grown, std::span<const Vec3> points);

}  // namespace thigma
