#include "benchmarks/point_cells.h"

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma::bench {
namespace {

TEST(PointCells, FindAPointWithinReachAsBruteForceDoes) {
  Random random(2);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back(random.in_cube(1.0));
  const double reach = 0.2;
  const PointCells cells = sort_into_cells(points, reach);
  int near = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random.in_cube(1.3);
    bool expected = false;
    for (const Vec3& q : points) expected = expected || (p - q).norm() <= reach;
    EXPECT_EQ(has_point_within(cells, p), expected);
    near += expected ? 1 : 0;
  }
  EXPECT_GT(near, 100);
  EXPECT_LT(near, 500);
}

TEST(PointCells, RegionsAreWhatHangsTogether) {
  Random random(4);
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) points.push_back(Vec3(5.0, 0.0, 0.0) + random.in_cube(0.3));
  for (int i = 0; i < 60; ++i) points.push_back(Vec3(-5.0 + 0.1 * i, 2.0, 0.0));  // a chain
  points.push_back(Vec3(0.0, -7.0, 0.0));
  int count = 0;
  const std::vector<int> region = regions_of(points, 0.15, count);
  EXPECT_EQ(count, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(region[i], region[i < 200 ? 0 : i < 260 ? 200 : 260]);
  }
  EXPECT_NE(region[0], region[200]);
  EXPECT_NE(region[200], region[260]);
}

TEST(PointCells, NoPointsAreNoRegions) {
  int count = -1;
  EXPECT_TRUE(regions_of({}, 1.0, count).empty());
  EXPECT_EQ(count, 0);
  EXPECT_FALSE(has_point_within(sort_into_cells({}, 1.0), Vec3::Zero()));
}

}  // namespace
}  // namespace thigma::bench
