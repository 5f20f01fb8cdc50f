// A contact step with textures allocates nothing once warm.
#include "depth/textured_plates.h"
#include "response/level_relief.h"
#include "support/audit.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/loop/contact_step.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

/// A smooth ball, and a textured plate below it.
struct BallOnPlate {
  HapticTexture plate = [] {
    Random random(1);
    const test::PlateShape shape{.size = 0.02, .cells = 4, .texels = 128};
    return make_texture(test::plate_source(random, shape), "plate");
  }();
  TriangleMesh mesh = make_ball(0.004, 8);
  HapticTexture smooth = make_plain_texture(mesh, "ball");
  ClodHierarchy ball = build_exact_hierarchy(mesh);
  ClodHierarchy below = build_exact_hierarchy(plate.coarse);
};

TEST(WarmTextures, allocate_nothing) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const BallOnPlate given;
  const HapticTexture &plate = given.plate, &smooth = given.smooth;
  const ClodHierarchy &ball = given.ball, &below = given.below;
  for (const DepthSearch search : {DepthSearch::grid, DepthSearch::branch}) {
    ContactWorld world;
    world.object = &ball;
    world.scene = {{&below, Pose{}}};
    world.tolerance = 1e-4;
    world.textures.object = make_textured_body(smooth, ball);
    world.textures.scene = {make_textured_body(plate, below)};
    world.textures.params.search = search;
    ContactScratch scratch;
    reserve_contact_scratch(world, scratch);
    ContactSample sample;
    std::size_t terms = 0;
    const auto slide = [&] {
      for (int i = 0; i < 60; ++i) {
        StampedBody at;
        at.time = 1e-3 * i;
        at.state.position = {1e-4 * (i - 30), 2e-5 * i, 0.004 + 2e-4};
        contact_step(world, at, scratch, sample);
        terms += sample.model.depths.size();
      }
    };
    slide();
    ASSERT_GT(terms, 60u);
    const test::AuditScope watched;
    slide();
    EXPECT_EQ(watched.counts().total(), 0);
  }
}

TEST(WarmTextures, rows_allocate_nothing) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const BallOnPlate given;
  const HapticTexture &plate = given.plate, &smooth = given.smooth;
  const ClodHierarchy &ball = given.ball, &below = given.below;
  SessionConfig config;
  config.contact.object = &ball;
  config.contact.scene = {{&below, Pose{}}};
  config.contact.textures.object = make_textured_body(smooth, ball);
  config.contact.textures.scene = {make_textured_body(plate, below)};
  config.contact.friction.assign(1, {0.2, 0.2});
  use_constraints(config);
  ContactScratch scratch;
  reserve_contact_scratch(config.contact, scratch);
  ContactSample sample;
  std::size_t rows = 0;
  const auto slide = [&] {
    for (int i = 0; i < 60; ++i) {
      StampedBody at;
      at.time = 1e-3 * i;
      at.wanted_speed = 0.05;
      at.state.position = {1e-4 * (i - 30), 2e-5 * i, 0.004 + 4e-4};
      contact_step(config.contact, at, scratch, sample);
      rows += sample.model.constraints.rows.size();
    }
  };
  slide();
  ASSERT_GT(rows, 60u);
  const test::AuditScope watched;
  slide();
  EXPECT_EQ(watched.counts().total(), 0);
}

TEST(WarmTextures, levels_allocate_nothing) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  const test::LevelRelief& assets = test::level_relief();
  ContactWorld world;
  world.object = &assets.ball.hierarchy;
  world.scene = {{&assets.box, Pose{}}};
  world.tolerance = test::kTolerance;
  world.resolution.is_exact = false;
  world.resolution.metric.haptic = 0.02;
  world.resolution.deviation_cap = kNoCap;
  world.textures.object = make_textured_levels(assets.of_ball, assets.ball.hierarchy);
  world.textures.scene = {make_textured_body(assets.of_box, assets.box)};
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  ContactSample sample;
  std::size_t terms = 0;
  const auto roll = [&] {
    for (int i = 0; i < 60; ++i) {
      StampedBody at;
      at.time = 1e-3 * i;
      at.state.position = {0.0, 0.0, 0.01 + test::kRadius};
      at.state.orientation = rotation_from_vector(Vec3(0.01 * i, 0.002 * i, 0.0));
      contact_step(world, at, scratch, sample);
      terms += sample.model.depths.size();
    }
  };
  roll();
  ASSERT_GT(terms, 30u);
  const test::AuditScope watched;
  roll();
  EXPECT_EQ(watched.counts().total(), 0);
}

}  // namespace
}  // namespace thigma
