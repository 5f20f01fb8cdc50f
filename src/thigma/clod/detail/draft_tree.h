#pragma once
// Nodes of a hierarchy before they have their places: how they are bounded, and how they are laid
// out.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/clod/detail/patch_features.h"
#include "thigma/clod/hierarchy.h"
#include "thigma/convex/decomposition.h"
#include "thigma/convex/quickhull.h"
#include "thigma/mesh/surface_topology.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::detail {

/// A node before it has its place.
struct NodeDraft {
  std::vector<Vec3> points;  // of the hull [m]
  double hausdorff = 0.0;    // [m]
  std::int32_t level = 0;
  std::int32_t patch = -1;             // of a leaf: the finest patch
  std::int32_t contact = -1;           // of a node of a simplified level: its contact patch
  std::vector<std::int32_t> children;  // drafts
};

/// Drafts, and of each draft without a parent the pool: every position below it that is not inside
/// the hull of some node below. What is inside can stand out of no hull above by more than that
/// hull's own points do.
struct DraftTree {
  std::vector<NodeDraft> drafts;
  std::vector<std::vector<std::int32_t>> pools;  // positions of the mesh, ascending
  Quickhull hull;                                // scratch
};

/// Leaves: the patches of a decomposition, drafts 0..patches-1.
DraftTree draft_leaves(const TriangleMesh& mesh, const ConvexDecomposition& decomposition);

/// Adds a node above some drafts, bounded by the hull of few well-spread points below it plus the
/// distance by which the others stand out. returns its index.
std::int32_t add_inner(const TriangleMesh& mesh, std::vector<std::int32_t> children,
                       std::int32_t level, DraftTree& tree);

/// Adds free levels: merges in pairs until one is left. returns the root.
///
/// tops  drafts without a parent, at least one
std::int32_t add_free_levels(const TriangleMesh& mesh, const std::vector<std::int32_t>& tops,
                             DraftTree& tree);

/// Adds free levels above few nodes: halves of equal number along the longest side, so that there
/// are no more levels than the logarithm of their number. returns the root.
///
/// tops  drafts without a parent, at least one; reordered
std::int32_t add_even_levels(const TriangleMesh& mesh, std::span<std::int32_t> tops,
                             DraftTree& tree);

/// Appends hull vertices and lanes, and describes them in the node or patch.
struct PlacedHull {
  Vec3 center = Vec3::Zero();
  double radius = 0.0;
  std::int32_t first_vertex = 0, vertex_count = 0, first_lane = 0, lane_count = 0;
};
PlacedHull append_hull(std::span<const Vec3> points, ClodHierarchy& hierarchy);

/// Appends the features of a patch, and the numbers of its triangles.
ClodPatch append_features(const PatchOfMesh& patch, double flat, ClodHierarchy& hierarchy);

/// Places the drafts below the root breadth first, so that children lie together and parents before
/// them; fills nodes, patches and the geometry of both.
void place_drafts(const DecomposedSurface& surface, const DraftTree& tree, std::int32_t root,
                  ClodHierarchy& hierarchy);

}  // namespace thigma::detail
