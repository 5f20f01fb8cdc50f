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

/// One patch of a mesh.
struct PatchOfMesh {
  const TriangleMesh& mesh;
  const SurfaceTopology& topology;          // what lies across the edges where the patch ends
  std::span<const std::int32_t> triangles;  // indices into the mesh, ascending
  // every position they use, ascending; local vertex i is vertices[i]; at most 32
  std::span<const std::int32_t> vertices;
};

/// Features of one patch.
/// flat    height that still counts as in the plane [m]
/// Thread  [offline]; no failure.
PatchFeatures find_features(const PatchOfMesh& patch, double flat);

}  // namespace thigma::detail
