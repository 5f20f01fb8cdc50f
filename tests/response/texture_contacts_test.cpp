#include "thigma/response/texture_contacts.h"

#include <iostream>

#include "depth/textured_plates.h"
#include "reference/offset_surface.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/loop/contact_step.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

constexpr double kSide = 0.1, kWave = 0.010, kAmplitude = 5e-4, kBall = 0.008;

/// A square with a sinusoid along x, seen from above.
HapticTexture ridged_square(int texels = 512) {
  TextureSource source;
  const double h = 0.5 * kSide, last = texels - 1.0;
  source.coarse = {{{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  source.corners = {{Vec2(0, 0), Vec2(last, 0), Vec2(last, last)},
                    {Vec2(0, 0), Vec2(last, last), Vec2(0, last)}};
  source.width = source.height = texels;
  for (int j = 0; j < texels; ++j) {
    for (int i = 0; i < texels; ++i) {
      const double x = kSide * (i / last - 0.5);
      source.texels.push_back(
          {0.0f, 0.0f, static_cast<float>(kAmplitude * cosine(2.0 * kPi * x / kWave))});
    }
  }
  return make_texture(std::move(source), "ridges");
}

/// A ball over a ridged square, perhaps with a plain one beside it.
struct BallOnRidges {
  explicit BallOnRidges(TextureParams params = {}, bool has_plain = false)
      : ridges(ridged_square()),
        smooth(make_plain_texture(ball_mesh, "ball")),
        plain(make_plain_texture(box_mesh, "box")),
        ball(build_exact_hierarchy(ball_mesh)),
        square(build_exact_hierarchy(ridges.coarse)),
        box(build_exact_hierarchy(box_mesh)) {
    world.object = &ball;
    world.scene = {{&square, Pose{}}};
    world.tolerance = 1e-4;
    world.max_clusters = 1;
    world.response.stiffness = 5000.0;
    world.textures.object = make_textured_body(smooth, ball);
    world.textures.scene = {make_textured_body(ridges, square)};
    world.textures.params = params;
    if (has_plain) {
      Pose beside;
      beside.position = {0.0, 0.5 * kSide + 0.0101, -0.01};
      world.scene.push_back({&box, beside});
      world.textures.scene.push_back(make_textured_body(plain, box));
      world.max_clusters = 4;
    }
    reserve_contact_scratch(world, scratch);
  }
  BallOnRidges(const BallOnRidges&) = delete;
  BallOnRidges& operator=(const BallOnRidges&) = delete;

  const LinearContactModel& at(const Vec3& position) {
    StampedBody body;
    body.state.position = position;
    contact_step(world, body, scratch, sample);
    return sample.model;
  }

  TriangleMesh ball_mesh = make_ball(kBall, 24), box_mesh = make_box({0.02, 0.02, 0.02});
  HapticTexture ridges, smooth, plain;
  ClodHierarchy ball, square, box;
  ContactWorld world;
  ContactScratch scratch;
  ContactSample sample;
};

// The ball's facets lie inside it by as much, at most: an edge is 1.2 R / 24 long.
constexpr double kFacet = 0.6e-3 * kBall;

TEST(TextureContacts, DepthOfABallIsThatOfTheOffsetSurface) {
  for (const DepthSearch search : {DepthSearch::grid, DepthSearch::branch}) {
    BallOnRidges scene({.search = search, .gradient = GradientKind::envelope});
    for (int i = 0; i < 25; ++i) {
      const double u = 0.021 + kWave * i / 25.0;
      const OffsetHeight offset = disk_on_wave(kBall, kAmplitude, kWave, u);
      const double depth = 2e-4;
      const LinearContactModel& model = scene.at({u, 0.003, kBall + offset.height - depth});
      ASSERT_EQ(model.depths.size(), 1u) << u;
      EXPECT_TRUE(model.planes.empty());
      const DepthTerm& term = model.depths[0];
      EXPECT_NEAR(term.depth, depth, kFacet + 0.01 * kAmplitude) << u;
      // The depth falls by a metre a metre as the ball rises, and follows the offset surface
      // sideways.
      EXPECT_NEAR(term.linear.z(), -1.0, 1e-6);
      EXPECT_NEAR(term.linear.y(), 0.0, 0.05);
      if (std::fabs(offset.slope) < 0.25) {  // away from cusps
        EXPECT_NEAR(term.linear.x(), offset.slope, 0.06) << u;
      }
      EXPECT_NEAR(term.stiffness, 5000.0, 1e-9);
      EXPECT_NEAR(scene.sample.depth_max, term.depth, 0.0);
    }
  }
}

// On a graphics processor, in a renderer in software, or on this processor: the same force, and a
// word about which.
TEST(TextureContacts, GraphicsProcessorGivesTheModelOfTheGrid) {
  TextureParams params{
      .search = DepthSearch::gpu, .resolution = 20, .gradient = GradientKind::envelope};
  BallOnRidges there(params);
  params.search = DepthSearch::grid;
  BallOnRidges here(params);
  std::vector<std::string> said;
  there.world.textures.warn = [&](const std::string& why) { said.push_back(why); };
  reserve_contact_scratch(there.world, there.scratch);
  for (int i = 0; i < 10; ++i) {
    const Vec3 at(0.021 + 3e-4 * i, 0.003, kBall + 1e-4);
    const LinearContactModel want = here.at(at), &got = there.at(at);
    ASSERT_EQ(got.depths.size(), want.depths.size());
    for (std::size_t k = 0; k < want.depths.size(); ++k) {
      EXPECT_NEAR(got.depths[k].depth, want.depths[k].depth, 1e-5 * kAmplitude);
      EXPECT_NEAR((got.depths[k].linear - want.depths[k].linear).norm(), 0.0, 1e-6);
    }
  }
  EXPECT_LE(said.size(), 1u);
  for (const std::string& line : said) std::cout << line << "\n";
}

TEST(TextureContacts, ReliefIsFeltBeforeAndNotOnlyWhereTheCoarseSurfaceIs) {
  BallOnRidges scene;
  const double crest = 0.02;  // a multiple of the wave
  EXPECT_EQ(scene.at({crest, 0.0, kBall + kAmplitude - 5e-5}).depths.size(), 1u);
  EXPECT_GT(scene.sample.model.depths[0].depth, 0.0) << "half a millimetre above the coarse square";
  // In a valley too wide for the ball to bridge the coarse surface is passed without force.
  const OffsetHeight valley = disk_on_wave(kBall, kAmplitude, kWave, crest + 0.5 * kWave);
  ASSERT_LT(valley.height, -1e-4);
  const LinearContactModel& above =
      scene.at({crest + 0.5 * kWave, 0.0, kBall + valley.height + 2e-5});
  ASSERT_EQ(above.depths.size(), 1u);
  EXPECT_LT(above.depths[0].depth, 0.0);
  EXPECT_EQ(scene.at({crest, 0.0, kBall + 3.0 * kAmplitude}).depths.size(), 0u);
}

TEST(TextureContacts, GradientIsWhatTheDepthChangesBy) {
  BallOnRidges scene({.search = DepthSearch::branch, .gradient = GradientKind::envelope});
  const Vec3 here(0.0228, 0.001, kBall - 1e-4);
  const DepthTerm term = scene.at(here).depths[0];
  const double step = 2e-5;
  for (int k = 0; k < 3; ++k) {
    const Vec3 way = step * Vec3::Unit(k);
    const double rise = scene.at(here + way).depths[0].depth - scene.at(here - way).depths[0].depth;
    EXPECT_NEAR(rise / (2.0 * step), term.linear[k], 0.05) << k;
  }
}

TEST(TextureContacts, MixWithPlainOnesAndShareTheStiffness) {
  BallOnRidges scene({}, true);
  // Between the ridges and the plain box, into both.
  const LinearContactModel& model = scene.at({0.02, 0.5 * kSide - 1e-4, kBall + kAmplitude - 3e-4});
  ASSERT_FALSE(model.depths.empty());
  double stiffness = 0.0;
  for (const DepthTerm& term : model.depths) stiffness += term.stiffness;
  for (const PlaneTerm& term : model.planes) stiffness += term.stiffness;
  EXPECT_NEAR(stiffness, 5000.0, 1e-6);
  // Over the box alone: planes, as if there were no textures.
  const Vec3 over_box(0.0, 0.5 * kSide + 0.0101, kBall - 5e-5);
  const LinearContactModel plain = scene.at(over_box);
  ASSERT_FALSE(plain.planes.empty());
  EXPECT_TRUE(plain.depths.empty());
  ContactWorld bare = scene.world;
  bare.textures = {};
  bare.distributes_wide_contacts = false;  // nor are contacts spread beside relief
  ContactScratch scratch;
  reserve_contact_scratch(bare, scratch);
  StampedBody body;
  body.state.position = over_box;
  ContactSample sample;
  contact_step(bare, body, scratch, sample);
  ASSERT_EQ(sample.model.planes.size(), plain.planes.size());
  const RigidBody rigid = make_body(0.01, 1e-6 * Mat3::Identity());
  BodyState state = body.state;
  const Wrench with = contact_wrench(plain, rigid, state),
               without = contact_wrench(sample.model, rigid, state);
  EXPECT_LE((with.force - without.force).norm(), 1e-9);
}

TEST(TextureContacts, FlatReliefFeelsAsAPlane) {
  // A texture of nothing but one height is the surface at that height.
  BallOnRidges scene({.gradient = GradientKind::envelope});
  TextureSource source;
  source.coarse = scene.ridges.coarse;
  source.corners = scene.ridges.corners;
  source.width = source.height = 512;
  source.texels.assign(512 * 512, Texel{0.0f, 0.0f, 3e-4f});
  const HapticTexture raised = make_texture(std::move(source), "raised");
  scene.world.textures.scene[0] = make_textured_body(raised, scene.square);
  reserve_contact_scratch(scene.world, scene.scratch);
  const LinearContactModel& model = scene.at({0.01, 0.02, kBall + 3e-4 - 1e-4});
  ASSERT_EQ(model.depths.size(), 1u);
  EXPECT_NEAR(model.depths[0].depth, 1e-4, kFacet);
  EXPECT_NEAR((model.depths[0].linear + Vec3::UnitZ()).norm(), 0.0, 0.05);
}

TEST(TextureContacts, EdgesOfABoxPushAsTheSurfaceBelowThemSlopes) {
  // A box tilted a little or more on the ridges touches with its lower edge, beside a side seen
  // almost edge-on.
  const TriangleMesh mesh = make_box({0.012, 0.012, 0.006});
  const HapticTexture smooth = make_plain_texture(mesh, "box");
  const ClodHierarchy box = build_exact_hierarchy(mesh);
  for (const double tilt : {1e-5, 1e-3, 0.02, 0.2}) {
    for (const GradientKind kind : {GradientKind::envelope, GradientKind::smoothed_envelope}) {
      BallOnRidges scene({.gradient = kind});
      scene.world.object = &box;
      scene.world.textures.object = make_textured_body(smooth, box);
      reserve_contact_scratch(scene.world, scene.scratch);
      for (int i = 0; i < 20; ++i) {
        StampedBody at;
        at.state.orientation = rotation_from_vector(Vec3(0.0, tilt, 0.0));
        at.state.position = {0.02 + kWave * i / 20.0, 0.0, 0.003 + 0.006 * sine(tilt)};
        contact_step(scene.world, at, scene.scratch, scene.sample);
        // The steepest place of the ridges and half the tilt bound what can be felt sideways.
        const double steepest = kAmplitude * 2.0 * kPi / kWave + tilt;
        for (const DepthTerm& term : scene.sample.model.depths) {
          EXPECT_NEAR(term.linear.z(), -1.0, 0.25) << tilt << ' ' << i;
          EXPECT_LE(term.linear.head<2>().norm(), 1.2 * steepest) << tilt << ' ' << i;
        }
      }
    }
  }
}

TEST(TextureContacts, LookAtTheTrianglesAroundTheirOwn) {
  Random random(3);
  const HapticTexture plate =
      make_texture(test::plate_source(random, {.size = kSide, .cells = 8, .texels = 256}), "plate");
  const ClodHierarchy hierarchy = build_exact_hierarchy(plate.coarse);
  BallOnRidges scene;
  scene.world.scene = {{&hierarchy, Pose{}}};
  scene.world.textures.scene = {make_textured_body(plate, hierarchy)};
  reserve_contact_scratch(scene.world, scene.scratch);
  scene.at({0.003, 0.004, kBall});
  ASSERT_FALSE(scene.scratch.textures->contacts.empty());
  for (const DepthContact& contact : scene.scratch.textures->contacts) {
    TriangleMarks marks{std::vector<std::uint32_t>(plate.coarse.triangles.size(), 0u)};
    marks.begin();
    for (const std::int32_t t : contact.scene.triangles) marks.add(t);
    std::vector<std::int32_t> want;
    add_ring(plate.coarse, vertex_triangles(plate.coarse), contact.scene.triangles, marks, want);
    EXPECT_TRUE(std::equal(want.begin(), want.end(), contact.scene.around.begin(),
                           contact.scene.around.end()));
    EXPECT_FALSE(want.empty()) << "or the whole plate is the contact";
    EXPECT_TRUE(contact.object.around.empty()) << "a ball without relief has nothing to see there";
  }
}

TEST(TextureContacts, SameBitsTwice) {
  const auto digest = [] {
    BallOnRidges scene;
    std::uint64_t all = 0;
    for (int i = 0; i < 20; ++i) {
      scene.at({0.02 + 1e-4 * i, 0.0, kBall});
      all = all * 31 + scene.sample.model_digest;
    }
    return all;
  };
  EXPECT_EQ(digest(), digest());
}

}  // namespace
}  // namespace thigma
