#pragma once
// The dual hierarchy: levels of detail and bounding volumes in one tree of convex hulls.

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
  double hausdorff =
      0.0;  // h: how far any descendant's surface reaches outside this hull, at most [m]
  std::int32_t first_child = -1;  // children are contiguous
  std::int32_t child_count = 0;   // 0: a finest patch
  std::int32_t level = 0;         // 0 finest; of the simplified or free level the node belongs to
  std::int32_t patch = -1;        // finest patch of this node, -1 for inner nodes
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

/// What a level is, for reports.
struct ClodLevel {
  bool is_free = false;  // built by pairwise merging alone, no simplified mesh behind it
  std::int32_t node_count = 0;
  double hausdorff_max = 0.0;  // [m]
};

/// Levels of detail and bounding hierarchy of one object. Immutable while running.
/// Invariant: nodes[0] is the root; first_child > own index; every finest patch is below the root
/// exactly once. Today: level 0 (the original surface) under free levels (Sec. 3.3.3); simplified
/// levels fit in between.
struct ClodHierarchy {
  double radius = 0.0;         // of the smallest enclosing ball, to 1 % [m]
  Vec3 center = Vec3::Zero();  // of that ball [m; body frame]
  std::int32_t triangle_count = 0;
  std::vector<ClodNode> nodes;
  std::vector<ClodPatch> patches;
  std::vector<ClodLevel> levels;
  std::vector<Vec3> vertices;  // hull vertices of all nodes [m; body frame]
  AlignedFloats lanes;         // see HullView; 32-byte aligned start of every node
  std::vector<RealFace> faces;
  std::vector<RealEdge> edges;
  std::vector<HullTriangle> hull_triangles;
  std::vector<std::int32_t> triangle_ids;  // original triangle of each hull triangle
};

/// The hull of a node as the pair queries read it. Valid while the hierarchy lives. Thread [haptic]
/// [contact].
inline HullView hull_view(const ClodHierarchy& h, std::int32_t node) noexcept {
  const ClodNode& n = h.nodes[static_cast<std::size_t>(node)];
  HullView v;
  v.vertices = h.vertices.data() + n.first_vertex;
  v.vertex_count = n.vertex_count;
  v.lanes = h.lanes.data() + n.first_lane;
  v.lane_count = n.lane_count;
  v.center = n.center;
  v.radius = n.radius;
  if (n.patch >= 0) {
    const ClodPatch& p = h.patches[static_cast<std::size_t>(n.patch)];
    v.faces = h.faces.data() + p.first_face;
    v.face_count = p.face_count;
    v.edges = h.edges.data() + p.first_edge;
    v.edge_count = p.edge_count;
    v.triangles = h.hull_triangles.data() + p.first_triangle;
    v.triangle_count = p.triangle_count;
    v.thickness = p.thickness;
  }
  return v;
}

}  // namespace thigma
