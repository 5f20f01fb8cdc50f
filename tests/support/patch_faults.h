#pragma once
// What keeps triangles from being convex patches, counted by other means than patches are built
// with.

#include <cstdint>
#include <vector>

#include "thigma/mesh/surface_topology.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::detail {

/// A mesh in patches.
struct PatchView {
  const TriangleMesh& mesh;
  const SurfaceTopology& surface;                // of the mesh
  const std::vector<std::int32_t>& patch_of;     // of each triangle, -1 none
  const std::vector<std::vector<Vec3>>& points;  // of each patch: those its triangles use [m]
  double flat = 0.0, inset = 0.0;                // [m]
};

struct PatchFaults {
  std::int64_t reflex_edges = 0;  // inside a patch, by more than `flat`
  std::int64_t off_hull = 0;      // triangles with a point of their patch over their plane
  // whose hull, moved inwards, a triangle of the same shell that is not theirs reaches into
  std::int64_t protruding_patches = 0;
};

/// Thread [offline]; no failure.
PatchFaults count_patch_faults(const PatchView& view);

}  // namespace thigma::detail
