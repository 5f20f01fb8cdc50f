#pragma once
// The nearest point to the origin of a simplex of up to four points, and the part of the simplex
// that holds it.

#include <cstdint>

#include "thigma/math/types.h"

namespace thigma::detail {

/// Points of a Minkowski difference with the vertices they come from, and the weights of the
/// nearest point.
struct Simplex {
  // One more than is ever kept: the candidate.
  Vec3 w[5] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double weight[4] = {1.0, 0.0, 0.0, 0.0};
  std::uint8_t a[5] = {0, 0, 0, 0, 0}, b[5] = {0, 0, 0, 0, 0};
  int n = 0;
};

/// Nearest point of the simplex to the origin. Drops the points that do not carry it and sets the
/// weights. n stays 4 only when the origin is inside; then the result is zero. Degenerate simplices
/// are fine.
Vec3 reduce_to_nearest(Simplex& s) noexcept;

/// Nearest point to the origin of a triangle with no area left: of its edges.
Vec3 nearest_on_edges(const Vec3& a, const Vec3& b, const Vec3& c, int& mask,
                      double weight[3]) noexcept;

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

/// Nearest point of a triangle to the origin; mask says which corners carry it, weight their
/// shares.
inline Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, int& mask,
                                double weight[3]) noexcept {
  const Vec3 ab = b - a, ac = c - a;
  weight[0] = weight[1] = weight[2] = 0.0;
  const double d1 = -ab.dot(a), d2 = -ac.dot(a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    weight[0] = 1.0;
    mask = 1;
    return a;
  }
  const double d3 = -ab.dot(b), d4 = -ac.dot(b);
  if (d3 >= 0.0 && d4 <= d3) {
    weight[1] = 1.0;
    mask = 2;
    return b;
  }
  const double d5 = -ab.dot(c), d6 = -ac.dot(c);
  if (d6 >= 0.0 && d5 <= d6) {
    weight[2] = 1.0;
    mask = 4;
    return c;
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3) {
    weight[1] = d1 / (d1 - d3);
    weight[0] = 1.0 - weight[1];
    mask = 3;
    return a + weight[1] * ab;
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6) {
    weight[2] = d2 / (d2 - d6);
    weight[0] = 1.0 - weight[2];
    mask = 5;
    return a + weight[2] * ac;
  }
  const double va = d3 * d6 - d5 * d4, e = d4 - d3, f = d5 - d6;
  if (va <= 0.0 && e >= 0.0 && f >= 0.0 && e + f > 0.0) {
    weight[2] = e / (e + f);
    weight[1] = 1.0 - weight[2];
    mask = 6;
    return b + weight[2] * (c - b);
  }
  const Vec3 n = ab.cross(ac);
  const double nn = n.squaredNorm(), sum = va + vb + vc;
  // 1e-28: an area below 1e-14 of the edges' is rounding.
  if (!(nn > 1e-28 * ab.squaredNorm() * ac.squaredNorm()) || !(sum > 0.0))
    return nearest_on_edges(a, b, c, mask, weight);
  weight[1] = vb / sum;
  weight[2] = vc / sum;
  weight[0] = 1.0 - weight[1] - weight[2];
  mask = 7;
  return n * (a.dot(n) / nn);
}

}  // namespace thigma::detail
