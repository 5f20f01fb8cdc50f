#include "thigma/simplify/patched_surface.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

bool contains(const std::vector<std::int32_t>& list, std::int32_t value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// Whether the patch stays convex with the triangle, which has no area.
bool takes_flat_triangle(const PatchedSurface& s, const SurfacePatch& patch, std::int32_t t) {
  auto count = static_cast<int>(patch.vertices.size());
  for (const std::int32_t v : s.mesh.triangles[at(t)]) {
    if (contains(patch.vertices, v)) continue;
    ++count;
    for (const std::int32_t other : patch.triangles)
      if (has_plane(s, other) && height_over(s, other, s.mesh.positions[at(v)]) > s.flat)
        return false;
  }
  return count <= s.max_vertices;
}

/// Over its longest edge, on which its third corner lies, a triangle adds nothing to a hull.
std::int32_t longest_edge(const PatchedSurface& s, std::int32_t t) {
  const std::array<Vec3, 3> c = corners_of(s, t);
  std::int32_t longest = 0;
  for (std::int32_t k = 1; k < 3; ++k)
    if ((c[at((k + 1) % 3)] - c[at(k)]).squaredNorm() >
        (c[at((longest + 1) % 3)] - c[at(longest)]).squaredNorm())
      longest = k;
  return 3 * t + longest;
}

void place_flat_triangle(PatchedSurface& s, std::int32_t t, std::int32_t shell) {
  std::int32_t home = -1;
  const std::int32_t beside = s.mesh.twin[at(longest_edge(s, t))];
  if (beside >= 0) {
    const std::int32_t patch = s.patch_of[at(beside / 3)];
    if (patch >= 0 && takes_flat_triangle(s, s.patches[at(patch)], t)) home = patch;
  }
  if (home < 0) {
    home = static_cast<std::int32_t>(s.patches.size());
    s.patches.emplace_back();
    s.patches.back().shell = shell;
  }
  SurfacePatch& patch = s.patches[at(home)];
  patch.triangles.push_back(t);
  for (const std::int32_t v : s.mesh.triangles[at(t)])
    if (!contains(patch.vertices, v)) patch.vertices.push_back(v);
  s.patch_of[at(t)] = home;
}

/// Whether every vertex of one patch is below every plane of the other.
bool lies_below(const PatchedSurface& s, const SurfacePatch& lower, const SurfacePatch& upper) {
  for (const std::int32_t t : upper.triangles) {
    if (!has_plane(s, t)) continue;
    for (const std::int32_t v : lower.vertices)
      if (height_over(s, t, s.mesh.positions[at(v)]) > s.flat) return false;
  }
  return true;
}

bool is_entered(const PatchedSurface& s, std::int32_t one, std::int32_t other,
                const std::vector<HalfSpace>& half_spaces, const TreeBox& box) {
  bool entered = false;
  const std::int32_t shell = s.patches[at(one)].shell;
  s.tree.visit(box, [&](std::int32_t patch) {
    if (entered || patch == one || patch == other || s.patches[at(patch)].shell != shell ||
        !s.patches[at(patch)].box.overlaps(box))
      return;
    for (const std::int32_t t : s.patches[at(patch)].triangles)
      if (!entered && intrudes(s, t, half_spaces, box)) entered = true;
  });
  return entered;
}

/// Patches across the rim, in order of the triangles, without those across a reflex edge.
void list_mergeable(const PatchedSurface& s, std::int32_t patch, std::vector<std::int32_t>& found) {
  std::vector<std::int32_t> reflex;
  found.clear();
  for (const std::int32_t t : s.patches[at(patch)].triangles)
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t beside = s.mesh.twin[at(3 * t + k)];
      if (beside < 0) continue;
      const std::int32_t other = s.patch_of[at(beside / 3)];
      if (other == patch) continue;
      const std::int32_t apex = tail_of(s.mesh, previous_halfedge(beside));
      if (has_plane(s, t) && height_over(s, t, s.mesh.positions[at(apex)]) > s.flat)
        reflex.push_back(other);
      else if (!contains(found, other))
        found.push_back(other);
    }
  std::erase_if(found, [&](std::int32_t p) { return contains(reflex, p); });
}

}  // namespace

void refresh_triangle(PatchedSurface& s, std::int32_t t) {
  const std::array<Vec3, 3> c = corners_of(s, t);
  const Vec3 ab = c[1] - c[0], ac = c[2] - c[0];
  const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  const Vec3 cross = ab.cross(ac);
  const double length = cross.norm();
  // As in the decomposition: below this the direction of the normal is rounding alone.
  const bool has_area = length > 1e-15 * longest2;
  s.normal[at(t)] = has_area ? Vec3(cross / length) : Vec3(Vec3::Zero());
  s.height[at(t)] = has_area ? length / std::sqrt(longest2) : 0.0;
}

