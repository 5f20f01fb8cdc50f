#include "thigma/convex/clip.h"

#include <gtest/gtest.h>

#include "thigma/convex/quickhull.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

std::vector<HalfSpace> unit_cube() {
  std::vector<HalfSpace> half_spaces;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      half_spaces.push_back({sign * Vec3::Unit(axis), sign > 0 ? 1.0 : 0.0});
  return half_spaces;
}

TEST(ReachesInto, SeesWhatSamplesOfCornersMiss) {
  const auto cube = unit_cube();
  // No corner inside: a large triangle through the middle, and an edge through a corner region.
  EXPECT_TRUE(reaches_into({Vec3(-9, -9, 0.5), Vec3(9, -9, 0.5), Vec3(0, 18, 0.5)}, cube));
  EXPECT_TRUE(reaches_into({Vec3(-0.1, 0.2, 0.5), Vec3(0.2, -0.1, 0.5), Vec3(-1, -1, 0.5)}, cube));
  // Beside it, though no single plane has all three corners beyond it.
  EXPECT_FALSE(reaches_into({Vec3(-0.2, 0.1, 0.5), Vec3(0.1, -0.2, 0.5), Vec3(-1, -1, 0.5)}, cube));
}

TEST(ReachesInto, AgreesWithPointsOfTheTriangle) {
  Random random(11);
  const auto cube = unit_cube();
  int reaching = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<Vec3, 3> t;
    for (Vec3& p : t) p = Vec3::Constant(0.5) + random.in_cube(1.5);
    bool has_point = false;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; i + j <= 60; ++j) {
        const Vec3 p = (i * t[0] + j * t[1] + (60 - i - j) * t[2]) / 60.0;
        has_point = has_point || ((p.array() >= 0).all() && (p.array() <= 1).all());
      }
    if (has_point) {
      EXPECT_TRUE(reaches_into(t, cube));
    }
    // A cube grown by the largest gap between the samples must not be missed by them.
    std::vector<HalfSpace> small = cube;
    for (HalfSpace& h : small) h.offset -= 0.1;
    if (reaches_into(t, small)) {
      EXPECT_TRUE(has_point);
    }
    reaching += has_point;
  }
  EXPECT_GT(reaching, 200);
  EXPECT_LT(reaching, 1800);
}

TEST(ListHalfSpaces, HoldTheHullAndMoveInwardsByTheInset) {
  Random random(5);
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) points.push_back(3.0 * random.direction() + Vec3(100, 0, 0));
  Quickhull hull;
  start_hull(hull, points, 1e-10);
  complete_hull(hull);
  std::vector<HalfSpace> at_rest, moved;
  list_half_spaces(hull, 0.0, at_rest);
  list_half_spaces(hull, 0.25, moved);
  ASSERT_EQ(at_rest.size(), moved.size());
  for (std::size_t i = 0; i < at_rest.size(); ++i) {
    for (const Vec3& p : points)
      EXPECT_LE(at_rest[i].normal.dot((p - hull.origin) * hull.scale), at_rest[i].offset + 1e-14);
    EXPECT_NEAR((at_rest[i].offset - moved[i].offset) / hull.scale, 0.25, 1e-12);
  }
}

}  // namespace
}  // namespace thigma
