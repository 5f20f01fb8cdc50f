#include "thigma/contact/surface_crossing.h"

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TEST(SurfaceCrossing, WindsOnceAroundTheInside) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 5));
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = random.in_cube(1.5), to = random.in_cube(1.5);
    const Crossings c = count_crossings(ball, from, to);
    if (from.norm() < 0.9) {
      EXPECT_EQ(c.exits_after_from, 1);
    }
    if (from.norm() > 1.0) {
      EXPECT_EQ(c.exits_after_from, 0);
    }
    if (to.norm() < 0.9) {
      EXPECT_EQ(c.exits_after_to, 1);
    }
    if (to.norm() > 1.0) {
      EXPECT_EQ(c.exits_after_to, 0);
    }
    if (from.norm() < 0.9 && to.norm() > 1.0) {
      EXPECT_EQ(c.between, 1);
    }
  }
}

TEST(SurfaceCrossing, EdgesAndCornersCountOnce) {
  const ClodHierarchy box = build_exact_hierarchy(make_box(Vec3(2, 2, 2), {2, 2, 2}));
  for (const Vec3& to :
       {Vec3(3, 0, 0), Vec3(3, 0, 3), Vec3(3, 3, 3), Vec3(0, 3, 0), Vec3(3, 1, 0)}) {
    const Crossings c = count_crossings(box, Vec3::Zero(), to);
    EXPECT_EQ(c.between, 1) << to.transpose();
    EXPECT_EQ(c.exits_after_from, 1) << to.transpose();
  }
}

TEST(SurfaceCrossing, ClosedIsToldFromOpen) {
  EXPECT_TRUE(is_closed(build_exact_hierarchy(make_ball(1.0, 5))));
  EXPECT_TRUE(is_closed(build_exact_hierarchy(make_torus(1.0, 0.3, 20, 10))));
  EXPECT_TRUE(is_closed(build_exact_hierarchy(make_hollow_ball(1.0, 0.6, 4))));
  EXPECT_FALSE(is_closed(build_exact_hierarchy(make_sheet(1.0, 1.0, 4, 4))));
  EXPECT_FALSE(is_closed(build_exact_hierarchy(make_dome(1.0, 20, 8))));
  // A tube has area vectors that sum to zero; it takes the second integral to see its rims.
  const Vec2 wall[] = {Vec2(1.0, -1.0), Vec2(1.0, 1.0)};
  EXPECT_FALSE(is_closed(build_exact_hierarchy(make_revolution(wall, 24))));
}

// Two plates side by side, 0.1 apart: from the back of one to the back of the other the material
// ends in between.
TEST(SurfaceCrossing, ProbeSeesTheGapBetweenPlates) {
  const ClodHierarchy plate = build_exact_hierarchy(make_box(Vec3(1, 1, 0.2), {2, 2, 1}));
  CrossingContext context{&plate, &plate, {}};
  context.object_from_scene.translation = Vec3(0, 0, 0.3);
  const SegmentProbe probe = crossing_probe(context);
  // Lower face of the lower plate, upper face of the upper one.
  EXPECT_TRUE(probe.separates(probe.context, {Vec3(0.1, 0.2, -0.1), Vec3(0.1, 0.2, 0.4)}));
  // Pushed into each other they share material, from the bottom of b to the top of a.
  context.object_from_scene.translation = Vec3(0, 0, 0.15);
  EXPECT_FALSE(probe.separates(probe.context, {Vec3(0.1, 0.2, 0.1), Vec3(0.1, 0.2, 0.05)}));
}

}  // namespace
}  // namespace thigma
