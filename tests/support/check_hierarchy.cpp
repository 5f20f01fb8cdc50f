#include "support/check_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/patch_faults.h"

#include "thigma/convex/gjk.h"
#include "thigma/core/index.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

struct Checker {
  const ClodHierarchy& h;
  const TriangleMesh& mesh;
  SurfaceTopology surface;
  double flat, inset;                  // [m]
  std::vector<std::int32_t> patch_of;  // of each triangle
  HierarchyCheck result;
};

const Vec3& corner(const Checker& c, std::int32_t t, std::size_t k) {
  return c.mesh.positions[idx(c.mesh.triangles[idx(t)][k])];
}

void check_tree(Checker& c) {
  const auto count = static_cast<std::int32_t>(c.h.nodes.size());
  std::vector<int> parents(c.h.nodes.size(), 0);
  std::vector<int> leaves(c.h.patches.size(), 0);
  for (std::int32_t i = 0; i < count; ++i) {
    const ClodNode& node = c.h.nodes[idx(i)];
    if (node.child_count == 0) {
      const bool is_patch = node.patch >= 0 && idx(node.patch) < c.h.patches.size() &&
                            c.h.patches[idx(node.patch)].node == i && node.hausdorff == 0.0;
      if (!is_patch)
        ++c.result.misplaced_nodes;
      else
        ++leaves[idx(node.patch)];
      continue;
    }
    if (node.first_child <= i || node.first_child + node.child_count > count || node.patch >= 0) {
      ++c.result.misplaced_nodes;
      continue;
    }
    for (std::int32_t k = 0; k < node.child_count; ++k) ++parents[idx(node.first_child + k)];
  }
  for (std::size_t i = 0; i < parents.size(); ++i)
    c.result.misplaced_nodes += parents[i] != (i > 0 ? 1 : 0);
  for (const int n : leaves) c.result.misplaced_nodes += n != 1;
}

void check_triangles(Checker& c) {
  c.patch_of.assign(c.mesh.triangles.size(), -1);
  for (std::size_t p = 0; p < c.h.patches.size(); ++p) {
    const ClodPatch& patch = c.h.patches[p];
    const HullView hull = hull_view(c.h, patch.node);
    for (std::int32_t i = 0; i < patch.triangle_count; ++i) {
      const std::int32_t t = c.h.triangle_ids[idx(patch.first_triangle + i)];
      if (c.patch_of[idx(t)] >= 0) ++c.result.misplaced_triangles;
      c.patch_of[idx(t)] = static_cast<std::int32_t>(p);
      const HullTriangle& local = hull.triangles[i];
      for (std::size_t k = 0; k < 3; ++k)
        if (local.corner[k] >= hull.vertex_count ||
            hull.vertices[local.corner[k]] != corner(c, t, k) ||
            !(local.mask >> local.corner[k] & 1u))
          ++c.result.wrong_corners;
    }
  }
  for (std::size_t t = 0; t < c.patch_of.size(); ++t)
    c.result.misplaced_triangles += (c.patch_of[t] >= 0) != (c.surface.height[t] > 0.0);
}

void check_hulls(Checker& c) {
  std::vector<std::vector<Vec3>> points;
  for (const ClodPatch& patch : c.h.patches) {
    const HullView hull = hull_view(c.h, patch.node);
    points.emplace_back(hull.vertices, hull.vertices + hull.vertex_count);
  }
  const detail::PatchFaults faults =
      detail::count_patch_faults({c.mesh, c.surface, c.patch_of, points, c.flat, c.inset});
  c.result.reflex_edges = faults.reflex_edges;
  c.result.off_hull = faults.off_hull;
  c.result.protruding_patches = faults.protruding_patches;
}

