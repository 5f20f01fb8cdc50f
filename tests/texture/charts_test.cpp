#include "thigma/texture/charts.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Singular values of the map of a triangle from the surface, over the mean scale of the map.
Vec2 stretches(const TriangleMesh& mesh, const ChartMap& map, std::size_t t) {
  const auto& v = mesh.triangles[t];
  const auto at = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(v[k])]; };
  const Vec3 a = at(1) - at(0), b = at(2) - at(0);
  const Vec3 x = a.normalized(), y = a.cross(b).cross(a).normalized();
  Eigen::Matrix2d from, to;
  from << x.dot(a), x.dot(b), y.dot(a), y.dot(b);
  to << map.corners[t][1] - map.corners[t][0], map.corners[t][2] - map.corners[t][0];
  return (to * from.inverse() / map.texels_per_metre).jacobiSvd().singularValues();
}

/// No texel of two triangles, everything within the map, nothing mirrored, distortion as reported.
void expect_good_map(const TriangleMesh& mesh, const ChartMap& map, int texels, double limit) {
  ASSERT_EQ(map.corners.size(), mesh.triangles.size());
  TextureSource source{mesh, map.corners, texels, texels, {}};
  source.texels.assign(static_cast<std::size_t>(texels * texels), Texel{});
  EXPECT_NO_THROW(make_texture(source, "map"));
  double largest = 1.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = map.corners[t];
    EXPECT_GT(cross(c[1] - c[0], c[2] - c[0]), 0.0) << t;
    const Vec2 s = stretches(mesh, map, t);
    largest = std::max({largest, s[0], 1.0 / s[1]});
  }
  EXPECT_NEAR(map.distortion_max, largest, 1e-6 * largest);
  EXPECT_LE(map.distortion_max, limit);
}

TEST(Charts, BoxHasOneForEverySideAndNoDistortion) {
  const TriangleMesh box = make_box({0.03, 0.02, 0.01}, {3, 2, 1});
  const ChartMap map = make_charts(box, {.texels = 128}, "box");
  EXPECT_EQ(map.count, 6);
  expect_good_map(box, map, 128, 1.0 + 1e-6);
  EXPECT_GT(map.texels_per_metre * map.texels_per_metre * 2.2e-3, 0.4 * 128 * 128);  // well packed
}

TEST(Charts, StretchLittleWhateverTheSurface) {
  const TriangleMesh shapes[] = {make_ball(0.02, 6), make_torus(0.02, 0.008, 24, 12),
                                 make_cylinder(0.01, 0.03, 24, 3, 2), make_dome(0.5, 16, 8),
                                 make_l_shape(0.02, 0.005)};
  for (const TriangleMesh& mesh : shapes) {
    const ChartMap map = make_charts(mesh, {.texels = 256}, "shape");
    expect_good_map(mesh, map, 256, 1.5);
    EXPECT_LE(map.count, 30);
  }
}

TEST(Charts, RollOutWhatCanBeRolledOut) {
  // A quarter of a cylinder within one cone of normals: conformal is then isometric.
  const TriangleMesh bent = make_grid(9, 13, GridEnds::open, [](int row, int column) {
    const double angle = 0.5 * kPi * column / 12.0 - 0.25 * kPi;
    return Vec3(0.01 * sine(angle), 0.002 * row, 0.01 * cosine(angle));
  });
  const ChartMap map = make_charts(bent, {.texels = 128}, "bent");
  EXPECT_EQ(map.count, 1);
  expect_good_map(bent, map, 128, 1.0 + 1e-6);
}

TEST(Charts, KeepTheirGutter) {
  const TriangleMesh ball = make_ball(0.02, 4);
  const ChartParams params{.texels = 128, .gutter = 4};
  const ChartMap map = make_charts(ball, params, "ball");
  ASSERT_GT(map.count, 1);
  for (std::size_t a = 0; a < ball.triangles.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if (map.chart[a] == map.chart[b]) continue;
      for (const Vec2& p : map.corners[a])
        for (const Vec2& q : map.corners[b]) EXPECT_GE((p - q).norm(), params.gutter);
    }
  }
}

TEST(Charts, SayWhatTheyCannotMap) {
  TriangleMesh needle = make_box({1, 1, 1});
  needle.positions.push_back(0.5 * (needle.positions[0] + needle.positions[1]));
  needle.triangles.push_back({0, 1, static_cast<std::int32_t>(needle.positions.size()) - 1});
  EXPECT_THROW(make_charts(needle, {.texels = 64}, "needle"), InputError);
  EXPECT_THROW(make_charts(unwelded(make_ball(1.0, 6)), {.texels = 32}, "many"), InputError);
}

}  // namespace
}  // namespace thigma
