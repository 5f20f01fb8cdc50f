#include "scenes/textured_model.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/inspect.h"
#include "thigma/mesh/measure.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::scenes {
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
  const HapticTexture block = make_textured_model({"striped_block", 512});
  // Where one is high, the other, turned over about y, is low.
  for (int i = 0; i < 512; i += 37) {
    const double up = displacement_at(block, Vec2(i, 100)).z(),
                 down = displacement_at(block, Vec2(511 - i, 100)).z();
    EXPECT_NEAR(up, -down, 1e-9);
  }
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

}  // namespace
}  // namespace thigma::scenes
