#include "thigma/texture/texel_lookup.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(TexelLookup, value_is_the_bilinear_one_also_beyond_the_border) {
  Random random(1);
  for (const int texels : {1, 2, 9}) {
    const HapticTexture texture = make_texture(
        test::plate_source(random, {.texels = std::max(texels, 2), .noise = 1e-4}), "t");
    for (int i = 0; i < 200; ++i) {
      const Vec2 at(random.uniform(-2.0, texels + 1.0), random.uniform(-2.0, texels + 1.0));
      const Vec3 want = test::lookup(texture, at);
      EXPECT_LE((displacement_at(texture, at) - want).norm(), 1e-18);
      EXPECT_EQ(texel_jet(texture, at).value, displacement_at(texture, at));
    }
  }
}

TEST(TexelLookup, coordinates_that_are_no_numbers_give_a_texel) {
  Random random(2);
  const HapticTexture texture = make_texture(test::plate_source(random, {.texels = 8}), "t");
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(displacement_at(texture, {nan, infinity}).allFinite());
  EXPECT_TRUE(displacement_at(texture, {-infinity, 1e300}).allFinite());
}

TEST(TexelLookup, facet_derivatives_are_those_of_the_value) {
  Random random(3);
  const HapticTexture texture =
      make_texture(test::plate_source(random, {.texels = 12, .noise = 1e-4}), "t");
  const double step = 1e-3;
  for (int i = 0; i < 200; ++i) {
    const Vec2 inside(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99));
    const Vec2 at =
        Vec2(std::floor(random.uniform(0, 11)), std::floor(random.uniform(0, 11))) + inside;
    const TexelJet jet = texel_jet(texture, at);
    const Vec2 x(step, 0), y(0, step);
    const Vec3 by_x =
        (displacement_at(texture, at + x) - displacement_at(texture, at - x)) / (2 * step);
    const Vec3 by_y =
        (displacement_at(texture, at + y) - displacement_at(texture, at - y)) / (2 * step);
    EXPECT_LE((jet.facet_by_x - by_x).norm(), 1e-14);
    EXPECT_LE((jet.facet_by_y - by_y).norm(), 1e-14);
  }
}

// A relief whose slopes are known: the interpolated central differences are of second order.
TEST(TexelLookup, tangents_and_curvatures_converge_to_those_of_the_relief) {
  const auto worst = [](int texels) {
    TextureSource source;
    source.coarse.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    source.coarse.triangles = {{0, 1, 2}, {0, 2, 3}};
    const double top = texels - 1.0;
    source.corners = {{Vec2(0, 0), Vec2(top, 0), Vec2(top, top)},
                      {Vec2(0, 0), Vec2(top, top), Vec2(0, top)}};
    source.width = source.height = texels;
    const auto height = [&](double x, double y) {
      return 0.01 * sine(9.0 * x + 1.0) * cosine(7.0 * y);
    };
    for (int j = 0; j < texels; ++j)
      for (int i = 0; i < texels; ++i)
        source.texels.push_back({0.0f, 0.0f, static_cast<float>(height(i / top, j / top))});
    const HapticTexture texture = make_texture(source, "t");
    Random random(4);
    Vec2 error = Vec2::Zero();
    for (int i = 0; i < 300; ++i) {
      const double x = random.uniform(0.1, 0.9), y = random.uniform(0.1, 0.9);
      const TexelJet jet = texel_jet(texture, Vec2(x, y) * top);
      const double by_x = 0.09 * cosine(9.0 * x + 1.0) * cosine(7.0 * y);
      const double by_yy = -49.0 * height(x, y);
      error.x() = std::max(error.x(), std::fabs(jet.by_x.z() * top - by_x) / 0.09);
      error.y() = std::max(error.y(), std::fabs(jet.by_yy.z() * top * top - by_yy) / 0.49);
    }
    return error;
  };
  const Vec2 coarse = worst(33), fine = worst(65);
  EXPECT_LE(coarse.maxCoeff(), 0.05);
  EXPECT_LE(fine.x(), 0.3 * coarse.x());
  EXPECT_LE(fine.y(), 0.3 * coarse.y());
}

TEST(TexelLookup, tangents_do_not_jump_between_texels) {
  Random random(5);
  const HapticTexture texture =
      make_texture(test::plate_source(random, {.texels = 12, .noise = 1e-4}), "t");
  for (int i = 0; i < 100; ++i) {
    const Vec2 at(std::floor(random.uniform(2, 10)), random.uniform(2, 10));
    const TexelJet left = texel_jet(texture, at - Vec2(1e-9, 0)),
                   right = texel_jet(texture, at + Vec2(1e-9, 0));
    EXPECT_LE((left.by_x - right.by_x).norm(), 1e-11);
    EXPECT_LE((left.by_yy - right.by_yy).norm(), 1e-11);
    EXPECT_GT((left.facet_by_x - right.facet_by_x).norm(), 1e-8);
  }
}

}  // namespace
}  // namespace thigma
