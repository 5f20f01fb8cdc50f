#include "thigma/scene/start_placement.h"

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/loop/contact_step.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/make_model.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {
namespace {

using test::kCubeHalf;
using test::plane_session;

double height(const StartPlacement& start) {
  return start.world_from_body.position.z() - kCubeHalf;
}

TEST(FindStart, LeavesSeparatedObjectsWhereTheyAre) {
  const SessionConfig config = plane_session(0.015);
  const StartPlacement start = find_start(config.contact, config.world_from_body, 0.01);
  EXPECT_TRUE(start.has_scene);
  EXPECT_FALSE(start.is_moved);
  EXPECT_EQ(start.world_from_body.position, config.world_from_body.position);
  EXPECT_NEAR((start.approach + Vec3::UnitZ()).norm(), 0.0, 1e-12);
  // To where contacts begin, within the tolerance.
  EXPECT_NEAR(start.clearance, 0.015, config.contact.tolerance);
  EXPECT_LT(start.clearance, 0.015);
}

TEST(FindStart, MovesOnlyWhatTouches) {
  const double tolerance = plane_session().contact.tolerance;
  for (const double gap : {2.01, 3.0, 20.0}) {
    const SessionConfig config = plane_session(gap * tolerance);
    const StartPlacement start = find_start(config.contact, config.world_from_body, 0.05);
    EXPECT_FALSE(start.is_moved) << gap;
    EXPECT_EQ(start.world_from_body.position, config.world_from_body.position);
    EXPECT_NEAR(start.given_gap, gap * tolerance, 1e-12);
    EXPECT_NEAR(start.clearance, gap * tolerance, tolerance);
    EXPECT_GT(start.clearance, 0.0);
  }
}

TEST(FindStart, MovesOverlappingObjectsApart) {
  for (const double gap : {-0.01, -1e-4, 0.0, 3.9e-4}) {
    const SessionConfig config = plane_session(gap);
    const StartPlacement start = find_start(config.contact, config.world_from_body, 0.005);
    EXPECT_TRUE(start.is_moved);
    EXPECT_NEAR(start.given_gap, gap, 1e-12);
    EXPECT_GE(height(start), 0.005 * (1.0 - 1e-9));
    EXPECT_LT(height(start), 0.02);
    EXPECT_NEAR(start.world_from_body.position.head<2>().norm(), 0.0, 1e-12);
    EXPECT_NEAR(start.clearance, height(start), config.contact.tolerance);
  }
}

/// A ball of 1 cm about the origin and another object about it.
struct TwoSurfaces {
  ClodHierarchy object, ground;
  ContactWorld world;
  TwoSurfaces(const TriangleMesh& a, const TriangleMesh& b)
      : object(build_exact_hierarchy(a)), ground(build_exact_hierarchy(b)) {
    world.object = &object;
    world.scene = {{&ground, Pose{}}};
    world.tolerance = 1e-4;
    world.resolution.is_exact = true;
  }
};

// Where a session starts does not depend on whether its levels are built yet.
TEST(FindStart, AsksForTheFinestSurfacesWhateverTheResolution) {
  TwoSurfaces apart(make_ball(0.01, 6), make_box({0.2, 0.2, 0.06}, {6, 6, 2}));
  const Pose above{{0.0, 0.0, 0.0405}, Quat::Identity()};
  const StartPlacement exact = find_start(apart.world, above);
  apart.world.resolution.is_exact = false;
  apart.world.resolution.metric.haptic = 0.5;
  const StartPlacement coarse = find_start(apart.world, above);
  EXPECT_EQ(coarse.given_gap, exact.given_gap);
  EXPECT_EQ(coarse.clearance, exact.clearance);
  EXPECT_EQ(coarse.world_from_body.position, exact.world_from_body.position);
}

// Two wavy sides that fit each other have every pair of patches near; the nearest is wanted alone.
TEST(FindStart, FindsTheNearestOfConformingSurfacesFromFewPairs) {
  const TwoSurfaces fit(models::make_model(models::parse_model_uri(
                            "procedural:conforming_upper?triangles=4000&seed=1", "a")),
                        models::make_model(models::parse_model_uri(
                            "procedural:conforming_lower?triangles=4000&seed=1", "b")));
  StampedBody raised;
  raised.state.position.z() = 5e-4;  // so coarse, they overlap a little as given
  const StartPlacement start = find_start(fit.world, {raised.state.position, Quat::Identity()});
  // Brute force: all pairs within more than the gap.
  ContactScratch all;
  ContactWorld world = fit.world;
  world.tolerance = 2.0 * start.given_gap;
  world.capacity = 1 << 20;
  reserve_query(world, all);
  find_contacts(world, raised, all);
  EXPECT_EQ(least_distance(all.contacts), start.given_gap);
  EXPECT_GT(start.given_gap, 0.0);
}

TEST(FindStart, MovesOutWhatIsInsideWithoutTouching) {
  const TwoSurfaces inside(make_ball(0.01, 4), make_box({0.2, 0.2, 0.06}, {6, 6, 2}));
  const StartPlacement start = find_start(inside.world, {{0.0, 0.0, 0.005}, Quat::Identity()});
  EXPECT_TRUE(start.is_moved);
  EXPECT_NEAR(start.given_gap, -0.015, 1e-4);  // up to the top
  EXPECT_GT(start.world_from_body.position.z(), 0.03 + 0.01);
  EXPECT_NEAR(start.approach.z(), -1.0, 1e-3);
  EXPECT_NEAR(start.clearance, start.world_from_body.position.z() - 0.04, 1e-3);
  // The same about each other the other way round.
  const TwoSurfaces around(make_box({0.2, 0.2, 0.06}, {6, 6, 2}), make_ball(0.01, 4));
  EXPECT_LT(find_start(around.world, {{0.0, 0.0, 0.005}, Quat::Identity()}).given_gap, -0.01);
}

TEST(FindStart, LeavesWhatIsInACavityOrACup) {
  const TwoSurfaces cavity(make_ball(0.01, 4), make_hollow_ball(0.06, 0.04, 6));
  const StartPlacement in_cavity = find_start(cavity.world, {{0.0, 0.0, 0.02}, Quat::Identity()});
  EXPECT_FALSE(in_cavity.is_moved);
  EXPECT_NEAR(in_cavity.given_gap, 0.01, 1e-3);
  const TwoSurfaces dome(make_ball(0.01, 4), make_dome(0.05, 24, 6));  // open below
  EXPECT_FALSE(find_start(dome.world, {{0.0, 0.0, 0.01}, Quat::Identity()}).is_moved);
}

TEST(FindStart, FollowsTheWayOutItIsGiven) {
  const SessionConfig config = plane_session(-0.005);
  const Vec3 way(3.0, 0.0, 4.0);
  const StartPlacement start = find_start(config.contact, config.world_from_body, 0.005, &way);
  EXPECT_NEAR((start.approach + way / 5.0).norm(), 0.0, 1e-12);
  EXPECT_GE(height(start), 0.005 * (1.0 - 1e-9));
  EXPECT_NEAR(start.clearance * 0.8, height(start), 2.0 * config.contact.tolerance);
  const Vec3 into(0.0, 0.0, -1.0);
  EXPECT_THROW(find_start(config.contact, config.world_from_body, 0.005, &into),
               std::runtime_error);
}

TEST(FindStart, SaysWhenThereIsNothingNear) {
  SessionConfig config = plane_session(10.0);
  EXPECT_FALSE(find_start(config.contact, config.world_from_body).has_scene);
}

// Opening a graphics processor takes its time, and says what it found: the session's own time is
// the one.
TEST(FindStart, LeavesTheGraphicsProcessorToTheSession) {
  const TriangleMesh ball = make_ball(0.01, 8), box = make_box({0.05, 0.05, 0.02});
  const HapticTexture of_ball = make_plain_texture(ball, "ball"),
                      of_box = make_plain_texture(box, "box");
  const ClodHierarchy object = build_exact_hierarchy(ball), scene = build_exact_hierarchy(box);
  int said = 0;
  ContactWorld world;
  world.object = &object;
  world.scene = {{&scene, Pose{}}};
  world.tolerance = 1e-4;
  world.textures.object = make_textured_body(of_ball, object);
  world.textures.scene = {make_textured_body(of_box, scene)};
  world.textures.params.search = DepthSearch::gpu;
  world.textures.warn = [&](const std::string&) { ++said; };
  Pose above;
  above.position.z() = 0.03;
  const StartPlacement start = find_start(world, above, 0.0);
  EXPECT_TRUE(start.has_scene);
  EXPECT_NEAR(start.clearance, 0.01, 1e-3);
  EXPECT_EQ(said, 0);
}

}  // namespace
}  // namespace thigma
