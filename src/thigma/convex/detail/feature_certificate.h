#pragma once
// A cheap proof that no vertex but those of a feature supports a hull along a direction.

#include <cmath>

#include <emmintrin.h>

#include "thigma/convex/hull_view.h"

namespace thigma::detail {

/// True when every vertex of the hull outside `feature` lies below the vertices of the feature
/// along `direction` by more than single precision can err. False means "not proven": near ties, no
/// lanes, numbers out of float's range.
///
/// feature  mask of hull vertices; `vertex` is one of them
inline bool feature_supports(const HullView& hull, std::uint32_t feature, int vertex,
                             const Vec3& direction) noexcept {
  if (hull.lanes == nullptr) return false;
  const int n = hull.lane_count;
  const float *x = hull.lanes, *y = x + n, *z = y + n;
  const auto dx = static_cast<float>(direction.x()), dy = static_cast<float>(direction.y()),
             dz = static_cast<float>(direction.z());
  // Two heights err by at most 2^-20 |d| radius each (see separating_axis.cpp), |d| <= the sum of
  // its parts.
  const float slack = 0x1.0p-18f * static_cast<float>(hull.radius) *
                      (std::fabs(dx) + std::fabs(dy) + std::fabs(dz));
  if (!(slack > 1e-30f && slack < 1e30f)) return false;
  const __m128 ax = _mm_set1_ps(dx), ay = _mm_set1_ps(dy), az = _mm_set1_ps(dz);
  const __m128 limit = _mm_set1_ps(x[vertex] * dx + y[vertex] * dy + z[vertex] * dz - slack);
  const auto above = [&](int i) {  // mask of the four vertices from i on that are not clearly lower
    const __m128 h = _mm_add_ps(
        _mm_add_ps(_mm_mul_ps(_mm_load_ps(x + i), ax), _mm_mul_ps(_mm_load_ps(y + i), ay)),
        _mm_mul_ps(_mm_load_ps(z + i), az));
    return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmpge_ps(h, limit)));
  };
  std::uint32_t rivals = 0;
  for (int i = 0; i < n; i += 8) rivals |= (above(i) | above(i + 4) << 4) << i;
  // The padding repeats the last vertex.
  const std::uint32_t present = 0xffffffffu >> (kMaxHullVertices - hull.vertex_count);
  return (rivals & present & ~feature) == 0;
}

}  // namespace thigma::detail
