#include "thigma/mesh/halfedge_flip.h"

#include "thigma/core/index.h"

namespace thigma {
namespace {

void set_corners(HalfedgeMesh& mesh, std::int32_t h, const std::array<std::int32_t, 3>& v) {
  mesh.triangles[idx(h / 3)][idx(h % 3)] = v[0];
  mesh.triangles[idx(h / 3)][idx(next_halfedge(h) % 3)] = v[1];
  mesh.triangles[idx(h / 3)][idx(previous_halfedge(h) % 3)] = v[2];
}

void link(HalfedgeMesh& mesh, std::int32_t h, std::int32_t other) {
  mesh.twin[idx(h)] = other;
  if (other >= 0) mesh.twin[idx(other)] = h;
}

/// Each corner takes its vertex' value along.
void carry_values(HalfedgeMesh& mesh, std::int32_t h, std::int32_t g) {
  auto& value = mesh.attributes.of_corner;
  const std::int32_t of_c = value[idx(previous_halfedge(h))],
                     of_d = value[idx(previous_halfedge(g))];
  value[idx(next_halfedge(h))] = of_d;
  value[idx(next_halfedge(g))] = of_c;
}

}  // namespace

FlipQuad quad_of(const HalfedgeMesh& mesh, std::int32_t halfedge) {
  const std::int32_t twin = mesh.twin[idx(halfedge)];
  return {{halfedge / 3, twin / 3},
          tail_of(mesh, halfedge),
          head_of(mesh, halfedge),
          tail_of(mesh, previous_halfedge(halfedge)),
          tail_of(mesh, previous_halfedge(twin))};
}

bool can_flip(const HalfedgeMesh& mesh, std::int32_t halfedge) {
  const std::int32_t twin = mesh.twin[idx(halfedge)];
  if (twin < 0) return false;
  const FlipQuad q = quad_of(mesh, halfedge);
  for (const std::int32_t v : {q.a, q.b, q.c, q.d})
    if (mesh.is_locked[idx(v)]) return false;
  if (q.c == q.d || find_halfedge(mesh, q.c, q.d) >= 0) return false;
  if (mesh.attributes.width == 0) return true;
  const auto& value = mesh.attributes.of_corner;
  return value[idx(halfedge)] == value[idx(next_halfedge(twin))] &&
         value[idx(next_halfedge(halfedge))] == value[idx(twin)];
}

void set_flipped_corners(HalfedgeMesh& mesh, std::int32_t halfedge, const FlipQuad& quad,
                         bool is_flipped) {
  const std::int32_t twin = mesh.twin[idx(halfedge)];
  set_corners(mesh, halfedge, {quad.a, is_flipped ? quad.d : quad.b, quad.c});
  set_corners(mesh, twin, {quad.b, is_flipped ? quad.c : quad.a, quad.d});
}

void flip_edge(HalfedgeMesh& mesh, std::int32_t halfedge) {
  const std::int32_t h = halfedge, g = mesh.twin[idx(halfedge)];
  const FlipQuad quad = quad_of(mesh, h);
  if (mesh.attributes.width > 0) carry_values(mesh, h, g);
  set_flipped_corners(mesh, h, quad, true);
  const std::int32_t beside_ad = mesh.twin[idx(next_halfedge(g))];
  const std::int32_t beside_bc = mesh.twin[idx(next_halfedge(h))];
  link(mesh, h, beside_ad);
  link(mesh, g, beside_bc);
  link(mesh, next_halfedge(h), next_halfedge(g));  // c d; c a and d b stay where they are
  mesh.outgoing[idx(quad.a)] = first_of_fan(mesh, h);
  mesh.outgoing[idx(quad.b)] = first_of_fan(mesh, g);
  mesh.outgoing[idx(quad.c)] = first_of_fan(mesh, previous_halfedge(h));
  mesh.outgoing[idx(quad.d)] = first_of_fan(mesh, previous_halfedge(g));
}

}  // namespace thigma
