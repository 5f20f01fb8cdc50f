#pragma once
// The triangles beside some triangles of a surface.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// The triangles at each vertex of a mesh: of vertex v those from first[v] to first[v + 1].
struct VertexTriangles {
  std::vector<std::int32_t> first;  // empty: of no mesh
  std::vector<std::int32_t> triangles;
};

/// Thread    [offline]; throws std::bad_alloc.
VertexTriangles vertex_triangles(const TriangleMesh& mesh);

/// Marks of triangles, for one set after the other.
struct TriangleMarks {
  std::vector<std::uint32_t> of;  // one a triangle; is in the set where it equals `round`
  std::uint32_t round = 0;

  /// Empties the set.
  void begin() noexcept;
  /// Adds a triangle. False where it is there already.
  bool add(std::int32_t triangle) noexcept;
};

/// Triangles that share a vertex with some, and are not marked.
///
/// at_vertex  of `mesh`; empty: there are none
/// marks      of the triangles themselves; those found are marked too
/// ring       they are added to it
/// Thread     [contact]; no failure; allocates where `ring` has too little room.
void add_ring(const TriangleMesh& mesh, const VertexTriangles& at_vertex,
              std::span<const std::int32_t> triangles, TriangleMarks& marks,
              std::vector<std::int32_t>& ring) noexcept;

}  // namespace thigma
