#include "thigma/clod/detail/level_patches.h"

#include <algorithm>
#include <limits>

#include "thigma/clod/detail/draft_tree.h"
#include "thigma/clod/surface_deviation.h"
#include "thigma/convex/gjk.h"
#include "thigma/core/index.h"
#include "thigma/core/parallel.h"

namespace thigma::detail {
namespace {

/// Distance from a point to a hull, 0 inside.
double distance_to(const HullView& hull, const Vec3& p) {
  HullView point;
  point.vertices = &p;
  point.vertex_count = 1;
  point.center = p;
  alignas(32) const float lanes[24] = {};  // eight copies of the point about itself
  point.lanes = lanes;
  point.lane_count = 8;
  GjkCache cache;
  return closest_points(hull, point, RelativePose{}, std::numeric_limits<double>::infinity(), cache)
      .distance;
}

/// How far a hull reaches outside another, at most: a convex function, so at a vertex.
double reach_outside(const HullView& inner, const HullView& outer) {
  double largest = 0.0;
  for (int v = 0; v < inner.vertex_count; ++v) {
    // Not farther than from the sphere: no need to measure what cannot be the largest.
    if ((inner.vertices[v] - outer.center).norm() + outer.radius <= largest) continue;
    largest = std::max(largest, distance_to(outer, inner.vertices[v]));
  }
  return largest;
}

std::array<Vec3, 3> corners(const TriangleMesh& mesh, std::int32_t t) {
  const auto& v = mesh.triangles[idx(t)];
  return {mesh.positions[idx(v[0])], mesh.positions[idx(v[1])], mesh.positions[idx(v[2])]};
}

/// Where a level's surface may be, seen from the original's: three times as far as its farthest
/// vertex.
double reach_of(const DeviationTarget& original, const TriangleMesh& level) {
  double largest = 0.0;
  std::int32_t guess = 0;
  for (const Vec3& p : level.positions)
    largest = std::max(largest, nearest_distance(original, p, guess));
  return 3.0 * largest;
}

/// Of each level and finest patch: the contact patch above it.
std::vector<std::vector<std::int32_t>> contact_patches_above(const ClodHierarchy& hierarchy,
                                                             std::size_t levels) {
  std::vector<std::int32_t> parent(hierarchy.nodes.size(), -1);
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i)
    for (std::int32_t k = 0; k < hierarchy.nodes[i].child_count; ++k)
      parent[idx(hierarchy.nodes[i].first_child + k)] = static_cast<std::int32_t>(i);
  std::vector<std::vector<std::int32_t>> above(levels);
  std::vector<std::int32_t> node;
  for (const ClodPatch& patch : hierarchy.patches) node.push_back(patch.node);
  for (std::size_t k = 1; k < levels; ++k)
    for (std::int32_t& i : node) {
      i = parent[idx(i)];
      above[k].push_back(hierarchy.nodes[idx(i)].contact);
    }
  return above;
}

/// The surface from which levels deviate.
struct FinestSurface {
  const TriangleMesh& mesh;
  const ConvexDecomposition& decomposition;
  DeviationTarget target;
};

/// Deviations of one level. first: its first contact patch.
void measure_level(const FinestSurface& finest, const SimplifiedLevel& level,
                   const std::vector<std::int32_t>& above, std::size_t first,
                   ClodHierarchy& hierarchy) {
  const DeviationTarget& original = finest.target;
  const std::vector<std::vector<std::int32_t>>& patches = finest.decomposition.patches;
  const double reach = reach_of(original, level.mesh);
  const DeviationTarget target = build_deviation_target(level.mesh);
  const double rounding = 1e-12 * hierarchy.radius;  // of what is measured
  std::vector<DeviationRange> range(idx(level.patch_count), DeviationRange{0.0, rounding});
  std::int32_t guess = 0;
  for (std::size_t t = 0; t < level.mesh.triangles.size(); ++t) {
    if (level.patch_of_triangle[t] < 0) continue;
    extend_deviation(original, corners(level.mesh, static_cast<std::int32_t>(t)), reach,
                     range[idx(level.patch_of_triangle[t])], guess);
  }
  guess = 0;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    DeviationRange& of_patch = range[idx(above[p]) - first];
    for (const std::int32_t t : patches[p])
      extend_deviation(target, corners(finest.mesh, t), reach, of_patch, guess);
  }
  for (std::size_t p = 0; p < range.size(); ++p)
    hierarchy.level_patches[first + p].deviation = range[p].bound;
}

}  // namespace

