#include "thigma/simplify/quadric.h"

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

TEST(Quadric, SumsSquaredDistances) {
  Random random(5);
  Quadric q;
  std::vector<Vec3> normals, points;
  for (int i = 0; i < 10; ++i) {
    normals.push_back(random.direction());
    points.push_back(random.in_cube(2.0));
    q += plane_quadric(normals.back(), points.back(), 1.0 + i);
  }
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 p = random.in_cube(2.0);
    double expected = 0.0;
    for (std::size_t i = 0; i < 10; ++i) {
      const double height = normals[i].dot(p - points[i]);
      expected += (1.0 + static_cast<double>(i)) * height * height;
    }
    EXPECT_NEAR(evaluate(q, p), expected, 1e-11 * expected);
  }
}

TEST(Quadric, IsLeastWhereThePlanesMeet) {
  Quadric corner;
  const Vec3 meeting(0.1, -0.2, 0.3), near(0.2, -0.1, 0.2);
  for (int i = 0; i < 3; ++i) corner += plane_quadric(Vec3::Unit(i), meeting, 1.0);
  EXPECT_LT((minimize(corner, near) - meeting).norm(), 1e-3 * (near - meeting).norm());
}

TEST(Quadric, StaysNearWhereNothingDecides) {
  const Vec3 near(4, 5, 6);
  EXPECT_EQ(minimize(Quadric(), near), near);
  // One plane: straight down to it. Two: to their line.
  const Quadric plane = plane_quadric(Vec3::UnitZ(), Vec3::Zero(), 2.0);
  EXPECT_LT((minimize(plane, near) - Vec3(4, 5, 0)).norm(), 1e-3);
  Quadric edge = plane;
  edge += plane_quadric(Vec3::UnitX(), Vec3::Zero(), 2.0);
  EXPECT_LT((minimize(edge, near) - Vec3(0, 5, 0)).norm(), 2e-3);
}

}  // namespace
}  // namespace thigma
