#include "experiments/common/outside_depth.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace {

TEST(OutsideDepth, IsThatOfBoxesThroughEachOther) {
  const DepthSurface box = make_depth_surface(make_box(Vec3::Constant(0.02), {3, 3, 3}));
  const auto at_height = [&](double z) { return outside_depth(box, {{0.001, 0.002, z}}, box); };
  EXPECT_EQ(at_height(0.0201), 0.0);
  EXPECT_NEAR(at_height(0.0199), 1e-4, 1e-12);
  EXPECT_NEAR(at_height(0.015), 5e-3, 1e-12);
}

TEST(OutsideDepth, SeesEdgesThatCross) {
  const DepthSurface box = make_depth_surface(make_box(Vec3::Constant(0.02)));
  // Stood on edges that cross at a right angle: no corner is inside.
  const Pose turned{
      {0.0, 0.0, 2.0 * 0.01 * std::sqrt(2.0) - 1e-4},
      rotation_from_vector({0.0, 0.0, M_PI / 2}) * rotation_from_vector({M_PI / 4, 0.0, 0.0})};
  const DepthSurface ridge = make_depth_surface(transformed(
      make_box(Vec3::Constant(0.02)), {Vec3::Zero(), rotation_from_vector({M_PI / 4, 0.0, 0.0})}));
  const double depth = outside_depth(box, turned, ridge, 64);
  EXPECT_NEAR(depth, 1e-4 / std::sqrt(2.0), 0.1e-4);
}

/// All points that are looked at, each measured.
double depth_of_all(const DepthSurface& a, const Pose& b_from_a, const DepthSurface& b,
                    int samples) {
  double deepest = 0.0;
  for (const auto& t : a.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = [&](std::size_t i) {
        return transform_point(b_from_a, a.mesh.positions[static_cast<std::size_t>(t[i % 3])]);
      };
      const Vec3 from = corner(k), to = corner(k + 1);
      for (int n = 0; n < samples; ++n)
        deepest = std::max(
            deepest, -signed_distance(b, from + static_cast<double>(n) / samples * (to - from)));
    }
  }
  return deepest;
}

TEST(OutsideDepth, IsThatOfAllPointsOfLongEdges) {
  // Of blocks deep in each other, edges go through each other's sides.
  const DepthSurface long_block = make_depth_surface(make_box({0.10, 0.012, 0.014}));
  const DepthSurface block = make_depth_surface(make_box({0.03, 0.04, 0.05}));
  Random random(11);
  constexpr int kSamples = 16;
  for (int i = 0; i < 100; ++i) {
    const Pose pose{random.in_cube(0.01), rotation_from_vector(random.in_cube(0.4))};
    const double all = std::max(depth_of_all(long_block, pose, block, kSamples),
                                depth_of_all(block, inverse(pose), long_block, kSamples));
    ASSERT_NEAR(outside_depth(long_block, pose, block, kSamples), all, 1e-12) << i;
    ASSERT_GT(all, 1e-3) << i;
  }
}

TEST(OutsideDepth, SeesABallWhollyInside) {
  const DepthSurface large = make_depth_surface(make_ball(0.02, 6));
  const DepthSurface small = make_depth_surface(make_ball(0.002, 2));
  EXPECT_NEAR(outside_depth(small, Pose{}, large), 0.018, 3e-4);  // facets
}

TEST(OutsideDepth, IsTheSameWhateverIsRemembered) {
  const DepthSurface ball = make_depth_surface(make_ball(0.01, 5));
  const DepthSurface box = make_depth_surface(make_box(Vec3::Constant(0.02), {3, 4, 5}));
  DepthMemory memory;
  Random random(7);
  Vec3 turn = Vec3::Zero();
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    // In and out, small steps and a jump now and then.
    Vec3 at(0.002, 0.001 * std::sin(0.03 * i), 0.0195 + 0.0012 * std::sin(0.1 * i));
    if (i % 50 == 49) at += random.in_cube(0.01);
    turn += random.in_cube(i % 50 == 49 ? 1.0 : 0.01);
    const Pose pose{at, rotation_from_vector(turn)};
    const double depth = outside_depth(ball, pose, box);
    ASSERT_EQ(outside_depth(ball, pose, box, memory), depth) << i;
    inside += depth > 0.0;
  }
  EXPECT_GT(inside, 30);
  EXPECT_LT(inside, 300);
}

}  // namespace
}  // namespace thigma::experiments
