#pragma once
// Convex surface decomposition: every triangle in one patch, every patch on its convex hull.

#include <cstdint>
#include <vector>

#include "thigma/convex/hull_view.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct SurfaceTopology;  // mesh/surface_topology.h

/// Limits of a decomposition. A negative tolerance is chosen from the data: coordinates that were
/// rounded to single precision, or written with few digits, make coplanar faces reflex by that
/// rounding, and faces must not part for it.
struct DecompositionParams {
  int max_vertices = 32;  // of a patch's surface, so of its hull; 3..kMaxHullVertices
  // height over a face plane that still counts as flat, times the mesh radius; from the data: 1e-9
  // for doubles, about 1e-6 for single precision
  double convexity_tolerance = -1.0;
  // hull planes are moved inwards by this times the mesh radius before the clip test; from the
  // data: 10 x the other, at least 1e-7
  double protrusion_tolerance = -1.0;
};

/// The tolerances that decompose_surface uses for a mesh: params with negative ones replaced.
/// Thread [offline].
DecompositionParams resolve_tolerances(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                       const DecompositionParams& params);

/// A decomposition of the triangles of one mesh.
/// Invariant: patches partition the triangles that have an area; interior edges are convex or flat;
/// the triangles of a patch lie on its hull; no triangle of the same shell reaches into the hull
/// (all within the tolerances).
struct ConvexDecomposition {
  std::vector<std::int32_t> patch_of_triangle;     // -1 for zero-area triangles (m)
  std::vector<std::vector<std::int32_t>> patches;  // triangle indices, ascending
  // of each patch: every position its triangles use, ascending
  std::vector<std::vector<std::int32_t>> vertices;
  DecompositionParams params;  // with the tolerances that were used
  // patches kept small because the surface crosses itself there
  std::int32_t cut_by_self_intersection = 0;
  // of the others: patches in which the hull would have protruded
  std::int32_t cut_by_protrusion = 0;
  std::int32_t cut_by_size = 0;  // of the others: patches stopped by max_vertices
};

/// Decomposes a usable mesh (3.3.1): patches grow from the first free triangle over their edges,
/// breadth first. Deterministic. Open surfaces work: the hull lies behind the sheet. An edge of
/// three faces bounds patches.
/// Thread    [offline]; throws InputError when the mesh has no triangle with an area.
/// Source    Sec. 3.3.1; protrusion by exact clipping instead of sampling (docs/deviations.md).
ConvexDecomposition decompose_surface(const TriangleMesh& mesh,
                                      const DecompositionParams& params = {});

/// The same with the topology of the mesh, for a caller that has it.
ConvexDecomposition decompose_surface(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                      const DecompositionParams& params);

/// A mesh with its topology and its convex patches.
struct DecomposedSurface {
  const TriangleMesh& mesh;
  const SurfaceTopology& topology;
  const ConvexDecomposition& patches;
};

}  // namespace thigma
