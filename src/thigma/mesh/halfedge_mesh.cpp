#include "thigma/mesh/halfedge_mesh.h"

#include <algorithm>
#include <utility>

#include "thigma/core/index.h"
#include "thigma/mesh/topology.h"

namespace thigma {
namespace {

void lock_and_link(HalfedgeMesh& mesh, const EdgeTable& table) {
  for (const MeshEdge& edge : table.edges) {
    const auto uses = table.uses_of(edge);
    if (uses.size() == 2 && uses[0].is_forward != uses[1].is_forward) {
      const std::int32_t a = 3 * uses[0].triangle + uses[0].corner;
      const std::int32_t b = 3 * uses[1].triangle + uses[1].corner;
      mesh.twin[idx(a)] = b;
      mesh.twin[idx(b)] = a;
    } else if (uses.size() != 1) {
      mesh.is_locked[idx(edge.a)] = mesh.is_locked[idx(edge.b)] = 1;
    }
  }
}

struct Sides {  // of an edge that collapses: the triangle on either side, or -1
  std::int32_t left, right;
};

Sides sides_of(const HalfedgeMesh& mesh, std::int32_t h) { return {h, mesh.twin[idx(h)]}; }

/// Joins what was beside the two edges of a triangle that goes.
void close_gap(HalfedgeMesh& mesh, std::int32_t h) {
  const std::int32_t one = mesh.twin[idx(next_halfedge(h))];
  const std::int32_t other = mesh.twin[idx(previous_halfedge(h))];
  if (one >= 0) mesh.twin[idx(one)] = other;
  if (other >= 0) mesh.twin[idx(other)] = one;
}

/// A half-edge from the corner across the edge that survives the collapse.
std::int32_t surviving_from_apex(const HalfedgeMesh& mesh, std::int32_t h) {
  const std::int32_t one = mesh.twin[idx(next_halfedge(h))];  // runs apex -> head
  if (one >= 0) return one;
  return next_halfedge(mesh.twin[idx(previous_halfedge(h))]);  // from the twin tail -> apex
}

/// A half-edge from the vertex that stays.
std::int32_t surviving_from_tail(const HalfedgeMesh& mesh, std::int32_t h) {
  const std::int32_t one = mesh.twin[idx(previous_halfedge(h))];  // runs tail -> apex
  if (one >= 0) return one;
  return next_halfedge(mesh.twin[idx(next_halfedge(h))]);  // from the twin apex -> head
}

/// The values at the two ends of the edge on one of its sides become one.
void merge_values(HalfedgeMesh& mesh, std::int32_t at_tail, std::int32_t at_head, double share) {
  const auto width = static_cast<std::size_t>(mesh.attributes.width);
  double* kept = mesh.attributes.values.data() + idx(at_tail) * width;
  const double* other = mesh.attributes.values.data() + idx(at_head) * width;
  for (std::size_t i = 0; i < width; ++i) kept[i] += share * (other[i] - kept[i]);
}

struct ValuePair {
  std::int32_t at_tail = -1, at_head = -1;
};

void carry_attributes(HalfedgeMesh& mesh, std::int32_t h, double share,
                      const std::vector<std::int32_t>& corners) {
  auto& of_corner = mesh.attributes.of_corner;
  const std::int32_t opposite = mesh.twin[idx(h)];
  const ValuePair left{of_corner[idx(h)], of_corner[idx(next_halfedge(h))]};
  ValuePair right;
  if (opposite >= 0) right = {of_corner[idx(next_halfedge(opposite))], of_corner[idx(opposite)]};
  // A seam that begins at the tail has one value there for both sides: the right side then keeps
  // the index of its head.
  const bool begins_at_tail = right.at_tail == left.at_tail && right.at_head != left.at_head;
  if (begins_at_tail)
    merge_values(mesh, right.at_head, right.at_tail, 1.0 - share);
  else if (right.at_tail >= 0 && right.at_tail != left.at_tail)
    merge_values(mesh, right.at_tail, right.at_head, share);
  merge_values(mesh, left.at_tail, left.at_head, share);
  for (const std::int32_t c : corners) {
    if (of_corner[idx(c)] == left.at_head)
      of_corner[idx(c)] = left.at_tail;
    else if (!begins_at_tail && right.at_head >= 0 && of_corner[idx(c)] == right.at_head)
      of_corner[idx(c)] = right.at_tail;
  }
}

}  // namespace

std::int32_t first_of_fan(const HalfedgeMesh& mesh, std::int32_t h) noexcept {
  for (std::int32_t i = h;;) {
    const std::int32_t beside = mesh.twin[idx(i)];
    if (beside < 0) return i;
    i = next_halfedge(beside);
    if (i == h) return h;
  }
}

HalfedgeMesh build_halfedge_mesh(const TriangleMesh& mesh, CornerAttributes attributes) {
  HalfedgeMesh m;
  m.positions = mesh.positions;
  m.triangles = mesh.triangles;
  m.attributes = std::move(attributes);
  m.triangle_count = static_cast<std::int32_t>(mesh.triangles.size());
  m.twin.assign(3 * mesh.triangles.size(), -1);
  m.outgoing.assign(mesh.positions.size(), -1);
  m.is_locked.assign(mesh.positions.size(), 0);
  lock_and_link(m, build_edge_table(mesh));
  std::vector<std::int32_t> corners(mesh.positions.size(), 0), reached(mesh.positions.size(), 0);
  for (std::int32_t h = 0; h < 3 * m.triangle_count; ++h) {
    ++corners[idx(tail_of(m, h))];
    m.outgoing[idx(tail_of(m, h))] = h;
  }
  for (std::size_t v = 0; v < m.outgoing.size(); ++v) {
    if (m.outgoing[v] < 0) continue;
    m.outgoing[v] = first_of_fan(m, m.outgoing[v]);
    visit_fan(m, static_cast<std::int32_t>(v), [&](std::int32_t) { ++reached[v]; });
    if (reached[v] != corners[v]) m.is_locked[v] = 1;
  }
  return m;
}

std::int32_t find_halfedge(const HalfedgeMesh& mesh, std::int32_t a, std::int32_t b) {
  std::int32_t found = -1;
  visit_fan(mesh, a, [&](std::int32_t h) {
    if (head_of(mesh, h) == b) found = h;
  });
  if (found >= 0 || mesh.outgoing[idx(a)] < 0) return found;
  // On a boundary the last edge of the fan runs towards a alone.
  visit_fan(mesh, b, [&](std::int32_t h) {
    if (head_of(mesh, h) == a) found = h;
  });
  return found;
}

bool can_collapse(const HalfedgeMesh& mesh, std::int32_t halfedge) {
  const std::int32_t a = tail_of(mesh, halfedge), b = head_of(mesh, halfedge);
  if (mesh.is_locked[idx(a)] || mesh.is_locked[idx(b)]) return false;
  const auto [left, right] = sides_of(mesh, halfedge);
  if (right >= 0 && is_boundary(mesh, a) && is_boundary(mesh, b)) return false;
  const std::int32_t apex_left = tail_of(mesh, previous_halfedge(left));
  const std::int32_t apex_right = right >= 0 ? tail_of(mesh, previous_halfedge(right)) : -1;
  if (apex_left == apex_right) return false;
  int triangles = 0;
  bool is_clean = true;
  const auto is_apex = [&](std::int32_t v) { return v == apex_left || v == apex_right; };
  const auto meets_b = [&](std::int32_t v) {
    bool meets = false;
    visit_fan(mesh, b, [&](std::int32_t h) {
      meets = meets || head_of(mesh, h) == v || tail_of(mesh, previous_halfedge(h)) == v;
    });
    return meets;
  };
  visit_fan(mesh, a, [&](std::int32_t h) {
    ++triangles;
    for (const std::int32_t v : {head_of(mesh, h), tail_of(mesh, previous_halfedge(h))})
      is_clean = is_clean && (v == b || is_apex(v) || !meets_b(v));
  });
  if (!is_clean) return false;
  visit_fan(mesh, b, [&](std::int32_t) { ++triangles; });
  // What is left around the vertex: three triangles close it, one is enough on a boundary.
  const bool is_open = right < 0 || is_boundary(mesh, a) || is_boundary(mesh, b);
  const int left_over = triangles - (right >= 0 ? 4 : 2);
  return left_over >= (is_open ? 1 : 3);
}

std::array<std::int32_t, 2> collapse_edge(HalfedgeMesh& mesh, std::int32_t halfedge,
                                          const Vec3& position, double share) {
  const std::int32_t a = tail_of(mesh, halfedge), b = head_of(mesh, halfedge);
  const auto [left, right] = sides_of(mesh, halfedge);
  std::vector<std::int32_t> at_head, corners;
  visit_fan(mesh, b, [&](std::int32_t h) { at_head.push_back(h); });
  if (mesh.attributes.width > 0) {
    corners = at_head;
    visit_fan(mesh, a, [&](std::int32_t h) { corners.push_back(h); });
    carry_attributes(mesh, halfedge, share, corners);
  }
  std::int32_t start = -1;
  for (const std::int32_t h : at_head)
    if (h / 3 != left / 3 && (right < 0 || h / 3 != right / 3)) start = h;
  if (start < 0) start = surviving_from_tail(mesh, left);
  std::array<std::int32_t, 2> apexes = {-1, -1}, apex_edges = {-1, -1};
  const std::array<std::int32_t, 2> edges = {left, right};
  for (std::size_t i = 0; i < 2; ++i) {
    if (edges[i] < 0) continue;
    apexes[i] = tail_of(mesh, previous_halfedge(edges[i]));
    apex_edges[i] = surviving_from_apex(mesh, edges[i]);
  }
  for (const std::int32_t h : at_head) mesh.triangles[idx(h / 3)][idx(h % 3)] = a;
  for (const std::int32_t h : edges)
    if (h >= 0) close_gap(mesh, h);
  std::array<std::int32_t, 2> removed = {-1, -1};
  for (std::size_t i = 0; i < 2; ++i) {
    if (edges[i] < 0) continue;
    removed[i] = edges[i] / 3;
    mesh.triangles[idx(removed[i])] = {-1, -1, -1};
    for (std::int32_t k = 0; k < 3; ++k) mesh.twin[idx(3 * removed[i] + k)] = -1;
    --mesh.triangle_count;
    mesh.outgoing[idx(apexes[i])] = first_of_fan(mesh, apex_edges[i]);
  }
  mesh.outgoing[idx(b)] = -1;
  mesh.outgoing[idx(a)] = first_of_fan(mesh, start);
  mesh.positions[idx(a)] = position;
  return removed;
}

std::int64_t count_halfedge_faults(const HalfedgeMesh& mesh) {
  std::int64_t faults = 0;
  std::int32_t alive = 0;
  std::vector<std::int32_t> corners(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    if (v[0] < 0) continue;
    ++alive;
    faults += v[0] == v[1] || v[1] == v[2] || v[2] == v[0];
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t h = static_cast<std::int32_t>(3 * t) + k, other = mesh.twin[idx(h)];
      ++corners[idx(tail_of(mesh, h))];
      if (other < 0) continue;
      faults += mesh.twin[idx(other)] != h || mesh.triangles[idx(other / 3)][0] < 0 ||
                tail_of(mesh, other) != head_of(mesh, h) ||
                head_of(mesh, other) != tail_of(mesh, h);
    }
  }
  faults += alive != mesh.triangle_count;
  if (faults > 0) return faults;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.is_locked[v]) continue;
    std::int32_t reached = 0;
    bool starts_here = true;
    visit_fan(mesh, static_cast<std::int32_t>(v), [&](std::int32_t h) {
      starts_here = starts_here && tail_of(mesh, h) == static_cast<std::int32_t>(v);
      ++reached;
    });
    faults += reached != corners[v] || !starts_here;
  }
  return faults;
}

