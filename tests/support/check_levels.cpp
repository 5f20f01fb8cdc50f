#include "support/check_levels.h"

#include <algorithm>

#include "support/patch_faults.h"

#include "thigma/core/index.h"
#include "thigma/mesh/surface_topology.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

struct LevelView {
  const SimplifiedLevel& level;
  SurfaceTopology surface;
  std::vector<std::vector<std::int32_t>> triangles, vertices;  // of each patch
  double flat, inset;                                          // [m]
};

void check_patches(const LevelView& v, int max_vertices, LevelCheck& result) {
  for (std::size_t t = 0; t < v.level.mesh.triangles.size(); ++t) {
    const std::int32_t patch = v.level.patch_of_triangle[t];
    result.misplaced_triangles +=
        patch < 0 ? v.surface.height[t] > 0.0 : patch >= v.level.patch_count;
  }
  for (std::size_t p = 0; p < v.triangles.size(); ++p) {
    result.empty_patches += v.triangles[p].empty();
    result.oversized_patches += static_cast<int>(v.vertices[p].size()) > max_vertices;
  }
}

void check_hulls(const LevelView& v, LevelCheck& result) {
  std::vector<std::vector<Vec3>> points(v.vertices.size());
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const std::int32_t w : v.vertices[p]) points[p].push_back(v.level.mesh.positions[idx(w)]);
  std::vector<std::int32_t> patch_of = v.level.patch_of_triangle;
  for (std::int32_t& patch : patch_of)
    if (patch >= v.level.patch_count) patch = -1;
  const detail::PatchFaults faults =
      detail::count_patch_faults({v.level.mesh, v.surface, patch_of, points, v.flat, v.inset});
  result.reflex_edges += faults.reflex_edges;
  result.off_hull += faults.off_hull;
  result.protruding_patches += faults.protruding_patches;
}

LevelView view(const SimplifiedLevel& level, double flat, double inset) {
  LevelView v{level, compute_topology(level.mesh), {}, {}, flat, inset};
  v.triangles.resize(idx(level.patch_count));
  v.vertices.resize(idx(level.patch_count));
  for (std::size_t t = 0; t < level.mesh.triangles.size(); ++t) {
    const std::int32_t patch = level.patch_of_triangle[t];
    if (patch < 0 || patch >= level.patch_count) continue;
    v.triangles[idx(patch)].push_back(static_cast<std::int32_t>(t));
    auto& own = v.vertices[idx(patch)];
    own.insert(own.end(), level.mesh.triangles[t].begin(), level.mesh.triangles[t].end());
  }
  for (auto& own : v.vertices) {
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
  }
  return v;
}

std::int64_t euler_characteristic(const TriangleMesh& mesh) {
  std::vector<char> is_used(mesh.positions.size(), 0);
  for (const auto& t : mesh.triangles)
    for (const std::int32_t v : t) is_used[idx(v)] = 1;
  return std::count(is_used.begin(), is_used.end(), 1) +
         static_cast<std::int64_t>(mesh.triangles.size()) -
         static_cast<std::int64_t>(build_edge_table(mesh).edges.size());
}

/// Level i against the one before.
void check_step(const Simplification& s, std::size_t i, LevelCheck& result) {
  const SimplifiedLevel &before = s.levels[i - 1], &level = s.levels[i];
  result.rising_resolutions += !(level.resolution <= before.resolution);
  const bool is_last = i + 1 == s.levels.size();
  result.unhalved_levels += !is_last && 2 * level.patch_count > before.patch_count &&
                            2 * level.mesh.triangles.size() > before.mesh.triangles.size();
  result.unhalved_levels += level.patch_count >= before.patch_count;
  std::vector<char> has_child(idx(level.patch_count), 0);
  result.wrong_parents += before.parent.size() != idx(before.patch_count);
  for (const std::int32_t parent : before.parent) {
    if (parent >= 0 && parent < level.patch_count)
      has_child[idx(parent)] = 1;
    else
      ++result.wrong_parents;
  }
  // Triangles without an area are in no patch of level 0, but may grow one.
  const auto& first = s.levels[0].patch_of_triangle;
  if (std::find(first.begin(), first.end(), -1) == first.end())
    result.wrong_parents += std::count(has_child.begin(), has_child.end(), 0);
}

}  // namespace

LevelCheck check_levels(const Simplification& s, const ConvexDecomposition& decomposition) {
  LevelCheck result;
  const std::int64_t characteristic = euler_characteristic(s.levels[0].mesh);
  for (std::size_t i = 0; i < s.levels.size(); ++i) {
    if (s.levels[i].patch_of_triangle.size() != s.levels[i].mesh.triangles.size()) {
      ++result.changed_surfaces;  // which patch a triangle is in cannot be told
      continue;
    }
    // A rounding more than the builder allows itself.
    const LevelView v = view(s.levels[i], s.convexity_tolerance * (1.0 + 1e-6),
                             s.protrusion_tolerance * (1.0 + 1e-6));
    check_patches(v, decomposition.params.max_vertices, result);
    check_hulls(v, result);
    result.changed_surfaces += euler_characteristic(s.levels[i].mesh) != characteristic;
    if (i > 0) check_step(s, i, result);
  }
  return result;
}

}  // namespace thigma
