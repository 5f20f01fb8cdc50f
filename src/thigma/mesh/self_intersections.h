#pragma once
// Where a surface meets itself.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct SelfIntersections {
  std::int64_t pairs = 0;  // pairs of triangles that meet other than at shared vertices or edges
  bool complete = true;    // false: stopped at the limit below, then pairs is a lower bound
  // the pairs, smaller index first, ascending; when asked for
  std::vector<std::array<std::int32_t, 2>> found;
};

/// Counts the pairs of triangles with a point in common beyond the vertices or the edge they share.
/// Touching counts, coplanar overlap counts, triangles of the same three vertices count; zero-area
/// triangles are left out. Exact.
///
/// mesh      finite positions, valid indices; positions that are equal must have one index (as
///           read_mesh leaves them)
/// collect   also list the pairs
/// Thread    [offline]. Stops after 1000 box tests a triangle (and 1e8): a heap of n equal
///           triangles has n^2 / 2 pairs.
SelfIntersections find_self_intersections(const TriangleMesh& mesh, bool collect = false);

}  // namespace thigma
