// The exact query against an independent search over raw triangles, on coherent and random poses.

#include <limits>

#include "support/pressing.h"
#include "support/query_path.h"
#include <gtest/gtest.h>

#include "thigma/mesh/shapes.h"
#include "thigma/models/make_model.h"

namespace thigma {
namespace {

using test::Approach;
using test::CheckedPair;

TEST(TriangleSearch, AgreesWithAllPairsOnSmallMeshes) {
  Random random(23);
  const TriangleMesh shapes[] = {make_ball(1.0, 3), make_box(Vec3(1, 2, 0.5), {2, 3, 1}),
                                 make_torus(1.0, 0.3, 12, 8), make_l_shape(2.0, 0.4)};
  for (int round = 0; round < 60; ++round) {
    const auto a = test::build_triangle_tree(shapes[random.below(4)],
                                             {random.in_cube(1.5), random.orientation()});
    const auto b = test::build_triangle_tree(shapes[random.below(4)]);
    const double d = random.uniform(0.0, 0.5);
    const auto found = test::triangle_pairs_within(a, b, d);
    const auto all = test::all_pairs(a, b, d);
    ASSERT_EQ(found.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_EQ(found[i].a, all[i].a);
      ASSERT_EQ(found[i].b, all[i].b);
    }
    double least = std::numeric_limits<double>::infinity();
    for (const auto& p : test::all_pairs(a, b, 1e9)) least = std::min(least, p.distance);
    ASSERT_EQ(test::least_triangle_distance(a, b), least);
  }
}

TEST(ExactQuery, BallOnBall) {
  const CheckedPair pair = test::checked("ball on ball", make_ball(1.0, 20), make_ball(1.2, 24));
  test::check_pair(pair, test::from_above(pair), 0.01 * pair.radius);
}

TEST(ExactQuery, JawOnJaw) {
  const CheckedPair pair =
      test::checked("jaw on jaw", models::make_model({.name = "jaw_upper", .triangles = 12'000}),
                    models::make_model({.name = "jaw_lower", .triangles = 14'000}));
  test::check_pair(pair, test::from_above(pair), 0.01 * pair.radius);
}

TEST(ExactQuery, LShapeInBlocks) {
  // Large coplanar faces and parallel edges: the degenerate cases of every closest-point routine.
  const CheckedPair pair = test::checked("L-shape on box", make_l_shape(1.0, 0.3),
                                         make_box(Vec3(2, 1.5, 0.5), {4, 3, 1}));
  test::check_pair(pair, test::from_above(pair), 0.02 * pair.radius);
}

TEST(Pressing, BallOnBall) {
  const CheckedPair pair = test::checked("ball on ball", make_ball(1.0, 20), make_ball(1.2, 24));
  test::expect_smooth_pressing(pair, test::from_above(pair));
}

TEST(Pressing, JawOnJaw) {
  const CheckedPair pair = test::checked("jaw on jaw", models::make_model({.name = "jaw_upper"}),
                                         models::make_model({.name = "jaw_lower"}));
  test::expect_smooth_pressing(pair, test::from_above(pair));
}

}  // namespace
}  // namespace thigma
