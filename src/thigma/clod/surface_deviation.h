#pragma once
// How far a triangle lies from a surface, at most (Sec. 3.3.5, parameter s).

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma {

/// A surface to measure distances to. Keeps a pointer to the mesh.
struct DeviationTarget {
  const TriangleMesh* mesh = nullptr;
  TriangleTree tree;
};

DeviationTarget build_deviation_target(const TriangleMesh& mesh);

/// Distance from p to the surface, and the triangle it is nearest to; `nearest` is a first guess.
double nearest_distance(const DeviationTarget& target, const Vec3& p, std::int32_t& nearest);

/// What is known of the largest distance of several triangles from a surface: met <= that distance
/// <= bound [m].
struct DeviationRange {
  double met = 0.0;    // of some point
  double bound = 0.0;  // of all points
};

/// Extends the range by a triangle.
///
/// Where the surface lies over the triangle in one sheet, it is cut along the triangle's prism, and
/// the distance along the normal, linear on every piece, has its largest value at a corner of a
/// piece. Elsewhere, and where that distance is slanted, the triangle is divided until every part
/// is bounded to a tenth above `met`: by that distance, by the distance of its corners to one
/// triangle of the surface, a convex function, or by the distance of its middle and its size; at
/// most 4^6 parts.
///
/// reach    about the largest deviation to expect [m]: sheets farther along the normal are not
///          looked at; larger deviations are found too, slower
/// range    of the triangles before; one found to stay below its bound is not measured
/// nearest  a triangle of the surface to try that with, replaced by one over this triangle
/// Thread   [offline]; no failure.
void extend_deviation(const DeviationTarget& target, const std::array<Vec3, 3>& triangle,
                      double reach, DeviationRange& range, std::int32_t& nearest);

}  // namespace thigma
