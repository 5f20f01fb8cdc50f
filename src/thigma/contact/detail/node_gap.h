#pragma once
// Lower bounds of the distance of two hierarchy nodes, cheapest first.

#include <cmath>

#include <emmintrin.h>

#include "thigma/contact/front.h"
#include "thigma/convex/support.h"

namespace thigma::detail {

// Single-precision rounding of one support value over the lanes, times the bounding radius: three
// products and sums of numbers below it, each off by 2^-24, on rounded coordinates and a rounded
// axis. Twice that, generously.
inline constexpr double kLaneRounding = 2e-6;
// Rounding of centres brought into one frame, times the magnitude of the coordinates.
inline constexpr double kPlacementRounding = 1e-14;

/// Places of two nodes against each other, shared by all tests of the pair.
struct PlacedHulls {
  const HullView &a, &b;       // outlive it
  Vec3 offset = Vec3::Zero();  // from the centre of a to that of b [m; frame of a]
  double rounding = 0.0;       // of offset and everything measured along it [m]
};

inline PlacedHulls place(const HullView& a, const HullView& b, const RelativePose& pose) noexcept {
  PlacedHulls hulls{a, b, pose.rotation * b.center + pose.translation - a.center, 0.0};
  hulls.rounding = kPlacementRounding * (a.center.lpNorm<1>() + b.center.lpNorm<1>() +
                                         pose.translation.lpNorm<1>() + a.radius + b.radius);
  return hulls;
}

PlacedHulls place(const HullView&&, const HullView&&, const RelativePose&) = delete;
PlacedHulls place(const HullView&, const HullView&&, const RelativePose&) = delete;
PlacedHulls place(const HullView&&, const HullView&, const RelativePose&) = delete;

inline double sphere_gap(const PlacedHulls& hulls) noexcept {
  return std::sqrt(hulls.offset.squaredNorm()) - hulls.a.radius - hulls.b.radius - hulls.rounding;
}

/// Largest value of axis . v over the lanes of a hull, v relative to its centre.
inline float lane_support(const HullView& hull, float x, float y, float z) noexcept {
  const __m128 ax = _mm_set1_ps(x), ay = _mm_set1_ps(y), az = _mm_set1_ps(z);
  const float* vx = hull.lanes;
  const float* vy = vx + hull.lane_count;
  const float* vz = vy + hull.lane_count;
  auto value = [&](int i) {
    return _mm_add_ps(
        _mm_add_ps(_mm_mul_ps(ax, _mm_load_ps(vx + i)), _mm_mul_ps(ay, _mm_load_ps(vy + i))),
        _mm_mul_ps(az, _mm_load_ps(vz + i)));
  };
  __m128 best = value(0);
  for (int i = 4; i < hull.lane_count; i += 4) best = _mm_max_ps(best, value(i));
  best = _mm_max_ps(best, _mm_movehl_ps(best, best));
  best = _mm_max_ss(best, _mm_shuffle_ps(best, best, 1));
  return _mm_cvtss_f32(best);
}

/// Gap along an axis (unit to single precision, from a to b; frame of a): a lower bound of the
/// distance.
inline double axis_gap(const PlacedHulls& hulls, const RelativePose& pose,
                       const float axis[3]) noexcept {
  const Vec3 n(axis[0], axis[1], axis[2]);
  const Vec3 in_b = pose.rotation.transpose() * n;
  const float top = lane_support(hulls.a, axis[0], axis[1], axis[2]);
  const float bottom = lane_support(hulls.b, static_cast<float>(-in_b.x()),
                                    static_cast<float>(-in_b.y()), static_cast<float>(-in_b.z()));
  const double gap = n.dot(hulls.offset) - static_cast<double>(top) - static_cast<double>(bottom);
  // The axis is a unit vector only to 1e-7: shorter makes the gap smaller, longer is made up for.
  return gap - 1e-6 * std::fabs(gap) - kLaneRounding * (hulls.a.radius + hulls.b.radius) -
         hulls.rounding;
}

/// Lets a search start where an axis from a to b (frame of a), such as that of the parents, says.
inline void start_along(const PlacedHulls& hulls, const RelativePose& pose, const float axis[3],
                        GjkCache& cache) noexcept {
  const Vec3 n(axis[0], axis[1], axis[2]);
  if (!(n.squaredNorm() > 0.0)) return;
  cache.a[0] = static_cast<std::uint8_t>(support_vertex(hulls.a, n));
  cache.b[0] = static_cast<std::uint8_t>(support_vertex(hulls.b, -(pose.rotation.transpose() * n)));
  cache.count = 1;
}

}  // namespace thigma::detail
