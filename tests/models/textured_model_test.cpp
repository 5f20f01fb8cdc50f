#include "thigma/models/textured_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/depth/depth_gradient.h"
#include "thigma/import/inspect.h"
#include "thigma/loop/contact_step.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/measure.h"
#include "thigma/models/ridge_profile.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::models {
namespace {

TEST(TexturedModel, AllAreUsableAndTheSameEveryTime) {
  for (const TexturedInfo& info : textured_models()) {
    const HapticTexture one = make_textured_model({info.name, 64}),
                        two = make_textured_model({info.name, 64});
    EXPECT_EQ(inspect_mesh(one.coarse).verdict, MeshVerdict::usable) << info.name;
    EXPECT_GT(mass_properties(one.coarse).volume, 0.0);
    EXPECT_GT(one.amplitude, 0.0);
    ASSERT_EQ(one.texels.size(), two.texels.size());
    for (std::size_t i = 0; i < one.texels.size(); ++i)
      ASSERT_EQ(one.texels[i].z, two.texels[i].z) << info.name;
  }
}

TEST(TexturedModel, PlateHasTheRidgesOfTheText) {
  const HapticTexture plate = make_textured_model({"ridged_plate", 0});
  EXPECT_EQ(plate.coarse.triangles.size(), 16u);
  EXPECT_NEAR(plate.amplitude, 0.004, 1e-5);
  // Over the middle of the first triangle of the top.
  const auto& c = plate.corners[0];
  const Vec2 at = (c[0] + c[1] + c[2]) / 3.0;
  const Vec3 d = displacement_at(plate, at);
  const double x = 0.35 * (at.x() / 1023.0 - 0.5);
  EXPECT_NEAR(d.z(), 0.004 * sine(2.0 * kPi * x / 0.035), 1e-6);
  EXPECT_EQ(d.x(), 0.0);
}

TEST(TexturedModel, BlocksLieInEachOther) {
  for (const char* name : {"striped_block", "ridged_block"}) {
    const HapticTexture block = make_textured_model({name, 512});
    // Where one is high, the other, turned over about y, is low.
    for (int i = 0; i < 512; i += 37) {
      const double up = displacement_at(block, Vec2(i, 100)).z(),
                   down = displacement_at(block, Vec2(511 - i, 100)).z();
      EXPECT_NEAR(up, -down, 1e-9) << name;
    }
  }
}

// As on a tooth: a quarter of the way each on top, in the groove and on either flank.
TEST(TexturedModel, RidgedBlockHasFlatTopsAndGrooves) {
  const HapticTexture block = make_textured_model({"ridged_block", 2000});
  int on_top = 0, in_groove = 0, all = 0;
  for (int i = 0; i < 2000; ++i, ++all) {
    const double z = displacement_at(block, Vec2(i, 700)).z();
    on_top += z > 0.999 * 0.5 * kRidgeHeight;
    in_groove += z < -0.999 * 0.5 * kRidgeHeight;
  }
  EXPECT_NEAR(on_top, all / 4, all / 100);
  EXPECT_NEAR(in_groove, all / 4, all / 100);
}

void expect_no_push_along_ridges(const HapticTexture& block) {
  std::vector<std::int32_t> triangles(block.coarse.triangles.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  const std::unique_ptr<DepthBackend> search = make_grid_depth({});
  GradientScratch scratch;
  DepthContact contact;
  contact.object = {&block, triangles, {}};
  contact.scene = {&block, triangles, {}};
  constexpr double kTurn = 2e-3;
  Random random(4);
  int looked_at = 0;
  for (int i = 0; i < 300; ++i) {
    Pose& pose = contact.object.world_from_body;
    pose.position = {random.uniform(-0.005, 0.005), random.uniform(0.001, 0.01), 0.0215};
    pose.orientation = rotation_from_vector(random.in_cube(kTurn)) * Quat(0, 0, 1, 0);
    contact.point = contact.centre = pose.position;
    contact.normal = -Vec3::UnitZ() + Vec3(0.0, random.uniform(-kTurn, kTurn), 0.0);
    contact.normal.normalize();
    for (const GradientKind kind : {GradientKind::envelope, GradientKind::smoothed_envelope}) {
      const DepthRequest request = depth_request(kind, block.amplitude);
      DepthSamples sample;
      search->sample(std::span(&contact, 1), request, std::span(&sample, 1));
      ASSERT_TRUE(sample.is_found);
      // At a corner of what they share, where two rims hold the maximum, a slope is that of none or
      // either.
      if (std::fabs(sample.at.y()) > 0.04 - 5.0 * block.texel_size) continue;
      ++looked_at;
      const DepthGradient got = depth_gradient(contact, sample, kind, scratch);
      ASSERT_TRUE(got.is_valid);
      // The ridges rise by 0.63 at most; turned about the vertical, some of that goes along y.
      EXPECT_LE(std::fabs(got.linear.y()), 2.0 * kTurn) << i << ", " << gradient_name(kind);
    }
  }
  EXPECT_GT(looked_at, 400);
}

// Pushed along the ridges and tilted by a little, the deepest place is the rim of one block: what
// lies beside it, on the block or in the map, has no say in the slope.
TEST(TexturedModel, BlocksDoNotPushEachOtherAlongTheirRidges) {
  HapticTexture block = make_textured_model({"striped_block", 1024});
  expect_no_push_along_ridges(block);
  const auto beside = block.texels.begin() + std::ptrdiff_t{1024} * (block.width + 1);
  std::fill(beside, block.texels.end(), Texel{});
  expect_no_push_along_ridges(block);
}

TEST(TexturedModel, AddressesAreReadStrictly) {
  EXPECT_EQ(parse_textured_uri("procedural:ridged_plate", "t").texels, 0);
  EXPECT_EQ(parse_textured_uri("procedural:striped_block?texels=256", "t").texels, 256);
  for (const char* wrong :
       {"ridged_plate", "procedural:ridget_plate", "procedural:ridged_plate?texels=",
        "procedural:ridged_plate?texels=3", "procedural:ridged_plate?texels=99999",
        "procedural:ridged_plate?triangles=3", "procedural:ridged_plate?", "procedural:"})
    EXPECT_THROW(parse_textured_uri(wrong, "t"), InputError) << wrong;
}

// A fine surface displaced sideways until it lies the wrong way round: its depths are told to be
// none of a height field, those of one that does not are not.
TEST(TexturedModel, ReliefThatTurnsOverIsCounted) {
  for (const double aside : {0.0, -1.5}) {
    TextureSource source =
        make_textured_slab({Vec3(0.08, 0.06, 0.02), 256, [](double, double) { return 0.0; }});
    for (int row = 0; row < 256; ++row)
      for (int column = 0; column < 256; ++column)
        source.texels[static_cast<std::size_t>(row * source.width + column)].x =
            static_cast<float>(aside * 0.08 * (column / 255.0 - 0.5));
    const HapticTexture folded = make_texture(std::move(source), "folded"),
                        block = make_textured_model({"striped_block", 256});
    const ClodHierarchy object = build_exact_hierarchy(block.coarse),
                        scene = build_exact_hierarchy(folded.coarse);
    ContactWorld world;
    world.object = &object;
    world.scene.push_back({&scene, Pose{}});
    world.tolerance = 2e-4;
    world.textures.object = make_textured_body(block, object);
    world.textures.scene.push_back(make_textured_body(folded, scene));
    ContactScratch scratch;
    reserve_contact_scratch(world, scratch);
    ContactSample sample;
    int depths = 0, folds = 0;
    for (int i = 0; i < 16; ++i) {
      BodyState state;
      state.position = Vec3(1e-3 * i, 0.0, 0.0208);
      state.orientation = Quat(0.0, 0.0, 1.0, 0.0);
      contact_step(world, {state, 1e-3 * i, static_cast<std::uint64_t>(i) + 1}, scratch, sample);
      depths += sample.texture_depths;
      folds += sample.texture_folds;
    }
    EXPECT_GT(depths, 15);
    EXPECT_LE(folds, depths);
    if (aside == 0.0) EXPECT_EQ(folds, 0);
    if (aside < 0.0) EXPECT_GT(folds, depths / 2);
  }
}

}  // namespace
}  // namespace thigma::models
