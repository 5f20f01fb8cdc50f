#pragma once
// A triangle mesh whose edges can be collapsed: who is beside whom, kept right by every collapse.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Values that ride on the corners of triangles: texture coordinates and the like. Corners that
/// share an index share the value; a seam is where the corners of one vertex differ.
struct CornerAttributes {
  int width = 0;                        // numbers of a value
  std::vector<double> values;           // (count x width)
  std::vector<std::int32_t> of_corner;  // value of corner 3 t + k (3 m)
};

/// Oriented triangles with their neighbours. Half-edge h = 3 t + k runs along triangle t from its
/// corner k to the next.
/// Invariant (count_halfedge_faults): twins run between the same vertices in opposite directions;
/// the half-edges around a vertex that is not locked are one fan, and outgoing starts it.
struct HalfedgeMesh {
  std::vector<Vec3> positions;                         // [m]; those of removed vertices stay behind
  std::vector<std::array<std::int32_t, 3>> triangles;  // all -1 where removed (m)
  std::vector<std::int32_t> twin;                      // -1 along a boundary (3 m)
  std::vector<std::int32_t> outgoing;  // a half-edge that starts at the vertex, on a boundary the
                                       // one without twin; -1 without triangles (n)
  std::vector<char> is_locked;  // on an edge of three faces, of faces turned against each other, or
                                // at a pinch: no edge to it collapses (n)
  CornerAttributes attributes;  // width 0: none
  std::int32_t triangle_count = 0;  // of those not removed
};

/// Neighbours from shared indices. Any oriented or unoriented triangle soup is accepted: where it
/// is not a manifold its vertices are locked.
///
/// mesh        no triangle repeats an index
/// attributes  copied; of_corner has 3 m entries, or width is 0
/// Thread      [offline]; deterministic.
HalfedgeMesh build_halfedge_mesh(const TriangleMesh& mesh, CornerAttributes attributes = {});

constexpr std::int32_t next_halfedge(std::int32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr std::int32_t previous_halfedge(std::int32_t h) noexcept {
  return h % 3 == 0 ? h + 2 : h - 1;
}
inline std::int32_t tail_of(const HalfedgeMesh& mesh, std::int32_t h) noexcept {
  return mesh.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
}
inline std::int32_t head_of(const HalfedgeMesh& mesh, std::int32_t h) noexcept {
  return tail_of(mesh, next_halfedge(h));
}
/// Where the fan of a vertex begins, from any half-edge that starts at it; h itself where the fan
/// is closed.
std::int32_t first_of_fan(const HalfedgeMesh& mesh, std::int32_t h) noexcept;
/// On a boundary, by a vertex that is not locked and has a triangle.
inline bool is_boundary(const HalfedgeMesh& mesh, std::int32_t v) noexcept {
  return mesh.twin[static_cast<std::size_t>(mesh.outgoing[static_cast<std::size_t>(v)])] < 0;
}

/// Calls visit(h) for each half-edge that starts at the vertex, counter-clockwise; at a locked
/// vertex for one fan only.
template <class Visit>
void visit_fan(const HalfedgeMesh& mesh, std::int32_t v, Visit visit) {
  const std::int32_t first = mesh.outgoing[static_cast<std::size_t>(v)];
  std::int32_t h = first;
  while (h >= 0) {
    visit(h);
    h = mesh.twin[static_cast<std::size_t>(previous_halfedge(h))];
    if (h == first) return;
  }
}

/// Half-edge from a to b, -1 when there is none; a is not locked.
std::int32_t find_halfedge(const HalfedgeMesh& mesh, std::int32_t a, std::int32_t b);

/// Whether collapsing the edge leaves the same surface: neither end locked, no boundary pinched or
/// closed, and the ends share no neighbour but the corners across the edge (link condition, Dey et
/// al. 1999).
/// Thread    [offline].
bool can_collapse(const HalfedgeMesh& mesh, std::int32_t halfedge);

/// Collapses an edge for which can_collapse holds. Its tail stays, at `position`; its head and the
/// triangles along it go.
///
/// position   of the vertex that stays [m]
/// share      how far the vertex has gone from tail to head, 0..1: mixes the corner values of both
///            sides; the corners of other seams at the two ends keep theirs
/// returns    the triangles that went, -1 for none
std::array<std::int32_t, 2> collapse_edge(HalfedgeMesh& mesh, std::int32_t halfedge,
                                          const Vec3& position, double share = 0.5);

/// Breaches of the invariant; 0 for a right mesh.
/// Thread    [offline].
std::int64_t count_halfedge_faults(const HalfedgeMesh& mesh);

/// The triangles that are left, renumbered; kept lists their old numbers, vertices the old numbers
/// of the positions.
struct CompactMesh {
  TriangleMesh mesh;
  std::vector<std::int32_t> triangles, vertices;
  CornerAttributes attributes;
};
CompactMesh compact(const HalfedgeMesh& mesh);

}  // namespace thigma
