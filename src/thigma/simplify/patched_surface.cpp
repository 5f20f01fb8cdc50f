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
bool takes_flat_triangle(const PatchedSurface& surface, const SurfacePatch& patch, std::int32_t t) {
  auto count = static_cast<int>(patch.vertices.size());
  for (const std::int32_t v : surface.mesh.triangles[idx(t)]) {
    if (contains(patch.vertices, v)) continue;
    ++count;
    for (const std::int32_t other : patch.triangles)
      if (has_plane(surface, other) &&
          height_over(surface, other, surface.mesh.positions[idx(v)]) > surface.flat)
        return false;
  }
  return count <= surface.max_vertices;
}

/// Over its longest edge, on which its third corner lies, a triangle adds nothing to a hull.
std::int32_t longest_edge(const PatchedSurface& surface, std::int32_t t) {
  const std::array<Vec3, 3> c = corners_of(surface, t);
  std::int32_t longest = 0;
  for (std::int32_t k = 1; k < 3; ++k)
    if ((c[idx((k + 1) % 3)] - c[idx(k)]).squaredNorm() >
        (c[idx((longest + 1) % 3)] - c[idx(longest)]).squaredNorm())
      longest = k;
  return 3 * t + longest;
}

void place_flat_triangle(PatchedSurface& surface, std::int32_t t, std::int32_t shell) {
  std::int32_t home = -1;
  const std::int32_t beside = surface.mesh.twin[idx(longest_edge(surface, t))];
  if (beside >= 0) {
    const std::int32_t patch = surface.patch_of[idx(beside / 3)];
    if (patch >= 0 && takes_flat_triangle(surface, surface.patches[idx(patch)], t)) home = patch;
  }
  if (home < 0) {
    home = static_cast<std::int32_t>(surface.patches.size());
    surface.patches.emplace_back();
    surface.patches.back().shell = shell;
  }
  SurfacePatch& patch = surface.patches[idx(home)];
  patch.triangles.push_back(t);
  for (const std::int32_t v : surface.mesh.triangles[idx(t)])
    if (!contains(patch.vertices, v)) patch.vertices.push_back(v);
  surface.patch_of[idx(t)] = home;
}

/// Whether every vertex of one patch is below every plane of the other.
bool lies_below(const PatchedSurface& surface, const SurfacePatch& lower,
                const SurfacePatch& upper) {
  for (const std::int32_t t : upper.triangles) {
    if (!has_plane(surface, t)) continue;
    for (const std::int32_t v : lower.vertices)
      if (height_over(surface, t, surface.mesh.positions[idx(v)]) > surface.flat) return false;
  }
  return true;
}

bool is_entered(const PatchedSurface& surface, std::int32_t one, std::int32_t other,
                const std::vector<HalfSpace>& half_spaces, const TreeBox& box) {
  bool entered = false;
  const std::int32_t shell = surface.patches[idx(one)].shell;
  surface.tree.visit(box, [&](std::int32_t patch) {
    if (entered || patch == one || patch == other || surface.patches[idx(patch)].shell != shell ||
        !surface.patches[idx(patch)].box.overlaps(box))
      return;
    for (const std::int32_t t : surface.patches[idx(patch)].triangles)
      if (!entered && intrudes(surface, t, half_spaces, box)) entered = true;
  });
  return entered;
}

/// Patches across the rim, in order of the triangles, without those across a reflex edge.
void list_mergeable(const PatchedSurface& surface, std::int32_t patch,
                    std::vector<std::int32_t>& found) {
  std::vector<std::int32_t> reflex;
  found.clear();
  for (const std::int32_t t : surface.patches[idx(patch)].triangles)
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t beside = surface.mesh.twin[idx(3 * t + k)];
      if (beside < 0) continue;
      const std::int32_t other = surface.patch_of[idx(beside / 3)];
      if (other == patch) continue;
      const std::int32_t apex = tail_of(surface.mesh, previous_halfedge(beside));
      if (has_plane(surface, t) &&
          height_over(surface, t, surface.mesh.positions[idx(apex)]) > surface.flat)
        reflex.push_back(other);
      else if (!contains(found, other))
        found.push_back(other);
    }
  std::erase_if(found, [&](std::int32_t p) { return contains(reflex, p); });
}

}  // namespace

void refresh_triangle(PatchedSurface& surface, std::int32_t t) {
  const std::array<Vec3, 3> c = corners_of(surface, t);
  const Vec3 ab = c[1] - c[0], ac = c[2] - c[0];
  const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
  const Vec3 cross = ab.cross(ac);
  const double length = cross.norm();
  // As in the decomposition: below this the direction of the normal is rounding alone.
  const bool has_area = length > 1e-15 * longest2;
  surface.box[idx(t)] = box_of(c);
  surface.normal[idx(t)] = has_area ? Vec3(cross / length) : Vec3(Vec3::Zero());
  surface.height[idx(t)] = has_area ? length / std::sqrt(longest2) : 0.0;
}

