#pragma once
// The part of a patch's hull that is surface: its faces, edges and triangles by local vertex.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/convex/hull_view.h"
#include "thigma/mesh/surface_topology.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::detail {

struct PatchFeatures {
  std::vector<RealFace> faces;
  std::vector<RealEdge> edges;
  std::vector<HullTriangle> triangles;  // in the order given
  double thickness = 0.0;               // [m]
};

/// Features of one patch.
///
/// surface    of the mesh: what lies across the edges where the patch ends
/// triangles  of the patch, indices into the mesh
/// vertices   every position they use, ascending; local vertex i is vertices[i]; at most 32
/// flat       height that still counts as in the plane [m]
/// Thread     [offline]; no failure.
PatchFeatures find_features(const TriangleMesh& mesh, const SurfaceTopology& surface,
                            std::span<const std::int32_t> triangles,
                            std::span<const std::int32_t> vertices, double flat);

}  // namespace thigma::detail
