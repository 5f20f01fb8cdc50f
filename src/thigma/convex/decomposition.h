#pragma once
// Convex surface decomposition: every triangle in one patch, every patch on its convex hull.

#include <cstdint>
#include <vector>

#include "thigma/convex/hull.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct DecompositionParams {
  int max_vertices = 32;              // of a patch's hull; kMaxHullVertices at most
  double convexity_tolerance = 1e-9;  // height over a face plane that still counts as flat, times the mesh radius
  double protrusion_tolerance = 1e-7; // hull planes are moved inwards by this times the mesh radius before the clip test
  // Defaults for double-precision input; single-precision CAD files want 1e-6 and 1e-5 (their coplanar faces are
  // off by rounding). decompose_surface picks by the data when these are negative.
};

/// A decomposition of the triangles of one mesh.
/// Invariant: patches partition the triangles that have an area; interior edges are convex or flat; the triangles of
/// a patch lie on its hull; the hull does not enter the object in front of the surface (within the tolerances).
struct ConvexDecomposition {
  std::vector<std::int32_t> patch_of_triangle;         // -1 for zero-area triangles (m)
  std::vector<std::vector<std::int32_t>> patches;      // triangle indices, ascending
  std::vector<ConvexHull> hulls;                       // one a patch; source indexes the mesh's positions
  std::int32_t cut_by_self_intersection = 0;           // patches kept small because the surface crosses itself there
  std::int32_t cut_by_protrusion = 0;                  // patches in which the protrusion test refused a triangle
  std::int32_t cut_by_size = 0;                        // patches stopped by max_vertices
};

/// Decomposes a usable mesh (3.3.1). BFS in face order, deterministic.
/// Thread [offline]; throws InputError when the mesh has no triangle with an area.
/// Source Sec. 3.3.1; protrusion by exact clipping instead of sampling (docs/deviations.md).
ConvexDecomposition decompose_surface(const TriangleMesh& mesh, const DecompositionParams& params = {});

}  // namespace thigma
