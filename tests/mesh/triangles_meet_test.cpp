#include "thigma/mesh/triangles_meet.h"

#include <vector>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/mesh/self_intersections.h"

namespace thigma {
namespace {

TEST(TrianglesMeet, KnowsWhatTheyShare) {
  const std::vector<Vec3> p = {{0, 0, 0},     {1, 0, 0}, {0, 1, 0}, {1, 1, 0},     {0.2, 0.2, -1},
                               {0.2, 0.2, 1}, {2, 2, 0}, {5, 5, 5}, {0.1, 0.1, 0}, {-1, -1, 0}};
  EXPECT_FALSE(triangles_meet(p, {0, 1, 2}, {2, 1, 3})) << "neighbours";
  EXPECT_TRUE(triangles_meet(p, {0, 1, 2}, {1, 0, 3})) << "folded onto each other";
  EXPECT_TRUE(triangles_meet(p, {0, 1, 2}, {4, 5, 6})) << "pierced";
  EXPECT_FALSE(triangles_meet(p, {0, 1, 2}, {3, 6, 7})) << "apart";
  EXPECT_FALSE(triangles_meet(p, {0, 1, 2}, {0, 9, 7})) << "one corner";
  EXPECT_TRUE(triangles_meet(p, {0, 1, 2}, {0, 4, 5})) << "one corner and more";
  EXPECT_TRUE(triangles_meet(p, {0, 1, 2}, {8, 5, 7})) << "touched";
  EXPECT_TRUE(triangles_meet(p, {0, 1, 2}, {1, 2, 0})) << "the same";
}

TEST(TrianglesMeet, IsSymmetricAndIndifferentToTheFirstCorner) {
  Random random(7);
  std::vector<Vec3> p;
  for (int i = 0; i < 9; ++i) p.push_back(random.in_cube(1.0));
  int meeting = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<std::int32_t, 3> a{}, b{};
    for (auto* t : {&a, &b}) {
      const auto first = static_cast<std::int32_t>(random.below(9));
      const auto step = static_cast<std::int32_t>(1 + random.below(4));
      *t = {first, (first + step) % 9, (first + 2 * step) % 9};
      if ((*t)[0] == (*t)[2]) (*t)[2] = (first + 1 + step) % 9;
    }
    const bool answer = triangles_meet(p, a, b);
    meeting += answer;
    EXPECT_EQ(answer, triangles_meet(p, b, a));
    EXPECT_EQ(answer, triangles_meet(p, {a[1], a[2], a[0]}, {b[2], b[0], b[1]}));
    EXPECT_EQ(answer, triangles_meet(p, {a[1], a[0], a[2]}, b));
  }
  EXPECT_GT(meeting, 100);
  EXPECT_LT(meeting, 1900);
}

}  // namespace
}  // namespace thigma