void check_features(Checker& c) {
  for (const ClodPatch& patch : c.h.patches) {
    const HullView hull = hull_view(c.h, patch.node);
    // Faces merge what is flat to one tolerance and turn to its mean normal: twice the tolerance
    // bounds both.
    const double slack = 4.0 * c.flat;
    for (int f = 0; f < hull.face_count; ++f) {
      bool bounds_hull = std::fabs(hull.faces[f].normal.norm() - 1.0) < 1e-12;
      for (int v = 0; v < hull.vertex_count; ++v) {
        const double depth = hull.faces[f].offset - hull.faces[f].normal.dot(hull.vertices[v]);
        const bool is_on = hull.faces[f].vertices >> v & 1u;
        bounds_hull = bounds_hull && (is_on ? std::fabs(depth) <= slack : true);
      }
      c.result.wrong_features += !bounds_hull;
    }
    for (int e = 0; e < hull.edge_count; ++e) {
      const RealEdge& edge = hull.edges[e];
      const std::uint32_t ends = 1u << edge.tail | 1u << edge.head;
      const auto holds = [&](int f) { return (hull.faces[f].vertices & ends) == ends; };
      const bool is_right = edge.tail != edge.head && edge.face_left >= 0 &&
                            holds(edge.face_left) &&
                            (edge.face_right < 0 || holds(edge.face_right));
      c.result.wrong_features += !is_right;
    }
  }
}

double distance_to(const HullView& hull, const Vec3& p) {
  HullView point;
  point.vertices = &p;
  point.vertex_count = 1;
  point.center = p;
  float lanes alignas(32)[24] = {};  // eight copies of the point about itself
  point.lanes = lanes;
  point.lane_count = 8;
  GjkCache cache;
  return closest_points(hull, point, RelativePose{}, std::numeric_limits<double>::infinity(), cache)
      .distance;
}

/// Every vertex of a patch against every node above it, for all patches together from the leaves
/// up.
void check_cover(Checker& c) {
  std::vector<std::vector<std::int32_t>> below(
      c.h.nodes.size());  // first vertices of patches' ranges
  for (std::size_t i = c.h.nodes.size(); i-- > 0;) {
    const ClodNode& node = c.h.nodes[i];
    const HullView hull = hull_view(c.h, static_cast<std::int32_t>(i));
    bool is_covered = true;
    for (int v = 0; v < hull.vertex_count; ++v)
      is_covered = is_covered && (hull.vertices[v] - node.center).norm() <= node.radius;
    if (node.child_count == 0) {
      below[i].push_back(static_cast<std::int32_t>(i));
    } else {
      for (std::int32_t k = 0; k < node.child_count; ++k) {
        auto& child = below[idx(node.first_child + k)];
        below[i].insert(below[i].end(), child.begin(), child.end());
        std::vector<std::int32_t>().swap(child);
      }
      for (const std::int32_t leaf : below[i]) {
        const HullView patch = hull_view(c.h, leaf);
        for (int v = 0; v < patch.vertex_count; ++v) {
          const double excess = distance_to(hull, patch.vertices[v]) - node.hausdorff;
          if (!(excess > 1e-12 * c.h.radius)) continue;
          is_covered = false;
          c.result.worst_uncovered = std::max(c.result.worst_uncovered, excess);
        }
      }
    }
    c.result.uncovered_nodes += !is_covered;
  }
}

}  // namespace

HierarchyCheck check_hierarchy(const ClodHierarchy& hierarchy, const TriangleMesh& mesh,
                               const DecompositionParams& params) {
  const SurfaceTopology topology = compute_topology(mesh);
  const DecompositionParams used = resolve_tolerances(mesh, topology, params);
  // A rounding more than the builder allows itself.
  const double flat = used.convexity_tolerance * hierarchy.radius * (1.0 + 1e-9);
  Checker checker{hierarchy, mesh, topology, flat, used.protrusion_tolerance * hierarchy.radius,
                  {},        {}};
  check_tree(checker);
  check_triangles(checker);
  check_hulls(checker);
  check_features(checker);
  check_cover(checker);
  return checker.result;
}

}  // namespace thigma
