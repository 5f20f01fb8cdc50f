#pragma once
// Which faces meet along which edges and around which vertices.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// One face along an edge.
struct EdgeUse {
  std::int32_t triangle = -1;
  std::int8_t corner = 0;  // the edge runs from this corner to the next
  bool is_forward = true;  // from the edge's smaller vertex to its larger
};

/// An edge: two vertices and the faces along it.
struct MeshEdge {
  std::int32_t a = -1, b = -1;  // a < b
  std::int32_t first_use = 0, use_count = 0;
};

/// Edges of a mesh, sorted by their vertices. Triangles that repeat an index are not allowed.
struct EdgeTable {
  std::vector<MeshEdge> edges;
  std::vector<EdgeUse> uses;                             // by edge, then by triangle
  std::vector<std::array<std::int32_t, 3>> of_triangle;  // edge from corner k to k + 1 (m)

  std::span<const EdgeUse> uses_of(const MeshEdge& e) const {
    return {uses.data() + e.first_use, static_cast<std::size_t>(e.use_count)};
  }
};

EdgeTable build_edge_table(const TriangleMesh& mesh);

/// Groups of triangles, numbered in the order of their first triangle.
struct Components {
  std::int32_t count = 0;
  std::vector<std::int32_t> of_triangle;  // (m)
};

/// Connected over shared edges, of any number of faces: two solids that touch in a vertex are two
/// components.
Components connect_over_edges(const TriangleMesh& mesh, const EdgeTable& table);

/// A consistent orientation of each sheet: a maximal set of triangles connected over edges of
/// exactly two faces.
struct Orientation {
  std::int32_t sheets = 0;
  std::vector<std::int32_t> sheet_of_triangle;  // (m)
  // (m) the fewer of each sheet: turn these over to make it consistent
  std::vector<bool> is_flipped;
  std::vector<bool> is_orientable;  // (sheets) false: no such turning exists, as of a Moebius strip
};

Orientation orient_sheets(const TriangleMesh& mesh, const EdgeTable& table);

/// Groups of corners 3 t + k, numbered in their order: two corners at one vertex are of one fan
/// when their faces are linked around it by the given pairs of edge uses, or by every edge when no
/// pairs are given.
struct Fans {
  std::int32_t count = 0;
  std::vector<std::int32_t> of_corner;  // (3 m)
};

using UsePair = std::array<EdgeUse, 2>;

Fans build_fans(const TriangleMesh& mesh, const EdgeTable& table);
Fans build_fans(const TriangleMesh& mesh, std::span<const UsePair> links);

/// Earlier triangle with the same three vertices, -1 for none (m).
std::vector<std::int32_t> find_duplicates(const TriangleMesh& mesh);

/// Which components a point lies inside of: parity of the crossings on a way out of everything,
/// decided exactly.
class InsideTest {
 public:
  /// Keeps references to both. The mesh has a triangle.
  InsideTest(const TriangleMesh& mesh, const Components& components);
  ~InsideTest();

  /// Components but `own` whose triangles are crossed an odd number of times from `point` outwards,
  /// ascending: those a point lies inside of, where they are closed. None when the point lies on
  /// one of their triangles.
  std::optional<std::vector<std::int32_t>> components_around(const Vec3& point,
                                                             std::int32_t own = -1) const;

 private:
  std::optional<std::vector<std::int32_t>> crossed_between(const Vec3& p, const Vec3& q,
                                                           std::int32_t own) const;
  struct Data;
  std::unique_ptr<const Data> data_;
};

}  // namespace thigma
