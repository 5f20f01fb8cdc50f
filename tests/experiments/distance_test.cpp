#include "experiments/common/distance.h"

#include "support/triangle_search.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace {

TEST(LeastDistance, IsThatOfTheTriangles) {
  const TriangleMesh object = make_ball(0.02, 6), scene = make_box({0.06, 0.05, 0.04});
  const ClodHierarchy a = build_exact_hierarchy(object), b = build_exact_hierarchy(scene);
  const test::TriangleTree tree = test::build_triangle_tree(scene);
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    Pose pose;
    pose.orientation = random.orientation();
    pose.position = random.uniform(0.02, 0.12) * random.direction();
    const double wanted =
        test::least_triangle_distance(test::build_triangle_tree(object, pose), tree);
    EXPECT_NEAR(least_distance(a, pose, b, Pose{}), wanted, 1e-12) << i;
  }
}

TEST(PlaceAtDistance, StopsWhereTheDistanceIsMet) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(0.02, 6)),
                      box = build_exact_hierarchy(make_box({0.06, 0.05, 0.04}));
  Random random(5);
  for (const double wanted : {0.0, 0.001, 0.01}) {
    for (int i = 0; i < 10; ++i) {
      const Vec3 direction = random.direction();
      const Pose start{-0.2 * direction, random.orientation()};
      const Placed placed = place_at_distance(ball, start, direction, box, wanted, 1e-7);
      ASSERT_TRUE(placed.is_met);
      EXPECT_NEAR(least_distance(ball, placed.pose, box, Pose{}), wanted, 1e-7);
      EXPECT_EQ(placed.pose.orientation.coeffs(), start.orientation.coeffs());
    }
  }
}

TEST(PlaceAtDistance, SaysWhenTheObjectPassesBy) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(0.02, 4));
  const Pose start{Vec3(-0.2, 0.1, 0.0), Quat::Identity()};
  EXPECT_FALSE(place_at_distance(ball, start, Vec3::UnitX(), ball, 0.001, 1e-7).is_met);
}

}  // namespace
}  // namespace thigma::experiments
