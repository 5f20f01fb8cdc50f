#include "thigma/texture/detail/seams.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "thigma/core/index.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"
#include "thigma/texture/charts.h"
#include "thigma/texture/haptic_texture.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::detail {
namespace {

constexpr int kTexels = 96;

struct Box {
  TriangleMesh mesh = make_box({0.03, 0.02, 0.01}, {3, 3, 3});
  ChartMap charts = make_charts(mesh, {.texels = kTexels}, "box");
  std::vector<Seam> seams = find_seams(mesh, charts.corners);
};

Vec2 place_on(const Box& box, const Seam::Side& side, double share) {
  const Vec3 w = seam_weights(side, share);
  const std::array<Vec2, 3>& c = box.charts.corners[idx(side.triangle)];
  return w[0] * c[0] + w[1] * c[1] + w[2] * c[2];
}

/// Largest difference between the two sides over places of their own.
double largest_gap(const Box& box, const std::vector<Vec3>& texels) {
  TextureSource source{.coarse = box.mesh,
                       .corners = box.charts.corners,
                       .width = kTexels,
                       .height = kTexels,
                       .texels = {}};
  for (const Vec3& d : texels)
    source.texels.push_back(
        {static_cast<float>(d.x()), static_cast<float>(d.y()), static_cast<float>(d.z())});
  const HapticTexture texture = make_texture(std::move(source), "box");
  double gap = 0.0;
  for (const Seam& seam : box.seams) {
    for (int i = 0; i < 97; ++i) {
      const double share = (i + 0.5) / 97.0;
      gap = std::max(gap, (displacement_at(texture, place_on(box, seam.sides[0], share)) -
                           displacement_at(texture, place_on(box, seam.sides[1], share)))
                              .norm());
    }
  }
  return gap;
}

TEST(Seams, AreTheEdgesBetweenCharts) {
  const Box box;
  ASSERT_EQ(box.charts.count, 6);
  EXPECT_EQ(box.seams.size(), 12u * 3u);
  for (const Seam& seam : box.seams) {
    for (std::size_t end = 0; end < 2; ++end) {  // both sides name the same vertices
      const auto vertex = [&](const Seam::Side& side) {
        return box.mesh.triangles[idx(side.triangle)][static_cast<std::size_t>(side.corner[end])];
      };
      EXPECT_EQ(vertex(seam.sides[0]), vertex(seam.sides[1]));
    }
  }
  // One chart, however many triangles, has none.
  TriangleMesh sheet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::vector<std::array<Vec2, 3>> corners = {{Vec2(0, 0), Vec2(9, 0), Vec2(9, 9)},
                                                    {Vec2(0, 0), Vec2(9, 9), Vec2(0, 9)}};
  EXPECT_TRUE(find_seams(sheet, corners).empty());
}

// Each texel a displacement of its own: as far from agreeing as can be.
TEST(Seams, AgreeOnceStitched) {
  const Box box;
  Random random(5);
  std::vector<Vec3> texels(kTexels * kTexels);
  for (Vec3& d : texels) d = random.in_cube(1e-3);
  const double before = largest_gap(box, texels);
  StitchedMap map{kTexels, kTexels, texels, std::vector<double>(texels.size(), 1.0)};
  stitch_seams(box.seams, box.charts.corners, map);
  const std::vector<Vec3>& stitched = map.texels;
  EXPECT_GT(before, 1e-3);
  EXPECT_LT(largest_gap(box, stitched), 0.05 * before);
  double away = 0.0, moved = 0.0;
  for (int i = 0; i < kTexels * kTexels; ++i) {
    const Vec2 texel(i % kTexels, i / kTexels);
    double nearest = kTexels;
    for (const Seam& seam : box.seams) {
      for (const Seam::Side& side : seam.sides) {
        const Vec2 a = place_on(box, side, 0.0), along = place_on(box, side, 1.0) - a;
        const double share = std::clamp((texel - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (a + share * along - texel).norm());
      }
    }
    const double by =
        (stitched[static_cast<std::size_t>(i)] - texels[static_cast<std::size_t>(i)]).norm();
    if (nearest > 1.42) away = std::max(away, by);
    moved = std::max(moved, by);
  }
  EXPECT_EQ(away, 0.0);
  EXPECT_LT(moved, 2.0 * before);
}

TEST(Seams, MoveWhatGivesWay) {
  const Box box;
  const auto mean_step = [&](double ease) {
    Random random(6);
    StitchedMap map{kTexels, kTexels, std::vector<Vec3>(kTexels * kTexels),
                    std::vector<double>(kTexels * kTexels, 1.0)};
    for (Vec3& d : map.texels) d = random.in_cube(1e-3);
    for (std::size_t i = 0; i < map.ease.size(); i += 2) map.ease[i] = ease;
    const std::vector<Vec3> before = map.texels;
    stitch_seams(box.seams, box.charts.corners, map);
    double way = 0.0;
    for (std::size_t i = 0; i < map.ease.size(); i += 2) way += (map.texels[i] - before[i]).norm();
    return way;
  };
  EXPECT_LT(mean_step(0.01), 0.5 * mean_step(1.0));
}

}  // namespace
}  // namespace thigma::detail
