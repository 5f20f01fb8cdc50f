#pragma once
// The nearest point to the origin of a simplex of up to four points, and the part of the simplex that holds it.

#include <cstdint>

#include "thigma/math/types.h"

namespace thigma::detail {

/// Points of a Minkowski difference with the vertices they come from, and the weights of the nearest point.
struct Simplex {
  Vec3 w[5];  // one more than is ever kept: the candidate
  double weight[4] = {1.0, 0.0, 0.0, 0.0};
  std::uint8_t a[5], b[5];
  int n = 0;
};

/// Nearest point of the simplex to the origin. Drops the points that do not carry it and sets the weights.
/// n stays 4 only when the origin is inside; then the result is zero. Degenerate simplices are fine.
Vec3 reduce_to_nearest(Simplex& s) noexcept;

/// Nearest point of triangle p[0..2] to the origin; mask says which corners carry it, weight their shares.
Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, int& mask, double weight[3]) noexcept;

/// Nearest point of the segment a b to the origin.
inline Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, int& mask, double weight[2]) noexcept {
  const Vec3 ab = b - a;
  const double t = -a.dot(ab), d = ab.squaredNorm();
  weight[0] = 1.0;
  weight[1] = 0.0;
  mask = 1;
  if (!(t > 0.0)) return a;
  mask = 2;
  weight[0] = 0.0;
  weight[1] = 1.0;
  if (t >= d) return b;
  mask = 3;
  weight[1] = t / d;
  weight[0] = 1.0 - weight[1];
  return a + weight[1] * ab;
}

}  // namespace thigma::detail
