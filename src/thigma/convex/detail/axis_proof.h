#pragma once
// The cached separating axis over any width: one dot product a vertex in single precision. Compiled
// for AVX2 too: as verify_cached_simplices.h, only templates over the width, no function of another
// header.

#include "thigma/convex/gjk.h"

namespace thigma::detail {

/// axis_separates in two widths with the same bits; the second needs a processor with AVX2.
/// r and t are the numbers of the pose, rotation column after column.
bool axis_separates_sse2(const HullView& a, const HullView& b, const double* r, const double* t,
                         const float* axis, double gap) noexcept;
bool axis_separates_avx2(const HullView& a, const HullView& b, const double* r, const double* t,
                         const float* axis, double gap) noexcept;

template <class T>
[[gnu::always_inline]] inline double axis_dot(const double* p, double x, double y, double z) {
  return p[0] * x + p[1] * y + p[2] * z;
}

template <class T>
[[gnu::always_inline]] inline double axis_magnitude(const double* p) {
  return __builtin_fabs(p[0]) + __builtin_fabs(p[1]) + __builtin_fabs(p[2]);
}

/// A height is three products of rounded coordinates with a rounded axis, and two sums: at most 7
/// roundings of 2^-24 of the sum of absolute products, which is at most sqrt(3) |axis| radius.
/// 2^-19 is more than twice that.
inline constexpr double kAxisSlack = 0x1.0p-19;

/// See axis_separates. T::tops(lanes, n, x, y, z) gives the largest height along x y z over the
/// lanes in one of its parts, T::sum_of_largest the sum of the largest parts of two such.
template <class T>
[[gnu::always_inline]] inline bool axis_proves(const HullView& a, const HullView& b,
                                               const double* r, const double* t, const float* axis,
                                               double gap) {
  const double nx = axis[0], ny = axis[1], nz = axis[2];
  const double* ca = reinterpret_cast<const double*>(&a.center);
  const double* cb = reinterpret_cast<const double*>(&b.center);
  const double mx = axis_dot<T>(r, nx, ny, nz), my = axis_dot<T>(r + 3, nx, ny, nz),
               mz = axis_dot<T>(r + 6, nx, ny, nz);
  const auto top_a = T::tops(a.lanes, a.lane_count, axis[0], axis[1], axis[2]);
  const auto top_b = T::tops(b.lanes, b.lane_count, -static_cast<float>(mx),
                             -static_cast<float>(my), -static_cast<float>(mz));
  const double reach = T::sum_of_largest(top_a, top_b);
  const double apart = axis_dot<T>(cb, mx, my, mz) +
                       ((t[0] - ca[0]) * nx + (t[1] - ca[1]) * ny + (t[2] - ca[2]) * nz);
  const double nn = nx * nx + ny * ny + nz * nz;
  const double between = apart - reach;  // |n| times the gap along the axis
  const double far = axis_magnitude<T>(ca) + axis_magnitude<T>(cb) + axis_magnitude<T>(t);
  const double need = gap + kAxisSlack * (a.radius + b.radius) + 0x1.0p-48 * far;
  return (between > 0.0) & (between * between > need * need * nn * (1.0 + 0x1.0p-48));
}

}  // namespace thigma::detail
