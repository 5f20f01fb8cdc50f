#pragma once
// Vertices that were meant to be one.

#include <cstdint>
#include <vector>

#include "thigma/mesh/topology.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Distance up to which two vertices count as one, times the radius of the mesh: coordinates
/// written with six digits differ by up to 1e-6, and nothing that is felt is that small.
inline constexpr double kWeldTolerance = 1e-5;

/// And at most this fraction of the shortest edge at either vertex: a feature finer than the
/// tolerance stays open.
inline constexpr double kWeldEdgeFraction = 0.1;

/// Vertices along cracks: pairs of boundary edges whose ends lie within the tolerance of each
/// other. Only those are found, so that welding always closes boundary edges and never touches a
/// closed surface.
struct Welds {
  std::vector<std::int32_t> target;  // vertex to become, itself for most (n)
  std::int64_t count = 0;            // vertices that become another
};

/// radius    of the mesh [m]
/// Thread    [offline]; deterministic.
Welds find_welds(const TriangleMesh& mesh, const EdgeTable& table, double radius);

}  // namespace thigma
