#pragma once
// Nearest points of the features that touch: point and triangle, segment and segment.

#include <algorithm>

#include "thigma/math/types.h"

namespace thigma::detail {

/// Nearest point of a triangle.
inline Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b,
                                const Vec3& c) noexcept {
  // Ericson, Real-Time Collision Detection, 5.1.5: the Voronoi region of p decides.
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  const double scale = 1.0 / (va + vb + vc);
  return a + vb * scale * ab + vc * scale * ac;
}

/// Nearest points of two segments, as shares 0..1 along each.
struct NearestOnSegments {
  double first = 0.0, second = 0.0;
};

inline NearestOnSegments nearest_on_segments(const Vec3& p, const Vec3& d, const Vec3& q,
                                             const Vec3& e) noexcept {
  const Vec3 r = p - q;
  const double a = d.squaredNorm(), b = d.dot(e), c = e.squaredNorm();
  const double f = d.dot(r), g = e.dot(r);
  const double determinant = a * c - b * b;
  double s = determinant > 0.0 ? std::clamp((b * g - c * f) / determinant, 0.0, 1.0) : 0.0;
  double t = (b * s + g) / c;
  if (t < 0.0) {
    t = 0.0;
    s = std::clamp(-f / a, 0.0, 1.0);
  } else if (t > 1.0) {
    t = 1.0;
    s = std::clamp((b - f) / a, 0.0, 1.0);
  }
  return {s, t};
}

/// Nearest points of the two segments' lines, as shares that may lie beyond 0..1; not finite where
/// they are parallel.
inline NearestOnSegments nearest_on_lines(const Vec3& p, const Vec3& d, const Vec3& q,
                                          const Vec3& e) noexcept {
  const Vec3 r = p - q;
  const double a = d.squaredNorm(), b = d.dot(e), c = e.squaredNorm();
  const double f = d.dot(r), g = e.dot(r);
  const double s = (b * g - c * f) / (a * c - b * b);
  return {s, (b * s + g) / c};
}

}  // namespace thigma::detail
