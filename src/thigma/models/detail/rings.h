#pragma once
// Closed surfaces from rings of vertices: the construction all models here share.

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

/// Vertices first .. first + count - 1 of a mesh, in a loop.
struct Ring {
  std::int32_t first = 0;
  int count = 0;
};

Ring add_ring(TriangleMesh& mesh, std::span<const Vec3> points);

/// Band between two rings of the same count; its normal is (along the ring) x (from low to high).
/// is_mirrored(j): take the other diagonal in the quadrilateral between vertices j and j + 1.
void join_rings(
    TriangleMesh& mesh, const Ring& low, const Ring& high,
    const std::function<bool(int)>& is_mirrored = [](int) { return false; });

/// Disc within a flat ring that is star-shaped about `centre`: similar rings of half the vertices
/// each, so that triangles keep their shape and none crosses another. Its normal is that of the
/// ring's turning sense, or the opposite when is_reversed.
void close_ring(TriangleMesh& mesh, const Ring& ring, const Vec3& centre, bool is_reversed);

/// Triangles close_ring adds to a ring of this count.
int disc_triangles(int count);

/// Two counts whose product makes a triangle count.
struct GridCounts {
  int around = 0;
  int along = 0;
};

/// Counts whose triangle count is nearest to the one asked for, not far from the wished shape.
///
/// wished_ratio  along / around
/// around_step   around is a multiple of it, and at least around_least
/// total         triangles of (around, along); grows with both
GridCounts nearest_counts(int triangles, double wished_ratio, int around_step, int around_least,
                          const std::function<long long(int, int)>& total);

}  // namespace thigma::models