void list_half_spaces_of(const PatchedSurface& surface, std::span<const Vec3> points,
                         Quickhull& hull, std::vector<HalfSpace>& half_spaces, TreeBox& box) {
  points = points.first(std::min<std::size_t>(points.size(), kMaxHullVertices));
  box = {points[0], points[0]};
  for (const Vec3& p : points.subspan(1)) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  half_spaces.clear();
  if (points.size() < 4) return;
  start_hull(hull, points, std::max(1e-10, surface.flat / (box.max - box.min).norm()));
  if (hull.dimension < 3) return;
  complete_hull(hull);
  list_half_spaces(hull, surface.inset, half_spaces);
  for (HalfSpace& h : half_spaces) h.offset = h.offset / hull.scale + h.normal.dot(hull.origin);
}

void list_patch_half_spaces(const PatchedSurface& surface,
                            const std::vector<std::int32_t>& vertices, Quickhull& hull,
                            std::vector<HalfSpace>& half_spaces, TreeBox& box) {
  std::array<Vec3, kMaxHullVertices> points;
  const std::size_t count = std::min(vertices.size(), points.size());
  for (std::size_t i = 0; i < count; ++i) points[i] = surface.mesh.positions[idx(vertices[i])];
  list_half_spaces_of(surface, {points.data(), count}, hull, half_spaces, box);
}

bool intrudes(const PatchedSurface& surface, std::int32_t t,
              const std::vector<HalfSpace>& half_spaces, const TreeBox& box) {
  return !half_spaces.empty() && surface.box[idx(t)].overlaps(box) &&
         surface.height[idx(t)] > 0.0 && reaches_into(corners_of(surface, t), half_spaces);
}

void set_patch(PatchedSurface& surface, std::int32_t patch, std::vector<std::int32_t>& vertices,
               std::vector<HalfSpace>& half_spaces, const TreeBox& box) {
  SurfacePatch& p = surface.patches[idx(patch)];
  p.vertices.assign(vertices.begin(), vertices.end());
  p.half_spaces.assign(half_spaces.begin(), half_spaces.end());
  p.box = box;
  surface.tree.update(patch, box);
}

PatchedSurface build_patched_surface(const DecomposedSurface& decomposed, double convexity,
                                     double protrusion, CornerAttributes attributes) {
  const TriangleMesh& mesh = decomposed.mesh;
  const ConvexDecomposition& decomposition = decomposed.patches;
  PatchedSurface surface;
  surface.mesh = build_halfedge_mesh(mesh, std::move(attributes));
  surface.radius = enclosing_ball(mesh.positions).radius;
  surface.flat = std::max(convexity, decomposition.params.convexity_tolerance) * surface.radius;
  surface.inset = std::max(protrusion, decomposition.params.protrusion_tolerance) * surface.radius;
  surface.max_vertices = decomposition.params.max_vertices;
  surface.patch_of = decomposition.patch_of_triangle;
  surface.normal.resize(mesh.triangles.size());
  surface.height.resize(mesh.triangles.size());
  surface.box.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    refresh_triangle(surface, static_cast<std::int32_t>(t));
  const std::vector<std::int32_t>& shell = decomposed.topology.shell;
  surface.patches.resize(decomposition.patches.size());
  for (std::size_t i = 0; i < surface.patches.size(); ++i) {
    surface.patches[i].triangles = decomposition.patches[i];
    surface.patches[i].vertices = decomposition.vertices[i];
    surface.patches[i].shell = shell[idx(decomposition.patches[i][0])];
  }
  for (std::size_t t = 0; t < surface.patch_of.size(); ++t)
    if (surface.patch_of[t] < 0)
      place_flat_triangle(surface, static_cast<std::int32_t>(t), shell[t]);
  Quickhull hull;
  std::vector<TreeBox> boxes;
  for (SurfacePatch& patch : surface.patches) {
    list_patch_half_spaces(surface, patch.vertices, hull, patch.half_spaces, patch.box);
    boxes.push_back(patch.box);
  }
  surface.tree.build(boxes);
  surface.patch_count = static_cast<std::int32_t>(surface.patches.size());
  return surface;
}

int merge_patch(PatchedSurface& surface, std::int32_t patch, Quickhull& hull,
                std::vector<std::int32_t>& successor) {
  std::vector<std::int32_t> candidates, vertices;
  std::vector<HalfSpace> half_spaces;
  TreeBox box;
  int merged = 0;
  for (bool again = true; again;) {
    again = false;
    list_mergeable(surface, patch, candidates);
    for (const std::int32_t other : candidates) {
      SurfacePatch &one = surface.patches[idx(patch)], &two = surface.patches[idx(other)];
      vertices = one.vertices;
      for (const std::int32_t v : two.vertices)
        if (!contains(one.vertices, v)) vertices.push_back(v);
      if (static_cast<int>(vertices.size()) > surface.max_vertices) continue;
      if (!lies_below(surface, two, one) || !lies_below(surface, one, two)) continue;
      list_patch_half_spaces(surface, vertices, hull, half_spaces, box);
      if (!half_spaces.empty() && is_entered(surface, patch, other, half_spaces, box)) continue;
      for (const std::int32_t t : two.triangles) surface.patch_of[idx(t)] = patch;
      one.triangles.insert(one.triangles.end(), two.triangles.begin(), two.triangles.end());
      two = {};
      surface.tree.remove(other);
      set_patch(surface, patch, vertices, half_spaces, box);
      successor[idx(other)] = patch;
      --surface.patch_count;
      ++merged;
      again = true;
      break;
    }
  }
  return merged;
}

}  // namespace thigma
