#pragma once
// Whether a point of the plane lies on a projected triangle.

#include <algorithm>

#include "thigma/depth/projected_patch.h"
#include "thigma/math/plane_cross.h"

namespace thigma::detail {

/// Slack of the test whether a point lies on a triangle, of its barycentric coordinates: less would
/// open cracks between neighbours by rounding; more only extends a triangle's plane by that share.
inline constexpr double kEdgeSlack = 1e-9;

/// How far inside a triangle a point is: the least of its three barycentric coordinates.
inline double insideness(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return std::min({cross(t.edges[0], at - t.at[0]), cross(t.edges[1], at - t.at[1]),
                   cross(t.edges[2], at - t.at[2])});
}

/// Whether a point lies on a triangle. Within its box; beyond, the slack of long edges counts.
inline bool covers(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return insideness(t, at) >= -kEdgeSlack;
}

}  // namespace thigma::detail
