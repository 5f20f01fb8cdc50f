#pragma once
// Which triangles meet across which edges, and what belongs together.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Planes, neighbours and shells of the triangles of a mesh.
struct SurfaceTopology {
  // across corner i -> corner i + 1; -1: boundary, or an edge of three faces or of two that turn
  // against each other
  std::vector<std::array<std::int32_t, 3>> neighbor;
  std::vector<std::int32_t> shell;  // connected through edges
  std::vector<Vec3> normal;         // unit; zero for triangles without an area to rounding
  std::vector<double> height;       // over the longest edge: the width of a sliver [m]
};

SurfaceTopology compute_topology(const TriangleMesh& mesh);

/// True when an edge of one triangle passes through the inside of the other. Exact; touching is not
/// crossing.
bool triangles_cross(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

}  // namespace thigma
