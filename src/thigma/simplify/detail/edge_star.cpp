#include "thigma/simplify/detail/edge_star.h"

#include <algorithm>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

void add_patch(EdgeStar& star, std::int32_t patch) {
  if (std::find(star.patches.begin(), star.patches.end(), patch) == star.patches.end())
    star.patches.push_back(patch);
}

void add_fan(const PatchedSurface& surface, std::int32_t v, EdgeStar& star) {
  visit_fan(surface.mesh, v, [&](std::int32_t h) {
    const std::int32_t t = h / 3;
    if (t == star.removed[0] || t == star.removed[1]) return;
    StarTriangle triangle;
    triangle.triangle = t;
    triangle.a = head_of(surface.mesh, h);
    triangle.b = tail_of(surface.mesh, previous_halfedge(h));
    triangle.patch = surface.patch_of[idx(t)];
    const std::int32_t beyond = surface.mesh.twin[idx(next_halfedge(h))];
    triangle.beyond = beyond >= 0 ? beyond / 3 : -1;
    add_patch(star, triangle.patch);
    star.triangles.push_back(triangle);
  });
}

}  // namespace

void gather_star(const PatchedSurface& surface, std::int32_t halfedge, EdgeStar& star) {
  star.halfedge = halfedge;
  star.tail = tail_of(surface.mesh, halfedge);
  star.head = head_of(surface.mesh, halfedge);
  const std::int32_t opposite = surface.mesh.twin[idx(halfedge)];
  star.removed = {halfedge / 3, opposite >= 0 ? opposite / 3 : -1};
  star.is_tail_on_boundary = is_boundary(surface.mesh, star.tail);
  star.is_head_on_boundary = is_boundary(surface.mesh, star.head);
  star.triangles.clear();
  star.patches.clear();
  add_fan(surface, star.tail, star);
  add_fan(surface, star.head, star);
  for (const std::int32_t t : star.removed)
    if (t >= 0) add_patch(star, surface.patch_of[idx(t)]);
  for (StarTriangle& t : star.triangles)
    for (std::size_t i = 0; i < star.triangles.size(); ++i)
      if (star.triangles[i].a == t.b) t.following = static_cast<std::int32_t>(i);
}

void list_rim_boxes(const PatchedSurface& surface, const EdgeStar& star,
                    std::vector<TreeBox>& boxes) {
  boxes.clear();
  for (const StarTriangle& t : star.triangles)
    if (t.beyond >= 0) boxes.push_back(surface.box[idx(t.beyond)]);
}

void list_ring(const PatchedSurface& surface, const EdgeStar& star,
               std::vector<RingTriangle>& ring) {
  ring.clear();
  for (const StarTriangle& t : star.triangles) {
    RingTriangle r;
    r.a = surface.mesh.positions[idx(t.a)];
    r.b = surface.mesh.positions[idx(t.b)];
    r.has_beyond = t.beyond >= 0;
    if (r.has_beyond) {
      const auto& v = surface.mesh.triangles[idx(t.beyond)];
      for (const std::int32_t apex : v)
        if (apex != t.a && apex != t.b) r.beyond = surface.mesh.positions[idx(apex)];
    }
    r.has_following = t.following >= 0;
    if (r.has_following)
      r.following = surface.mesh.positions[idx(star.triangles[idx(t.following)].b)];
    ring.push_back(r);
  }
}

void list_patch_vertices(const PatchedSurface& surface, const EdgeStar& star, std::int32_t patch,
                         std::vector<std::int32_t>& vertices) {
  vertices.clear();
  const SurfacePatch& p = surface.patches[idx(patch)];
  std::size_t going = 0;
  for (const std::int32_t t : star.removed) going += t >= 0 && surface.patch_of[idx(t)] == patch;
  if (going == p.triangles.size()) return;
  const bool keeps_star = std::any_of(star.triangles.begin(), star.triangles.end(),
                                      [&](const StarTriangle& t) { return t.patch == patch; });
  std::array<std::int32_t, 2> apex{-1, -1};  // corners that only a removed triangle may have had
  for (std::size_t i = 0; i < 2; ++i) {
    if (star.removed[i] < 0 || surface.patch_of[idx(star.removed[i])] != patch) continue;
    for (const std::int32_t v : surface.mesh.triangles[idx(star.removed[i])])
      if (v != star.tail && v != star.head) apex[i] = v;
    for (const std::int32_t t : p.triangles) {
      if (t == star.removed[0] || t == star.removed[1]) continue;
      const auto& v = surface.mesh.triangles[idx(t)];
      if (v[0] == apex[i] || v[1] == apex[i] || v[2] == apex[i]) {
        apex[i] = -1;
        break;
      }
    }
  }
  if (keeps_star) vertices.push_back(star.tail);
  for (const std::int32_t v : p.vertices)
    if (v != star.tail && v != star.head && v != apex[0] && v != apex[1]) vertices.push_back(v);
}

}  // namespace thigma::detail