void list_patch_half_spaces(const PatchedSurface& s, const std::vector<std::int32_t>& vertices,
                            Quickhull& hull, std::vector<HalfSpace>& half_spaces, TreeBox& box) {
  std::array<Vec3, kMaxHullVertices> points;
  const std::size_t count = std::min(vertices.size(), points.size());
  points[0] = s.mesh.positions[at(vertices[0])];
  for (std::size_t i = 0; i < count; ++i) points[i] = s.mesh.positions[at(vertices[i])];
  box = {points[0], points[0]};
  for (std::size_t i = 1; i < count; ++i) {
    box.min = box.min.cwiseMin(points[i]);
    box.max = box.max.cwiseMax(points[i]);
  }
  half_spaces.clear();
  if (count < 4) return;
  start_hull(hull, {points.data(), count}, std::max(1e-10, s.flat / (box.max - box.min).norm()));
  if (hull.dimension < 3) return;
  complete_hull(hull);
  list_half_spaces(hull, s.inset, half_spaces);
  for (HalfSpace& h : half_spaces) h.offset = h.offset / hull.scale + h.normal.dot(hull.origin);
}

bool intrudes(const PatchedSurface& s, std::int32_t t, const std::vector<HalfSpace>& half_spaces,
              const TreeBox& box) {
  if (half_spaces.empty() || s.height[at(t)] <= 0.0) return false;
  const std::array<Vec3, 3> corners = corners_of(s, t);
  return box_of(corners).overlaps(box) && reaches_into(corners, half_spaces);
}

void set_patch(PatchedSurface& s, std::int32_t patch, std::vector<std::int32_t>& vertices,
               std::vector<HalfSpace>& half_spaces, const TreeBox& box) {
  SurfacePatch& p = s.patches[at(patch)];
  p.vertices.assign(vertices.begin(), vertices.end());
  p.half_spaces.assign(half_spaces.begin(), half_spaces.end());
  p.box = box;
  s.tree.update(patch, box);
}

PatchedSurface build_patched_surface(const DecomposedSurface& surface, double convexity,
                                     double protrusion, CornerAttributes attributes) {
  const TriangleMesh& mesh = surface.mesh;
  const ConvexDecomposition& decomposition = surface.patches;
  PatchedSurface s;
  s.mesh = build_halfedge_mesh(mesh, std::move(attributes));
  s.radius = enclosing_ball(mesh.positions).radius;
  s.flat = std::max(convexity, decomposition.params.convexity_tolerance) * s.radius;
  s.inset = std::max(protrusion, decomposition.params.protrusion_tolerance) * s.radius;
  s.max_vertices = decomposition.params.max_vertices;
  s.patch_of = decomposition.patch_of_triangle;
  s.normal.resize(mesh.triangles.size());
  s.height.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    refresh_triangle(s, static_cast<std::int32_t>(t));
  const std::vector<std::int32_t>& shell = surface.topology.shell;
  s.patches.resize(decomposition.patches.size());
  for (std::size_t i = 0; i < s.patches.size(); ++i) {
    s.patches[i].triangles = decomposition.patches[i];
    s.patches[i].vertices = decomposition.vertices[i];
    s.patches[i].shell = shell[at(decomposition.patches[i][0])];
  }
  for (std::size_t t = 0; t < s.patch_of.size(); ++t)
    if (s.patch_of[t] < 0) place_flat_triangle(s, static_cast<std::int32_t>(t), shell[t]);
  Quickhull hull;
  std::vector<TreeBox> boxes;
  for (SurfacePatch& patch : s.patches) {
    list_patch_half_spaces(s, patch.vertices, hull, patch.half_spaces, patch.box);
    boxes.push_back(patch.box);
  }
  s.tree.build(boxes);
  s.patch_count = static_cast<std::int32_t>(s.patches.size());
  return s;
}

int merge_patch(PatchedSurface& s, std::int32_t patch, Quickhull& hull,
                std::vector<std::int32_t>& successor) {
  std::vector<std::int32_t> candidates, vertices;
  std::vector<HalfSpace> half_spaces;
  TreeBox box;
  int merged = 0;
  for (bool again = true; again;) {
    again = false;
    list_mergeable(s, patch, candidates);
    for (const std::int32_t other : candidates) {
      SurfacePatch &one = s.patches[at(patch)], &two = s.patches[at(other)];
      vertices = one.vertices;
      for (const std::int32_t v : two.vertices)
        if (!contains(one.vertices, v)) vertices.push_back(v);
      if (static_cast<int>(vertices.size()) > s.max_vertices) continue;
      if (!lies_below(s, two, one) || !lies_below(s, one, two)) continue;
      list_patch_half_spaces(s, vertices, hull, half_spaces, box);
      if (!half_spaces.empty() && is_entered(s, patch, other, half_spaces, box)) continue;
      for (const std::int32_t t : two.triangles) s.patch_of[at(t)] = patch;
      one.triangles.insert(one.triangles.end(), two.triangles.begin(), two.triangles.end());
      two = {};
      s.tree.remove(other);
      set_patch(s, patch, vertices, half_spaces, box);
      successor[at(other)] = patch;
      --s.patch_count;
      ++merged;
      again = true;
      break;
    }
  }
  return merged;
}

}  // namespace thigma
