#include "thigma/convex/triangle_distance.h"

#include <cmath>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

#include "thigma/math/infinity.h"

namespace thigma {
namespace {

// Nearest point of triangle t to p: alternating projections need no case distinction (Dykstra), but
// converge slowly; a golden-section search over one barycentric coordinate of an exact
// point-segment distance does it here.
double segment_distance(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double d = (b - a).squaredNorm();
  const double t = d > 0.0 ? std::clamp((p - a).dot(b - a) / d, 0.0, 1.0) : 0.0;
  return (a + t * (b - a) - p).norm();
}

// Convex minimum of f over [0, 1].
template <class F>
double minimum(F f) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 45; ++i) {
    const double u = low + 0.381966 * (high - low), v = high - 0.381966 * (high - low);
    if (f(u) <= f(v))
      high = v;
    else
      low = u;
  }
  return f(0.5 * (low + high));
}

double point_triangle(const Vec3& p, const Vec3 t[3]) {
  return minimum([&](double s) {
    return segment_distance(p, t[0] + s * (t[1] - t[0]), t[0] + s * (t[2] - t[0]));
  });
}

// Distance is convex in the point of a: nested searches over its two coordinates.
double searched_distance(const Vec3 a[3], const Vec3 b[3]) {
  return minimum([&](double s) {
    return minimum([&](double t) {
      const Vec3 p = a[0] + s * (a[1] - a[0]), q = a[0] + s * (a[2] - a[0]);
      return point_triangle(p + t * (q - p), b);
    });
  });
}

TEST(TriangleDistance, EqualsAnIndependentSearch) {
  Random random(1);
  int intersecting = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Vec3 a[3], b[3];
    const Vec3 shift = random.in_cube(trial % 2 == 0 ? 0.2 : 1.2);
    for (int i = 0; i < 3; ++i) a[i] = random.in_cube(1.0), b[i] = random.in_cube(1.0) + shift;
    if (trial % 5 == 1) a[2] = a[1];                     // a segment
    if (trial % 5 == 2) b[2] = b[1] = b[0];              // a point
    if (trial % 5 == 3) a[2] = 0.3 * a[0] + 0.7 * a[1];  // a segment with three corners
    const TriangleDistance d = triangle_distance(a, b);
    EXPECT_NEAR(d.distance, searched_distance(a, b), 1e-6) << trial;
    EXPECT_NEAR((d.point_a - d.point_b).norm(), d.distance, 1e-14);
    intersecting += d.intersecting;
  }
  EXPECT_GT(intersecting, 3);
}

TEST(TriangleDistance, KnowsTheClassicalCases) {
  const Vec3 flat[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Vec3 above[3] = {{0.2, 0.2, 0.5}, {1.2, 0.2, 0.7}, {0.2, 1.2, 0.9}};
  EXPECT_DOUBLE_EQ(triangle_distance(flat, above).distance, 0.5);  // corner over face
  const Vec3 crossing[3] = {{0.5, -1, 1}, {0.5, 2, 1}, {0.5, 0, 3}};
  EXPECT_DOUBLE_EQ(triangle_distance(flat, crossing).distance, 1.0);
  const Vec3 parallel[3] = {{0.1, 0.1, 1e-12}, {0.5, 0.1, 1e-12}, {0.1, 0.5, 1e-12}};
  EXPECT_NEAR(triangle_distance(flat, parallel).distance, 1e-12, 1e-24);  // contained footprint
  const Vec3 piercing[3] = {{0.2, 0.2, -1}, {0.2, 0.2, 1}, {0.3, 0.2, 1}};
  EXPECT_TRUE(triangle_distance(flat, piercing).intersecting);
  EXPECT_EQ(triangle_distance(flat, piercing).distance, 0.0);
  EXPECT_TRUE(triangle_distance(flat, flat).intersecting);  // coplanar, equal
  const Vec3 corner[3] = {{1, 0, 0}, {2, 0, 1}, {2, 0, -1}};
  EXPECT_TRUE(triangle_distance(flat, corner).intersecting);  // one common corner
  const Vec3 beside[3] = {{2, 0, 0}, {3, 0, 0}, {2, 1, 0}};
  EXPECT_DOUBLE_EQ(triangle_distance(flat, beside).distance, 1.0);  // coplanar, apart
}

TEST(TriangleDistance, LosesNothingFarFromTheOriginOrAtOtherScales) {
  Random random(2);
  for (int trial = 0; trial < 300; ++trial) {
    Vec3 a[3], b[3], sa[3], sb[3];
    const Vec3 shift = random.in_cube(1.5);
    // Coordinates of 24 bits: moving by 2^20 and scaling by powers of two round nothing.
    const auto round24 = [](const Vec3& p) {
      return Vec3((p * 0x1.0p20).array().round() * 0x1.0p-20);
    };
    for (int i = 0; i < 3; ++i)
      a[i] = round24(random.in_cube(1.0)), b[i] = round24(random.in_cube(1.0) + shift);
    const double d = triangle_distance(a, b).distance;
    for (int i = 0; i < 3; ++i)
      sa[i] = a[i] + Vec3(0x1.0p20, 0, 0), sb[i] = b[i] + Vec3(0x1.0p20, 0, 0);
    EXPECT_EQ(triangle_distance(sa, sb).distance, d);
    for (const double scale : {0x1.0p-30, 0x1.0p30}) {
      for (int i = 0; i < 3; ++i) sa[i] = a[i] * scale, sb[i] = b[i] * scale;
      EXPECT_EQ(triangle_distance(sa, sb).distance, d * scale);
    }
  }
}

}  // namespace
}  // namespace thigma
