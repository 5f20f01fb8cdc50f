#pragma once
// Does a hierarchy keep its promises? Counts what breaks them; every count is 0 for a right one.

#include <cstdint>

#include "thigma/clod/hierarchy.h"
#include "thigma/convex/decomposition.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Violations of the invariants of ConvexDecomposition and ClodHierarchy.
struct HierarchyCheck {
  // children not contiguous after the node, or node not below the root once
  std::int64_t misplaced_nodes = 0;
  // with an area and not in exactly one patch, or without one and in a patch
  std::int64_t misplaced_triangles = 0;
  std::int64_t wrong_corners = 0;  // hull triangles that are not the mesh's triangle of that index
  std::int64_t reflex_edges = 0;   // inside a patch, beyond the convexity tolerance
  std::int64_t off_hull = 0;       // triangles with a vertex of their patch over their plane
  // a triangle of the same shell reaches into the patch's hull
  std::int64_t protruding_patches = 0;
  std::int64_t wrong_features = 0;  // real faces or edges that do not bound their hull
  // a descendant's vertex is farther from the hull than h, or off the sphere
  std::int64_t uncovered_nodes = 0;
  double worst_uncovered = 0.0;  // largest such excess [m]

  std::int64_t total() const {
    return misplaced_nodes + misplaced_triangles + wrong_corners + reflex_edges + off_hull +
           protruding_patches + wrong_features + uncovered_nodes;
  }
};

/// Checks a hierarchy of a mesh by other means than it was built with where there are any:
/// distances by GJK, hulls from scratch. About three times the time of the build.
///
/// params  as given to build_exact_hierarchy
/// Thread  [offline]; no failure.
HierarchyCheck check_hierarchy(const ClodHierarchy& hierarchy, const TriangleMesh& mesh,
                               const DecompositionParams& params = {});

}  // namespace thigma