std::vector<LevelPatches> list_level_patches(const Simplification& simplification) {
  std::vector<LevelPatches> result(simplification.levels.size());
  for (std::size_t k = 1; k < simplification.levels.size(); ++k) {
    const SimplifiedLevel& level = simplification.levels[k];
    LevelPatches& patches = result[k];
    patches.triangles.resize(idx(level.patch_count));
    patches.vertices.resize(idx(level.patch_count));
    for (std::size_t t = 0; t < level.mesh.triangles.size(); ++t) {
      if (level.patch_of_triangle[t] < 0) continue;
      const std::size_t patch = idx(level.patch_of_triangle[t]);
      patches.triangles[patch].push_back(static_cast<std::int32_t>(t));
      for (const std::int32_t v : level.mesh.triangles[t]) patches.vertices[patch].push_back(v);
    }
    for (auto& vertices : patches.vertices) {
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }
  return result;
}

void append_contact_patches(const Simplification& simplification,
                            const std::vector<LevelPatches>& patches, ClodHierarchy& hierarchy) {
  std::vector<Vec3> points;
  for (std::size_t k = 1; k < simplification.levels.size(); ++k) {
    const TriangleMesh& mesh = simplification.levels[k].mesh;
    const SurfaceTopology topology = compute_topology(mesh);
    for (std::size_t p = 0; p < patches[k].triangles.size(); ++p) {
      points.clear();
      for (const std::int32_t v : patches[k].vertices[p]) points.push_back(mesh.positions[idx(v)]);
      LevelPatch contact;
      contact.level = static_cast<std::int32_t>(k);
      const PlacedHull hull = append_hull(points, hierarchy);
      contact.center = hull.center;
      contact.radius = hull.radius;
      contact.first_vertex = hull.first_vertex;
      contact.vertex_count = hull.vertex_count;
      contact.first_lane = hull.first_lane;
      contact.lane_count = hull.lane_count;
      contact.patch =
          append_features({mesh, topology, patches[k].triangles[p], patches[k].vertices[p]},
                          simplification.convexity_tolerance, hierarchy);
      hierarchy.level_patches.push_back(contact);
    }
  }
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i)
    if (hierarchy.nodes[i].contact >= 0)
      hierarchy.level_patches[idx(hierarchy.nodes[i].contact)].patch.node =
          static_cast<std::int32_t>(i);
}

void measure_hausdorff(int threads, ClodHierarchy& hierarchy) {
  struct Measure {
    std::int32_t node;
    std::vector<std::int32_t> below;  // nodes with a patch
  };
  std::vector<Measure> measures;
  std::vector<std::vector<std::int32_t>> below(hierarchy.nodes.size());
  for (std::size_t i = hierarchy.nodes.size(); i-- > 0;) {
    const ClodNode& node = hierarchy.nodes[i];
    const bool is_free = node.child_count > 0 && node.contact < 0;
    for (std::int32_t k = 0; k < node.child_count; ++k) {
      auto& child = below[idx(node.first_child + k)];
      if (!is_free) below[i].insert(below[i].end(), child.begin(), child.end());
      std::vector<std::int32_t>().swap(child);
    }
    if (is_free) continue;
    if (node.contact >= 0) measures.push_back({static_cast<std::int32_t>(i), below[i]});
    below[i].push_back(static_cast<std::int32_t>(i));
  }
  for_each_piece(measures.size(), threads, [&](std::size_t i) {
    const HullView hull = level_surface(hierarchy, measures[i].node);
    double& largest =
        hierarchy.level_patches[idx(hierarchy.nodes[idx(measures[i].node)].contact)].hausdorff;
    for (const std::int32_t other : measures[i].below)
      largest = std::max(largest, reach_outside(level_surface(hierarchy, other), hull));
    largest += 1e-12 * hierarchy.radius;  // rounding of the distances
  });
}

void bound_by_contact_patches(ClodHierarchy& hierarchy) {
  for (std::size_t i = hierarchy.nodes.size(); i-- > 0;) {
    ClodNode& node = hierarchy.nodes[i];
    if (node.contact >= 0) {
      const LevelPatch& patch = hierarchy.level_patches[idx(node.contact)];
      node.center = patch.center;
      node.radius = patch.radius;
      node.hausdorff = patch.hausdorff;
      node.first_vertex = patch.first_vertex;
      node.vertex_count = patch.vertex_count;
      node.first_lane = patch.first_lane;
      node.lane_count = patch.lane_count;
    } else if (node.child_count > 0) {
      const HullView hull = hull_view(hierarchy, static_cast<std::int32_t>(i));
      double largest = 0.0;
      for (std::int32_t k = node.first_child; k < node.first_child + node.child_count; ++k)
        largest = std::max(largest, reach_outside(hull_view(hierarchy, k), hull) +
                                        hierarchy.nodes[idx(k)].hausdorff);
      node.hausdorff = largest + 1e-12 * hierarchy.radius;
    }
  }
}

void measure_deviation(const TriangleMesh& mesh, const ConvexDecomposition& decomposition,
                       const Simplification& simplification, int threads,
                       ClodHierarchy& hierarchy) {
  if (simplification.levels.size() < 2) return;
  const FinestSurface finest{mesh, decomposition, build_deviation_target(mesh)};
  const auto above = contact_patches_above(hierarchy, simplification.levels.size());
  std::vector<std::size_t> first(1, 0);
  for (const SimplifiedLevel& level : simplification.levels)
    first.push_back(first.back() + (first.size() > 1 ? idx(level.patch_count) : 0));
  for_each_piece(simplification.levels.size() - 1, threads, [&](std::size_t i) {
    measure_level(finest, simplification.levels[i + 1], above[i + 1], first[i + 1], hierarchy);
  });
}

void fill_support(const ConvexDecomposition& decomposition,
                  const std::vector<LevelPatches>& patches, const Simplification& simplification,
                  ClodHierarchy& hierarchy) {
  if (simplification.levels.size() < 2) return;
  hierarchy.support.assign(hierarchy.vertices.size(), {0.0, 0.0});
  for (std::size_t p = 0; p < hierarchy.patches.size(); ++p) {
    std::size_t place = idx(hierarchy.nodes[idx(hierarchy.patches[p].node)].first_vertex);
    for (const std::int32_t v : decomposition.vertices[p])
      hierarchy.support[place++] = simplification.levels[0].support[idx(v)];
  }
  std::size_t contact = 0;
  for (std::size_t k = 1; k < simplification.levels.size(); ++k)
    for (const auto& vertices : patches[k].vertices) {
      std::size_t place = idx(hierarchy.level_patches[contact++].first_vertex);
      for (const std::int32_t v : vertices)
        hierarchy.support[place++] = simplification.levels[k].support[idx(v)];
    }
}

}  // namespace thigma::detail
