#include "experiments/common/fine_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "thigma/math/plane_cross.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace {

/// A sheet of cells x cells squares of random heights, that faces up or down.
TriangleMesh rough_sheet(Random& random, int cells, double height, bool is_up) {
  TriangleMesh mesh;
  const int n = cells + 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      mesh.positions.push_back({static_cast<double>(i) / cells - 0.5,
                                static_cast<double>(j) / cells - 0.5,
                                height * random.uniform(-1.0, 1.0)});
  const auto add = [&](int a, int b, int c) {
    if (is_up) mesh.triangles.push_back({a, b, c});
    if (!is_up) mesh.triangles.push_back({a, c, b});
  };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * n + i;
      add(a, a + 1, a + n + 1);
      add(a, a + n + 1, a + n);
    }
  }
  return mesh;
}

/// Height of a mesh over a point, by trying every triangle; NaN beside it.
double slow_height(const TriangleMesh& mesh, const Pose& pose, const Vec2& at) {
  double best = std::nan("");
  for (const auto& t : mesh.triangles) {
    Vec3 p[3];
    for (std::size_t k = 0; k < 3; ++k)
      p[k] = transform_point(pose, mesh.positions[static_cast<std::size_t>(t[k])]);
    const Vec2 a = p[0].head<2>(), b = p[1].head<2>(), c = p[2].head<2>();
    const double area = cross(b - a, c - a), v = cross(at - a, c - a) / area,
                 w = cross(b - a, at - a) / area;
    if (v < 0.0 || w < 0.0 || v + w > 1.0) continue;
    const double z = (1.0 - v - w) * p[0].z() + v * p[1].z() + w * p[2].z();
    if (!(best >= z)) best = z;
  }
  return best;
}

// The largest sum lies at a vertex or where edges cross: no place of a dense grid is deeper, and
// one comes near.
TEST(FineDepth, is_the_largest_sum_of_heights) {
  Random random(3);
  for (int n = 0; n < 8; ++n) {
    const double height = 0.02;
    const TriangleMesh object = rough_sheet(random, 7, height, true),
                       scene = rough_sheet(random, 9, height, false),
                       over = rough_sheet(random, 2, 0.0, true),
                       under = rough_sheet(random, 2, 0.0, false);
    std::vector<std::int32_t> all(over.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    const Pose turned{Vec3(random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), 0.0),
                      rotation_from_vector(Vec3(0.05, -0.03, random.uniform(-3.0, 3.0)))};
    const FineDepth got = fine_depth({&object, &over, all, turned}, {&scene, &under, all, Pose{}},
                                     Mat3::Identity(), Vec3::Zero(), 1.0);
    ASSERT_TRUE(got.is_found);
    constexpr int kSide = 250;
    double best = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < kSide * kSide; ++k) {
      const Vec2 at((k % kSide + 0.5) / kSide - 0.5, (k / kSide + 0.5) / kSide - 0.5);
      const double a = slow_height(object, turned, at);
      if (!std::isfinite(a)) continue;
      best = std::max(best, a - slow_height(scene, Pose{}, at));
    }
    EXPECT_GE(got.depth, best - 1e-12);
    EXPECT_LE(got.depth, best + 2.0 * (2.0 * height * 9.0 + 0.1) / kSide)
        << "steepest slopes of both times the spacing";
    const double there =
        slow_height(object, turned, {got.u, got.v}) - slow_height(scene, Pose{}, {got.u, got.v});
    if (!got.is_at_rim && std::isfinite(there)) EXPECT_NEAR(there, got.depth, 1e-9);
  }
}

TEST(FineDepth, leaves_sheets_beyond_its_band_and_places_without_ground_alone) {
  Random random(4);
  TriangleMesh object = rough_sheet(random, 4, 0.0, true);
  const TriangleMesh scene = rough_sheet(random, 4, 0.0, false),
                     ground = rough_sheet(random, 1, 0.0, true),
                     below = rough_sheet(random, 1, 0.0, false);
  // A second sheet high above.
  const std::int32_t first = static_cast<std::int32_t>(object.positions.size());
  for (const Vec2& p : {Vec2(-0.5, -0.5), Vec2(0.5, -0.5), Vec2(0.0, 0.5)})
    object.positions.push_back({p.x(), p.y(), 0.3});
  object.triangles.push_back({first, first + 1, first + 2});
  const std::vector<std::int32_t> both = {0, 1}, one = {0};
  const auto depth = [&](double band, const std::vector<std::int32_t>& triangles,
                         const Vec3& lift) {
    return fine_depth({&object, &ground, triangles, Pose{lift, Quat::Identity()}},
                      {&scene, &below, both, Pose{}}, Mat3::Identity(), Vec3::Zero(), band);
  };
  EXPECT_NEAR(depth(0.1, both, Vec3(0.0, 0.0, 0.05)).depth, 0.05, 1e-12);
  EXPECT_NEAR(depth(1.0, both, Vec3(0.0, 0.0, 0.05)).depth, 0.35, 1e-12);
  EXPECT_FALSE(depth(0.1, both, Vec3(2.0, 0.0, 0.0)).is_found);
  // Half the ground, leaning: the deepest place is at its rim.
  object.triangles.pop_back();
  const FineDepth half = fine_depth(
      {&object, &ground, one, Pose{Vec3::Zero(), rotation_from_vector(Vec3(0.1, 0.0, 0.0))}},
      {&scene, &below, both, Pose{}}, Mat3::Identity(), Vec3::Zero(), 0.1);
  EXPECT_TRUE(half.is_found && half.is_at_rim);
}

}  // namespace
}  // namespace thigma::experiments
