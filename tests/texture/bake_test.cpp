#include "thigma/texture/bake.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma {
namespace {

constexpr double kRadius = 0.02;

TriangleMesh bumpy_ball(int frequency, double relief) {
  TriangleMesh ball = make_ball(kRadius, frequency);
  for (Vec3& p : ball.positions)
    p *= 1.0 + relief * sine(300.0 * p.x()) * sine(250.0 * p.y() + 1.0) * sine(200.0 * p.z());
  return ball;
}

TEST(Bake, HoldsAFineSurfaceOverACoarseOne) {
  const TriangleMesh fine = bumpy_ball(24, 0.02), coarse = make_ball(kRadius, 3);
  const BakeParams params{.texels = 256, .samples = 4000};
  const TextureAsset baked = bake_surface(fine, coarse, params, "ball");
  const BakeFigures& f = baked.figures;
  EXPECT_GE(f.charts, 2);
  EXPECT_LE(f.distortion_max, 1.5);
  // 256 texels around: 0.4 mm of relief over 20 mm within 0.1 % on average.
  EXPECT_LT(*f.fit_error_rms, 1e-3 * kRadius);
  EXPECT_LT(*f.fit_error_max, 1e-2 * kRadius);
  EXPECT_LE(*f.crack_max, 0.2 * *f.fit_error_max);
  EXPECT_GT(baked.texture.amplitude, 0.01 * kRadius);
}

TEST(Bake, FitsBetterWithMoreTexels) {
  const TriangleMesh fine = bumpy_ball(16, 0.02), coarse = make_ball(kRadius, 3);
  double before = 1.0;
  for (const int texels : {48, 96, 192}) {
    const TextureAsset baked = bake_surface(fine, coarse, {.texels = texels, .samples = 2000}, "b");
    EXPECT_LT(*baked.figures.fit_error_rms, 0.7 * before) << texels;
    before = *baked.figures.fit_error_rms;
  }
}

TEST(Bake, OfASurfaceOntoItselfIsFlat) {
  const TriangleMesh box = make_box({0.03, 0.02, 0.01}, {2, 2, 2});
  const TextureAsset baked = bake_surface(box, box, {.texels = 96, .samples = 1000}, "box");
  EXPECT_LE(*baked.figures.fit_error_max, 1e-8);
  EXPECT_LE(*baked.figures.crack_max, 1e-8);
  EXPECT_LE(baked.texture.amplitude, 1e-8);
}

TEST(Bake, SameBytesForTheSameSurfaces) {
  const TriangleMesh fine = bumpy_ball(8, 0.02), coarse = make_ball(kRadius, 2);
  const auto bytes = [&] {
    return format_texture(bake_surface(fine, coarse, {.texels = 64, .samples = 500}, "b"));
  };
  EXPECT_EQ(bytes(), bytes());
}

TEST(Bake, MeasuresWhatDoesNotFit) {
  // A fine surface with a handle the coarse one lacks: reported, not hidden.
  const TriangleMesh coarse = make_ball(kRadius, 3);
  const TriangleMesh fine = joined(
      coarse, transformed(make_ball(0.004, 4), Pose{Vec3(0.0, 0.0, 0.030), Quat::Identity()}));
  const TextureAsset baked = bake_surface(fine, coarse, {.texels = 96, .samples = 4000}, "b");
  EXPECT_GT(*baked.figures.fit_error_max, 1e-3);
  const TriangleMesh away = transformed(coarse, Pose{Vec3(1.0, 0.0, 0.0), Quat::Identity()});
  EXPECT_THROW(bake_surface(away, coarse, {.texels = 64}, "away"), InputError);
}

std::vector<std::array<Vec2, 3>> unit_square() {
  return {{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)}};
}

TriangleMesh square() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

TEST(BakeHeights, LieOverTheirTexels) {
  const HeightImage image{4, 2, {0.0f, 0.25f, 0.5f, 1.0f, 1.0f, 1.0f, 0.0f, 0.0f}};
  const TextureAsset baked = bake_heights(square(), unit_square(), image, 0.01, "square");
  const HapticTexture& t = baked.texture;
  EXPECT_EQ(baked.figures.charts, 1);
  EXPECT_FALSE(baked.figures.fit_error_rms.has_value());
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 4; ++column) {
      const double grey = double{image.values[static_cast<std::size_t>(4 * row + column)]};
      const Vec3 d = displacement_at(t, Vec2(column, row));
      EXPECT_NEAR(d.z(), 0.01 * (2.0 * grey - 1.0), 1e-9);
      EXPECT_NEAR(d.head<2>().norm(), 0.0, 1e-9);
    }
  }
  // The picture stands upright: its first row lies at v = 1.
  EXPECT_EQ(t.corners[0][0], Vec2(-0.5, 1.5));
  EXPECT_EQ(t.corners[0][2], Vec2(3.5, -0.5));
  EXPECT_NEAR(baked.figures.distortion_max, std::sqrt(2.0), 1e-12);  // 4 x 2 texels over a square
}

TEST(BakeHeights, RefuseWhatMakesNoSense) {
  const HeightImage one{1, 1, {1.0f}};
  EXPECT_NO_THROW(bake_heights(square(), unit_square(), one, 0.1, "s"));
  for (const double amplitude : {0.0, -1.0, 1e9, std::numeric_limits<double>::infinity(),
                                 std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(bake_heights(square(), unit_square(), one, amplitude, "s"), InputError)
        << amplitude;
  auto beyond = unit_square();
  beyond[0][1].x() = 1.5;
  EXPECT_THROW(bake_heights(square(), beyond, one, 0.1, "s"), InputError);
  auto twice = unit_square();
  twice[1] = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
  const HeightImage many{8, 8, std::vector<float>(64, 0.5f)};
  EXPECT_THROW(bake_heights(square(), twice, many, 0.1, "s"), InputError);
  EXPECT_THROW(bake_heights(square(), {}, many, 0.1, "s"), InputError);
}

}  // namespace
}  // namespace thigma
