#include "experiments/common/outside_depth.h"

#include <gtest/gtest.h>

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

TEST(OutsideDepth, SeesABallWhollyInside) {
  const DepthSurface large = make_depth_surface(make_ball(0.02, 6));
  const DepthSurface small = make_depth_surface(make_ball(0.002, 2));
  EXPECT_NEAR(outside_depth(small, Pose{}, large), 0.018, 3e-4);  // facets
}

}  // namespace
}  // namespace thigma::experiments
