#pragma once
// The dual hierarchy: levels of detail and bounding volumes in one tree of convex hulls.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/clod/aligned_floats.h"
#include "thigma/convex/hull_view.h"
#include "thigma/math/types.h"

namespace thigma {

/// A node: a convex hull that bounds everything below it.
struct ClodNode {
  Vec3 center = Vec3::Zero();  // of the bounding sphere of the hull [m; body frame]
  double radius = 0.0;         // of that sphere [m]
  // h: how far any descendant's surface reaches outside this hull, at most [m]
  double hausdorff = 0.0;
  std::int32_t first_child = -1;  // children are contiguous
  std::int32_t child_count = 0;   // 0: a finest patch
  std::int32_t level = 0;         // 0 finest; of the simplified or free level the node belongs to
  std::int32_t patch = -1;        // finest patch of this node, -1 for inner nodes
  std::int32_t contact = -1;      // of a node of a simplified level: its contact patch
  std::int32_t first_vertex = 0;  // into ClodHierarchy::vertices
  std::int32_t vertex_count = 0;
  std::int32_t first_lane = 0;  // into ClodHierarchy::lanes, in floats
  std::int32_t lane_count = 0;
};

/// A patch of the finest level: the original triangles a leaf stands for.
struct ClodPatch {
  std::int32_t node = -1;
  std::int32_t first_triangle = 0, triangle_count = 0;  // into hull_triangles and triangle_ids
  std::int32_t first_face = 0, face_count = 0;          // into faces
  std::int32_t first_edge = 0, edge_count = 0;          // into edges
  double thickness = 0.0;                               // see HullView [m]
};

/// A patch of a simplified level, on its own hull: what a contact at that level is measured on. The
/// hull of its node bounds the finest patches below instead.
struct LevelPatch {
  ClodPatch patch;  // node, -1 where no finer patch is nearest to it; triangle_ids are of the level
  std::int32_t level = 0;
  std::int32_t first_vertex = 0, vertex_count = 0;  // as of ClodNode
  std::int32_t first_lane = 0, lane_count = 0;
  Vec3 center = Vec3::Zero();  // [m; body frame]
  double radius = 0.0;         // [m]
  double deviation = 0.0;  // s: no point of the patch is farther from the original surface, nor any
                           // point of the finest patches below its node from the patch [m]
  double hausdorff = 0.0;  // h: how far the hull of any patch below its node reaches outside this
                           // one, at most; raised where s + h would not cover the next two [m]
  double from_below = 0.0;  // no point of the finest patches below its node is farther from the
                            // triangles of the patch [m]
  // no point of its triangles is farther from the finest patches below its node; 0 without a node
  // [m]
  double to_below = 0.0;
};

/// What a level is.
struct ClodLevel {
  bool is_free = false;  // built by pairwise merging alone, no simplified mesh behind it
  std::int32_t node_count = 0;
  double hausdorff_max = 0.0;       // of the nodes' hulls [m]
  std::int32_t triangle_count = 0;  // 0 of a free level
  std::int32_t patch_count = 0;     // 0 of a free level
  double resolution = 0.0;     // r: infinite of the original, 0 (never fine enough) of a free level
                               // [1/m]
  double deviation_max = 0.0;  // of its contact patches [m]
  double contact_hausdorff_max = 0.0;  // of its contact patches [m]
};

/// Levels of detail and bounding hierarchy of one object. Immutable while running.
/// Invariant: nodes[0] is the root; first_child > own index; every finest patch is below the root
/// exactly once. Level 0 is the original surface; simplified levels follow, if any, then free ones
/// (Sec. 3.3.3).
struct ClodHierarchy {
  double radius = 0.0;         // of the smallest enclosing ball, to 1 % [m]
  Vec3 center = Vec3::Zero();  // of that ball [m; body frame]
  std::int32_t triangle_count = 0;
  std::vector<ClodNode> nodes;
  std::vector<ClodPatch> patches;
  std::vector<ClodLevel> levels;
  std::vector<LevelPatch> level_patches;  // level by level, from level 1
  // to_below of each vertex and triangle of contact patches alone, 0 of others; empty without
  // simplified levels (vertices, hull_triangles) [m].
  std::vector<float> vertex_to_below, triangle_to_below;
  std::vector<std::array<double, 2>> support;  // D by SupportReading, of the vertices of finest
                                               // and contact patches; 0 of others; empty without
                                               // simplified levels (vertices) [m^2]
  std::vector<Vec3> vertices;                  // hull vertices of all nodes [m; body frame]
  AlignedFloats lanes;                         // see HullView; 32-byte aligned start of every node
  std::vector<RealFace> faces;
  std::vector<RealEdge> edges;
  std::vector<HullTriangle> hull_triangles;
  std::vector<std::int32_t> triangle_ids;  // original triangle of each hull triangle
};

/// The hull of a node, or of a patch of a level, without what the surface has of it: all that
/// culling asks. Valid while the hierarchy lives.
/// Thread    [haptic] [contact].
template <class Owner>
HullView bare_hull(const ClodHierarchy& hierarchy, const Owner& owner) noexcept {
  HullView v;
  v.vertices = hierarchy.vertices.data() + owner.first_vertex;
  v.vertex_count = owner.vertex_count;
  v.lanes = hierarchy.lanes.data() + owner.first_lane;
  v.lane_count = owner.lane_count;
  v.center = owner.center;
  v.radius = owner.radius;
  return v;
}

/// Adds what the surface has of a hull.
/// Thread    [haptic] [contact].
inline void add_surface(const ClodHierarchy& hierarchy, const ClodPatch& patch,
                        HullView& hull) noexcept {
  hull.faces = hierarchy.faces.data() + patch.first_face;
  hull.face_count = patch.face_count;
  hull.edges = hierarchy.edges.data() + patch.first_edge;
  hull.edge_count = patch.edge_count;
  hull.triangles = hierarchy.hull_triangles.data() + patch.first_triangle;
  hull.triangle_count = patch.triangle_count;
  hull.thickness = patch.thickness;
}

/// The hull of a node as the pair queries read it. Valid while the hierarchy lives.
/// Thread    [haptic] [contact].
inline HullView hull_view(const ClodHierarchy& hierarchy, std::int32_t node) noexcept {
  const ClodNode& n = hierarchy.nodes[static_cast<std::size_t>(node)];
  HullView v = bare_hull(hierarchy, n);
  if (n.patch >= 0) add_surface(hierarchy, hierarchy.patches[static_cast<std::size_t>(n.patch)], v);
  return v;
}

/// The surface of a node at its own level of detail: a finest or a contact patch; the bounding hull
/// of a free node. Valid while the hierarchy lives.
/// Thread    [haptic] [contact].
inline HullView level_surface(const ClodHierarchy& hierarchy, std::int32_t node) noexcept {
  const std::int32_t contact = hierarchy.nodes[static_cast<std::size_t>(node)].contact;
  if (contact < 0) return hull_view(hierarchy, node);
  const LevelPatch& patch = hierarchy.level_patches[static_cast<std::size_t>(contact)];
  HullView v = bare_hull(hierarchy, patch);
  add_surface(hierarchy, patch.patch, v);
  return v;
}

}  // namespace thigma
