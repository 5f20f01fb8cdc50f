#include "thigma/simplify/resolution.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

TEST(EdgeResolution, IsTheInverseOfTheProjectedLength) {
  EXPECT_DOUBLE_EQ(edge_resolution({0, 0, 0}, {3, 4, 7}, {0, 0, 2}), 0.2);
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = random.in_cube(1.0), b = random.in_cube(1.0), n = random.direction();
    // The sine of the angle with n, another way.
    EXPECT_NEAR(edge_resolution(a, b, 5.0 * n) * (b - a).cross(n).norm(), 1.0, 1e-12);
    EXPECT_EQ(edge_resolution(a, b, n), edge_resolution(b, a, n));
  }
}

TEST(EdgeResolution, IsInfiniteAlongTheNormalAndPlainWithoutOne) {
  const Vec3 n(1, 2, 3);
  EXPECT_EQ(edge_resolution(Vec3::Zero(), 2.0 * n, n), std::numeric_limits<double>::infinity());
  EXPECT_EQ(edge_resolution(n, n, n), std::numeric_limits<double>::infinity());
  EXPECT_DOUBLE_EQ(projected_length({3, 4, 0}, Vec3::Zero()), 5.0);
}

}  // namespace
}  // namespace thigma
