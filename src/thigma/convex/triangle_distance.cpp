#include "thigma/convex/triangle_distance.h"

#include <cmath>

#include "thigma/convex/detail/triangle_features.h"

// Triangles intersect when an edge of one pierces the other, or when features touch. Everything
// happens about a corner of the first triangle, so that the distance from the origin of the frame
// costs no digits.

namespace thigma {

TriangleDistance triangle_distance(const Vec3 a[3], const Vec3 b[3]) noexcept {
  const Vec3 origin = a[0];
  const auto ta = detail::place_triangle(Vec3::Zero(), a[1] - origin, a[2] - origin);
  const auto tb = detail::place_triangle(b[0] - origin, b[1] - origin, b[2] - origin);
  TriangleDistance out;
  Vec3 sum = Vec3::Zero();
  const int count = detail::pierce(ta.p, tb, sum) + detail::pierce(tb.p, ta, sum);
  if (count > 0) {
    out.intersecting = true;
    out.point_a = out.point_b = sum / count + origin;
    return out;
  }
  detail::ClosestFeatures best;
  offer_features(ta, tb, best);
  const double noise = detail::touch_distance(ta, tb);
  out.intersecting = best.squared <= noise * noise;
  out.point_a = best.a + origin;
  out.point_b = best.b + origin;
  out.distance = out.intersecting ? 0.0 : std::sqrt(best.squared);
  return out;
}

}  // namespace thigma
