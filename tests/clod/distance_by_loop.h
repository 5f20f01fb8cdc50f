#pragma once
// The oracle of searches for the nearest point of a surface.

#include <algorithm>

#include "thigma/convex/quickhull.h"
#include "thigma/core/index.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

/// Distance of p from the nearest triangle, one after the other.
inline double distance_by_loop(const TriangleMesh& mesh, const Vec3& p) {
  double nearest = 1e300;
  for (const auto& t : mesh.triangles)
    nearest = std::min(
        nearest, point_triangle_distance(p, mesh.positions[idx(t[0])], mesh.positions[idx(t[1])],
                                         mesh.positions[idx(t[2])]));
  return nearest;
}

}  // namespace thigma::test
