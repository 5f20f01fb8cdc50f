#pragma once
// How far a triangle lies from a surface, at most (Sec. 3.3.5, parameter s).

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/mesh/detail/triangle_tree.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// A surface to measure distances to. Keeps a pointer to the mesh.
struct DeviationTarget {
  const TriangleMesh* mesh = nullptr;
  detail::TriangleTree tree;
};

DeviationTarget build_deviation_target(const TriangleMesh& mesh);

/// Distance from p to the surface, and the triangle it is nearest to; `nearest` is a first guess.
double nearest_distance(const DeviationTarget& target, const Vec3& p, std::int32_t& nearest);

/// An upper bound of the distance to the surface over all points of a triangle.
///
/// Where the surface lies over the triangle in one sheet, it is cut along the triangle's prism, and
/// the distance along the normal, linear on every piece, has its largest value at a corner of a
/// piece. Elsewhere, and where that distance is slanted, the triangle is divided until one of the
/// two bounds its parts to a quarter: that, or the distance of the corners to one triangle of the
/// surface, a convex function; at most 256 parts.
///
/// reach    about the largest deviation to expect [m]: sheets farther along the normal are not
///          looked at; larger deviations are found too, slower
/// known    a bound that holds already: a triangle found to stay below it is not measured, and the
///          answer is then `known`
/// nearest  a triangle of the surface to try that with, replaced by one over this triangle
/// Thread   [offline]; no failure.
double bound_deviation(const DeviationTarget& target, const std::array<Vec3, 3>& triangle,
                       double reach, double known, std::int32_t& nearest);

}  // namespace thigma
