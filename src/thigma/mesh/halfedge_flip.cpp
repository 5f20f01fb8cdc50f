#include "thigma/mesh/halfedge_flip.h"

#include "thigma/core/index.h"

namespace thigma {
namespace {

void set_corners(HalfedgeMesh& m, std::int32_t h, const std::array<std::int32_t, 3>& v) {
  m.triangles[at(h / 3)][at(h % 3)] = v[0];
  m.triangles[at(h / 3)][at(next_halfedge(h) % 3)] = v[1];
  m.triangles[at(h / 3)][at(previous_halfedge(h) % 3)] = v[2];
}

void link(HalfedgeMesh& m, std::int32_t h, std::int32_t other) {
  m.twin[at(h)] = other;
  if (other >= 0) m.twin[at(other)] = h;
}

/// Each corner takes its vertex' value along.
void carry_values(HalfedgeMesh& m, std::int32_t h, std::int32_t g) {
  auto& value = m.attributes.of_corner;
  const std::int32_t of_c = value[at(previous_halfedge(h))], of_d = value[at(previous_halfedge(g))];
  value[at(next_halfedge(h))] = of_d;
  value[at(next_halfedge(g))] = of_c;
}

}  // namespace

FlipQuad quad_of(const HalfedgeMesh& m, std::int32_t halfedge) {
  const std::int32_t twin = m.twin[at(halfedge)];
  return {{halfedge / 3, twin / 3},
          tail_of(m, halfedge),
          head_of(m, halfedge),
          tail_of(m, previous_halfedge(halfedge)),
          tail_of(m, previous_halfedge(twin))};
}

bool can_flip(const HalfedgeMesh& m, std::int32_t halfedge) {
  const std::int32_t twin = m.twin[at(halfedge)];
  if (twin < 0) return false;
  const FlipQuad q = quad_of(m, halfedge);
  for (const std::int32_t v : {q.a, q.b, q.c, q.d})
    if (m.is_locked[at(v)]) return false;
  if (q.c == q.d || find_halfedge(m, q.c, q.d) >= 0) return false;
  if (m.attributes.width == 0) return true;
  const auto& value = m.attributes.of_corner;
  return value[at(halfedge)] == value[at(next_halfedge(twin))] &&
         value[at(next_halfedge(halfedge))] == value[at(twin)];
}

void set_flipped_corners(HalfedgeMesh& m, std::int32_t halfedge, const FlipQuad& quad,
                         bool is_flipped) {
  const std::int32_t twin = m.twin[at(halfedge)];
  set_corners(m, halfedge, {quad.a, is_flipped ? quad.d : quad.b, quad.c});
  set_corners(m, twin, {quad.b, is_flipped ? quad.c : quad.a, quad.d});
}

void flip_edge(HalfedgeMesh& m, std::int32_t halfedge) {
  const std::int32_t h = halfedge, g = m.twin[at(halfedge)];
  const FlipQuad quad = quad_of(m, h);
  if (m.attributes.width > 0) carry_values(m, h, g);
  set_flipped_corners(m, h, quad, true);
  const std::int32_t beside_ad = m.twin[at(next_halfedge(g))];
  const std::int32_t beside_bc = m.twin[at(next_halfedge(h))];
  link(m, h, beside_ad);
  link(m, g, beside_bc);
  link(m, next_halfedge(h), next_halfedge(g));  // c d; c a and d b stay where they are
  m.outgoing[at(quad.a)] = first_of_fan(m, h);
  m.outgoing[at(quad.b)] = first_of_fan(m, g);
  m.outgoing[at(quad.c)] = first_of_fan(m, previous_halfedge(h));
  m.outgoing[at(quad.d)] = first_of_fan(m, previous_halfedge(g));
}

}  // namespace thigma
