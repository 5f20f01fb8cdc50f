#include "thigma/simplify/check_levels.h"

#include <algorithm>
#include <numeric>

#include "thigma/convex/clip.h"
#include "thigma/convex/detail/surface.h"
#include "thigma/convex/detail/visit_triangles.h"
#include "thigma/convex/growing_hull.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

struct LevelView {
  const SimplifiedLevel& level;
  detail::Surface surface;
  detail::TriangleTree tree;
  std::vector<std::vector<std::int32_t>> triangles, vertices;  // of each patch
  double flat, inset;                                          // [m]
};

const Vec3& corner(const LevelView& v, std::int32_t t, std::size_t k) {
  return v.level.mesh.positions[at(v.level.mesh.triangles[at(t)][k])];
}

double height_over(const LevelView& v, std::int32_t t, const Vec3& p) {
  return v.surface.normal[at(t)].dot(p - corner(v, t, 0));
}

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

void check_convexity(const LevelView& v, LevelCheck& result) {
  for (std::size_t i = 0; i < v.level.mesh.triangles.size(); ++i) {
    const auto t = static_cast<std::int32_t>(i);
    const std::int32_t patch = v.level.patch_of_triangle[i];
    if (patch < 0 || !(v.surface.height[i] > v.flat)) continue;  // slivers have no plane
    for (const std::int32_t other : v.surface.neighbor[i]) {
      if (other < 0 || v.level.patch_of_triangle[at(other)] != patch) continue;
      bool is_reflex = false;
      for (std::size_t k = 0; k < 3; ++k)
        is_reflex = is_reflex || height_over(v, t, corner(v, other, k)) > v.flat;
      result.reflex_edges += is_reflex;
    }
    bool is_off = false;
    for (const std::int32_t w : v.vertices[at(patch)])
      is_off = is_off || height_over(v, t, v.level.mesh.positions[at(w)]) > v.flat;
    result.off_hull += is_off;
  }
}

void check_protrusion(const LevelView& v, LevelCheck& result) {
  GrowingHull hull;
  std::vector<HalfSpace> half_spaces;
  std::vector<Vec3> points;
  for (std::size_t p = 0; p < v.triangles.size(); ++p) {
    if (v.triangles[p].empty()) continue;
    points.clear();
    for (const std::int32_t w : v.vertices[p]) points.push_back(v.level.mesh.positions[at(w)]);
    detail::TreeBox box{points[0], points[0]};
    for (const Vec3& x : points) {
      box.min = box.min.cwiseMin(x);
      box.max = box.max.cwiseMax(x);
    }
    start_hull(hull, points, std::max(1e-10, v.flat / (box.max - box.min).norm()));
    if (hull.dimension < 3) continue;
    complete_hull(hull);
    list_half_spaces(hull, v.inset, half_spaces);
    const std::int32_t shell = v.surface.shell[at(v.triangles[p][0])];
    bool is_entered = false;
    detail::visit_triangles(v.tree, box, [&](std::int32_t t) {
      if (is_entered || v.level.patch_of_triangle[at(t)] == static_cast<std::int32_t>(p) ||
          v.surface.shell[at(t)] != shell || v.surface.height[at(t)] <= 0.0)
        return;
      std::array<Vec3, 3> c;
      for (std::size_t k = 0; k < 3; ++k) c[k] = (corner(v, t, k) - hull.origin) * hull.scale;
      is_entered = reaches_into(c, half_spaces);
    });
    result.protruding_patches += is_entered;
  }
}

LevelView view(const SimplifiedLevel& level, double flat, double inset) {
  LevelView v{level, detail::describe_surface(level.mesh), {}, {}, {}, flat, inset};
  std::vector<std::int32_t> all(level.mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  v.tree = detail::build_triangle_tree(level.mesh, std::move(all));
  v.triangles.resize(at(level.patch_count));
  v.vertices.resize(at(level.patch_count));
  for (std::size_t t = 0; t < level.mesh.triangles.size(); ++t) {
    const std::int32_t patch = level.patch_of_triangle[t];
    if (patch < 0 || patch >= level.patch_count) continue;
    v.triangles[at(patch)].push_back(static_cast<std::int32_t>(t));
    auto& own = v.vertices[at(patch)];
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
    for (const std::int32_t v : t) is_used[at(v)] = 1;
  return std::count(is_used.begin(), is_used.end(), 1) +
         static_cast<std::int64_t>(mesh.triangles.size()) -
         static_cast<std::int64_t>(build_edge_table(mesh).edges.size());
}

/// Level i against the one before.
void check_step(const Simplification& s, std::size_t i, LevelCheck& result) {
  const SimplifiedLevel &before = s.levels[i - 1], &level = s.levels[i];
  result.rising_resolutions += !(level.resolution <= before.resolution);
  const bool is_last = i + 1 == s.levels.size();
  result.unhalved_levels += !is_last && 2 * level.patch_count > before.patch_count;
  result.unhalved_levels += level.patch_count >= before.patch_count;
  std::vector<char> has_child(at(level.patch_count), 0);
  result.wrong_parents += before.parent.size() != at(before.patch_count);
  for (const std::int32_t parent : before.parent) {
    if (parent >= 0 && parent < level.patch_count)
      has_child[at(parent)] = 1;
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
    // A rounding more than the builder allows itself.
    const LevelView v = view(s.levels[i], s.convexity_tolerance * (1.0 + 1e-6),
                             s.protrusion_tolerance * (1.0 + 1e-6));
    check_patches(v, decomposition.params.max_vertices, result);
    check_convexity(v, result);
    check_protrusion(v, result);
    result.changed_surfaces += euler_characteristic(s.levels[i].mesh) != characteristic;
    if (i > 0) check_step(s, i, result);
  }
  return result;
}

}  // namespace thigma
