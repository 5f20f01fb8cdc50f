#pragma once
// Triangles that a mesh has more than once: what they are copies of, and which are fins.

#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// The triangles of a mesh, each set of three vertices once, in the order of the first of each (n).
struct DistinctFaces {
  std::vector<std::int32_t> triangle;  // the first with those vertices, ascending (n)
  std::vector<std::int32_t> copies;    // triangles with those vertices, itself included (n)
  std::vector<std::int32_t> net;       // of them, those that turn as the first less the others (n)
};

/// Thread [offline]; deterministic. Indices in range.
DistinctFaces list_distinct_faces(const TriangleMesh& mesh);

/// Which of the distinct faces are fins (n): faces back to back (net 0) on the edges of a surface
/// that goes on without them.
///
/// Faces of net 0 that meet in twos form a sheet, and it goes or stays as a whole. It goes when at
/// each of its edges the surface that is there for certain has an even number of faces, and at one
/// of them at least has any. There for certain are faces of another net, sheets that go on through
/// each of their edges, and sheets without which one of the former would end. So a region of which
/// every face has its reverse stays, a flap on it goes, and so does a wall between two solids.
/// Where nothing is certain, nothing goes.
/// Thread [offline]; deterministic.
std::vector<bool> find_fins(const TriangleMesh& mesh, const DistinctFaces& faces);

}  // namespace thigma
