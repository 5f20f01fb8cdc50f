#include "thigma/simplify/detail/patch_part.h"

#include <algorithm>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

bool contains(const std::vector<std::int32_t>& list, std::int32_t value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

bool has_edge(const PatchedSurface& surface, const PatchPart& part, std::int32_t from,
              std::int32_t to) {
  for (const std::int32_t t : part.triangles) {
    const auto& v = surface.mesh.triangles[idx(t)];
    for (std::size_t k = 0; k < 3; ++k)
      if (v[k] == from && v[(k + 1) % 3] == to) return true;
  }
  return false;
}

/// By their corners: the neighbours of triangles on trial are not yet linked.
bool share_an_edge(const PatchedSurface& surface, const PatchPart& one, const PatchPart& other) {
  for (const std::int32_t t : one.triangles) {
    const auto& v = surface.mesh.triangles[idx(t)];
    for (std::size_t k = 0; k < 3; ++k)
      if (contains(other.vertices, v[k]) && contains(other.vertices, v[(k + 1) % 3]) &&
          has_edge(surface, other, v[(k + 1) % 3], v[k]))
        return true;
  }
  return false;
}

bool lies_below(const PatchedSurface& surface, const PatchPart& lower, const PatchPart& upper) {
  for (const std::int32_t t : upper.triangles) {
    if (!has_plane(surface, t)) continue;
    for (const std::int32_t v : lower.vertices)
      if (height_over(surface, t, surface.mesh.positions[idx(v)]) > surface.flat) return false;
  }
  return true;
}

void list_vertices(const PatchedSurface& surface, PatchPart& part) {
  part.vertices.clear();
  for (const std::int32_t t : part.triangles)
    for (const std::int32_t v : surface.mesh.triangles[idx(t)])
      if (!contains(part.vertices, v)) part.vertices.push_back(v);
}

/// Fills the vertices and the hull of both together; false when that is no patch.
bool join(const ShellOnTrial& shell, const PatchPart& one, const PatchPart& other, Quickhull& hull,
          PatchPart& joint) {
  const PatchedSurface& surface = shell.surface;
  if (!share_an_edge(surface, one, other)) return false;
  joint.vertices = one.vertices;
  for (const std::int32_t v : other.vertices)
    if (!contains(one.vertices, v)) joint.vertices.push_back(v);
  if (static_cast<int>(joint.vertices.size()) > surface.max_vertices) return false;
  if (!lies_below(surface, one, other) || !lies_below(surface, other, one)) return false;
  list_patch_half_spaces(surface, joint.vertices, hull, joint.half_spaces, joint.box);
  return is_hull_clear(shell, one, &other, joint.half_spaces, joint.box);
}

void absorb(PatchPart& one, PatchPart& other, PatchPart& joint) {
  one.triangles.insert(one.triangles.end(), other.triangles.begin(), other.triangles.end());
  one.vertices.swap(joint.vertices);
  one.half_spaces.swap(joint.half_spaces);
  one.box = joint.box;
  if (one.patch < 0) one.patch = other.patch;
  other.is_absorbed = true;
}

}  // namespace

void describe_part(const PatchedSurface& surface, PatchPart& part, Quickhull& hull) {
  list_vertices(surface, part);
  list_patch_half_spaces(surface, part.vertices, hull, part.half_spaces, part.box);
}

void append_rest(const PatchedSurface& surface, std::int32_t patch, std::int32_t without,
                 std::vector<PatchPart>& parts) {
  std::vector<std::int32_t> left = surface.patches[idx(patch)].triangles;
  std::erase(left, without);
  for (std::int32_t number = patch; !left.empty(); number = -1) {
    PatchPart part;
    part.patch = number;
    part.triangles.assign(1, left.front());
    left.erase(left.begin());
    for (std::size_t i = 0; i < part.triangles.size(); ++i)
      for (std::int32_t k = 0; k < 3; ++k) {
        const std::int32_t beside = surface.mesh.twin[idx(3 * part.triangles[i] + k)];
        const auto found = std::find(left.begin(), left.end(), beside < 0 ? -1 : beside / 3);
        if (found == left.end()) continue;
        part.triangles.push_back(*found);
        left.erase(found);
      }
    parts.push_back(std::move(part));
  }
}

bool is_hull_clear(const ShellOnTrial& shell, const PatchPart& part, const PatchPart* beside,
                   const std::vector<HalfSpace>& half_spaces, const TreeBox& box) {
  const PatchedSurface& surface = shell.surface;
  if (half_spaces.empty()) return true;
  bool is_clear = true;
  const auto test = [&](std::int32_t t) {
    if (is_clear && intrudes(surface, t, half_spaces, box))
      is_clear = contains(part.triangles, t) || (beside && contains(beside->triangles, t));
  };
  surface.tree.visit(box, [&](std::int32_t patch) {
    const SurfacePatch& p = surface.patches[idx(patch)];
    if (!is_clear || p.shell != shell.shell || !p.box.overlaps(box)) return;
    for (const std::int32_t t : p.triangles) test(t);
  });
  for (const std::int32_t t : shell.moved) test(t);
  return is_clear;
}

int merge_parts(const ShellOnTrial& shell, std::size_t count, Quickhull& hull,
                std::vector<PatchPart>& parts) {
  int absorbed = 0;
  PatchPart joint;
  for (std::size_t i = 0; i < count; ++i)
    for (bool again = true; again && !parts[i].is_absorbed;) {
      again = false;
      for (std::size_t j = 0; j < parts.size() && !again; ++j) {
        if (j == i || parts[j].is_absorbed) continue;
        if (!join(shell, parts[i], parts[j], hull, joint)) continue;
        absorb(parts[i], parts[j], joint);
        ++absorbed;
        again = true;
      }
    }
  return absorbed;
}

}  // namespace thigma::detail
