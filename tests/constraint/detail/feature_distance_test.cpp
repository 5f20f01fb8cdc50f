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

}  // namespace
}  // namespace thigma
