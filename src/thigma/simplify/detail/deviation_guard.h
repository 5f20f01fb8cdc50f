#pragma once
// Is the surface still near the original, and the original near it?

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma::detail {

/// How far new triangles may lie from the original, by the length of the edge they came of.
struct DeviationLimit {
  double least = 0.0;  // whatever the length [m]
  double share = 0.0;  // of the length, where that is more,
  double most = 0.0;   // up to this [m]
  double of(double length) const noexcept {
    return std::max(least, std::min(share * length, most));
  }
};

/// The original surface, for each vertex of the simplified one a triangle near it, and for each
/// triangle of the simplified one the vertices of the original that it stands for.
struct DeviationGuard {
  const TriangleMesh* original = nullptr;
  TriangleTree tree;
  std::vector<std::int32_t> near;          // triangle of the original, of each vertex
  std::vector<std::int32_t> first_sample;  // vertex of the original, of each triangle; -1 none
  std::vector<std::int32_t> next_sample;   // of each vertex of the original, in its triangle's list
};

/// How near, and working memory: each thread has its own.
struct DeviationSearch {
  double limit = 0.0;  // [m]
  std::vector<std::int32_t> stack;
};

/// Between samples of a triangle, times the limit.
inline constexpr double kSampleSpacing = 1.5;

/// Keeps a pointer to the mesh; every vertex starts near one of its own triangles, which stands for
/// it.
DeviationGuard build_deviation_guard(const TriangleMesh& original);

/// Whether all of a triangle lies within the limit of the original, by samples no farther apart
/// than kSampleSpacing times the limit: between them the deviation can grow by at most half of
/// that.
///
/// corners        of the triangle; the first is taken to have been tested [m]
/// near           three vertices whose nearest triangles of the original are looked at first
/// divisions      of the edges, from count_divisions
/// has_last_edge  whether to test the edge between the last corner and the first: another triangle
///                with as many divisions may have
bool is_within_limit(const DeviationGuard& guard, DeviationSearch& search,
                     const std::array<Vec3, 3>& corners, const std::array<std::int32_t, 3>& near,
                     int divisions, bool has_last_edge = true);

/// Into how many parts samples divide the edges of a triangle.
int count_divisions(double limit, const std::array<Vec3, 3>& corners);

/// A triangle of the original within the limit of p, -1 for none. Looks first at the triangles
/// near the given vertices.
std::int32_t find_within_limit(const DeviationGuard& guard, DeviationSearch& search, const Vec3& p,
                               const std::array<std::int32_t, 3>& vertices);

}  // namespace thigma::detail