CompactMesh compact(const HalfedgeMesh& mesh) {
  CompactMesh result;
  std::vector<std::int32_t> place(mesh.positions.size(), -1);
  const bool has_values = mesh.attributes.width > 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (mesh.triangles[t][0] < 0) continue;
    result.triangles.push_back(static_cast<std::int32_t>(t));
    for (const std::int32_t v : mesh.triangles[t]) place[idx(v)] = 0;
  }
  for (std::size_t v = 0; v < place.size(); ++v) {
    if (place[v] < 0) continue;
    place[v] = static_cast<std::int32_t>(result.vertices.size());
    result.vertices.push_back(static_cast<std::int32_t>(v));
    result.mesh.positions.push_back(mesh.positions[v]);
  }
  result.attributes.width = mesh.attributes.width;
  result.attributes.values = mesh.attributes.values;
  for (const std::int32_t t : result.triangles) {
    const auto& v = mesh.triangles[idx(t)];
    result.mesh.triangles.push_back({place[idx(v[0])], place[idx(v[1])], place[idx(v[2])]});
    for (std::int32_t k = 0; has_values && k < 3; ++k)
      result.attributes.of_corner.push_back(mesh.attributes.of_corner[idx(3 * t + k)]);
  }
  return result;
}

}  // namespace thigma
