#include "thigma/constraint/detail/feature_distance.h"

#include "support/triangle_search.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

TEST(FeatureDistance, AgreesWithThePlainOne) {
  Random random(1);
  const auto point = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  for (int trial = 0; trial < 5000; ++trial) {
    const test::Triangle t{point(), point(), point()};
    const Vec3 p = 2.0 * point();
    double expected = test::point_inside_triangle(p, t);
    for (std::size_t i = 0; i < 3; ++i)
      expected = std::min(expected, test::point_segment(p, t[i], t[(i + 1) % 3]));
    EXPECT_NEAR((p - detail::nearest_on_triangle(p, t[0], t[1], t[2])).norm(), expected, 1e-12);
    const Vec3 a = point(), b = point(), c = point(), d = point();
    const detail::NearestOnSegments s = detail::nearest_on_segments(a, b - a, c, d - c);
    EXPECT_NEAR((a + s.first * (b - a) - c - s.second * (d - c)).norm(),
                test::segment_segment(a, b, c, d), 1e-12);
  }
}

TEST(FeatureDistance, OfLinesGoesSquareToBoth) {
  Random random(2);
  const auto point = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  int beyond = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Vec3 a = point(), along = point(), c = point(), across = point();
    if (along.cross(across).norm() < 0.1) continue;
    const detail::NearestOnSegments s = detail::nearest_on_lines(a, along, c, across);
    const Vec3 way = a + s.first * along - c - s.second * across;
    EXPECT_NEAR(way.dot(along), 0.0, 1e-9);
    EXPECT_NEAR(way.dot(across), 0.0, 1e-9);
    beyond += s.first < 0.0 || s.first > 1.0;
  }
  EXPECT_GT(beyond, 100);
}

}  // namespace
}  // namespace thigma
