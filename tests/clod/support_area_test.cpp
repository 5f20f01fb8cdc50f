#include "thigma/clod/support_area.h"

#include <gtest/gtest.h>

#include "thigma/contact/resolution.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

std::vector<std::array<double, 2>> areas_of(const TriangleMesh& mesh, const SupportParams& params) {
  return support_areas(mesh, compute_topology(mesh), params);
}

constexpr auto kRing = static_cast<std::size_t>(SupportReading::one_ring);
constexpr auto kFlood = static_cast<std::size_t>(SupportReading::flood);

TEST(SupportAreas, FloodAFlatSheetAndNoFartherThanItsRing) {
  const TriangleMesh sheet = make_sheet(2, 1, 8, 4);
  for (const auto& d : areas_of(sheet, {.tolerance = 0.01})) {
    EXPECT_NEAR(d[kFlood], 2.0, 1e-12);
    EXPECT_GE(d[kRing], 0.5 * 0.0625);  // one triangle at a corner
    EXPECT_LE(d[kRing], 4.0 * 0.0625);  // eight triangles at most
  }
  for (const auto& d : areas_of(sheet, {.tolerance = 0.01, .most_faces = 10}))
    EXPECT_LT(d[kFlood], 1.0) << "stopped early: a lower bound";
}

TEST(SupportAreas, AreTheSameWithAnyNumberOfThreads) {
  const TriangleMesh ball = make_ball(1.0, 8);
  const SurfaceTopology topology = compute_topology(ball);
  for (const int threads : {2, 3, 7})
    EXPECT_EQ(support_areas(ball, topology, {.tolerance = 0.1}, threads),
              areas_of(ball, {.tolerance = 0.1}));
}

TEST(SupportAreas, OfABallIsItsCap) {
  // Within a height h of the pole of a ball of radius 1 the projected cap is pi (2 h - h^2).
  const double h = 0.1, expected = kPi * (2.0 * h - h * h);
  const TriangleMesh ball = make_ball(1.0, 24);
  double sum = 0.0;
  const auto areas = areas_of(ball, {.tolerance = h});
  for (const auto& d : areas) {
    EXPECT_LE(d[kFlood], expected * 1.001) << "whole faces only";
    EXPECT_LT(d[kRing], 0.1 * d[kFlood]);
    sum += d[kFlood];
  }
  EXPECT_NEAR(sum / static_cast<double>(areas.size()), expected, 0.2 * expected);
}

TEST(SupportAreas, EndAtEdgesAndScaleAsAnArea) {
  const TriangleMesh box = make_box({1, 1, 1}, {4, 4, 4});
  const auto areas = areas_of(box, {.tolerance = 0.01});
  const auto large = areas_of(make_box({8, 8, 8}, {4, 4, 4}), {.tolerance = 0.08});
  for (std::size_t v = 0; v < areas.size(); ++v) {
    EXPECT_LE(areas[v][kFlood], 1.0 + 1e-12);
    EXPECT_EQ(large[v][kRing], 64.0 * areas[v][kRing]);
    EXPECT_EQ(large[v][kFlood], 64.0 * areas[v][kFlood]);
    int on_planes = 0;
    for (int k = 0; k < 3; ++k) on_planes += std::fabs(box.positions[v][k]) == 0.5;
    if (on_planes == 1) {
      EXPECT_NEAR(areas[v][kFlood], 1.0, 1e-12) << "all of its face";
    }
    if (on_planes > 1) {
      EXPECT_GT(areas[v][kFlood], 0.0);
      EXPECT_LT(areas[v][kFlood], 0.02) << "an edge stands on little more than itself";
      EXPECT_EQ(areas[v][kFlood], areas[v][kRing]);
    }
  }
}

TEST(SupportAreas, CountTheTipOfAPyramid) {
  TriangleMesh pyramid;  // 45 degrees steep
  pyramid.positions = {{0, 0, 0}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, -1}, {1, -1, -1}};
  pyramid.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  for (const double t : {0.01, 0.3}) {
    const auto tip = areas_of(pyramid, {.tolerance = t})[0];
    EXPECT_NEAR(tip[kRing], 4.0 * t * t, 1e-12);
    EXPECT_EQ(tip[kFlood], tip[kRing]);
  }
  EXPECT_NEAR(areas_of(pyramid, {.tolerance = 1.0})[0][kRing], 4.0, 1e-12);
  EXPECT_EQ(areas_of(pyramid, {.tolerance = 0.3, .cone_cosine = 0.8})[0][kRing], 0.0);
}

}  // namespace
}  // namespace thigma
