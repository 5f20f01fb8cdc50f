#pragma once
// The vertices of a hull that may be farthest along a direction, sorted out in single precision.

#include <bit>
#include <cmath>
#include <cstdint>

#include "thigma/convex/detail/lanes_sse2.h"
#include "thigma/convex/hull_view.h"
#include "thigma/convex/support.h"

namespace thigma::detail {

/// Mask of the vertices that are not lower than `vertex` along `direction` by more than single
/// precision can err: a vertex with the largest height is among them. All vertices where single
/// precision says nothing: no lanes, numbers out of float's range.
inline std::uint32_t support_candidates(const HullView& hull, int vertex,
                                        const Vec3& direction) noexcept {
  // The padding of the lanes repeats the last vertex.
  const std::uint32_t present = 0xffffffffu >> (kMaxHullVertices - hull.vertex_count);
  if (hull.lanes == nullptr) return present;
  const int n = hull.lane_count;
  const float *x = hull.lanes, *y = x + n, *z = y + n;
  const auto dx = static_cast<float>(direction.x()), dy = static_cast<float>(direction.y()),
             dz = static_cast<float>(direction.z());
  // Two heights err by at most 2^-20 |d| radius each (see separating_axis.cpp), |d| <= the sum of
  // its parts.
  const float slack = 0x1.0p-18f * static_cast<float>(hull.radius) *
                      (std::fabs(dx) + std::fabs(dy) + std::fabs(dz));
  if (!(slack > 1e-30f && slack < 1e30f)) return present;
  const float limit = x[vertex] * dx + y[vertex] * dy + z[vertex] * dz - slack;
  return Sse2Heights::not_lower(x, n, dx, dy, dz, limit) & present;
}

/// Index of a vertex of `among` (not empty) with the largest direction . p.
inline int support_vertex_among(const HullView& hull, std::uint32_t among,
                                const Vec3& direction) noexcept {
  std::uint32_t many = among;
  for (int few = 6; few > 0; --few) many &= many - 1;
  // From there on all vertices two at a time are as fast.
  if (many != 0) return support_vertex(hull, direction);
  int best = std::countr_zero(among);
  double most = direction.dot(hull.vertices[best]);
  for (among &= among - 1; among != 0; among &= among - 1) {
    const int i = std::countr_zero(among);
    const double height = direction.dot(hull.vertices[i]);
    best = height > most ? i : best;
    most = height > most ? height : most;
  }
  return best;
}

}  // namespace thigma::detail
