#include "thigma/clod/surface_deviation.h"

#include <cmath>

#include "clod/distance_by_loop.h"
#include <gtest/gtest.h>

#include "thigma/convex/quickhull.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

double bound(const DeviationTarget& target, const std::array<Vec3, 3>& triangle,
             double reach = 0.1) {
  std::int32_t nearest = 0;
  DeviationRange range;
  extend_deviation(target, triangle, reach, range, nearest);
  EXPECT_LE(range.met, range.bound * (1.0 + 1e-12));
  return range.bound;
}

/// Largest distance over a grid of points of the triangle.
double sampled(const TriangleMesh& mesh, const std::array<Vec3, 3>& c) {
  double largest = 0.0;
  constexpr int n = 12;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      largest = std::max(
          largest, test::distance_by_loop(mesh, c[0] + u * (c[1] - c[0]) + v * (c[2] - c[0])));
    }
  return largest;
}

TEST(SurfaceDeviation, NearestDistanceIsThatOfALoop) {
  const TriangleMesh mesh = make_torus(1.0, 0.4, 20, 12);
  const DeviationTarget target = build_deviation_target(mesh);
  Random random(41);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random.in_cube(1.6);
    auto guess = static_cast<std::int32_t>(random.below(mesh.triangles.size()));
    EXPECT_EQ(nearest_distance(target, p, guess), test::distance_by_loop(mesh, p));
  }
}

TEST(SurfaceDeviation, BoundsEveryPointAndStaysTight) {
  const TriangleMesh mesh = make_torus(1.0, 0.4, 28, 16);
  Random random(42);
  double worst = 0.0, sum = 0.0;
  int count = 0;
  for (const double reach : {0.0, 0.3}) {
    const DeviationTarget target = build_deviation_target(mesh);
    for (int i = 0; i < 60; ++i) {
      // A triangle near the surface: moved, turned and blown up.
      const auto& t = mesh.triangles[random.below(mesh.triangles.size())];
      std::array<Vec3, 3> c;
      const double size = random.uniform(0.5, 4.0);
      const Vec3 shift = 0.05 * random.in_cube(1.0);
      for (std::size_t k = 0; k < 3; ++k) c[k] = mesh.positions[static_cast<std::size_t>(t[k])];
      const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
      for (Vec3& p : c) p = middle + size * (p - middle) + shift + 0.02 * random.in_cube(1.0);
      const double most = bound(target, c, reach), met = sampled(mesh, c);
      EXPECT_GE(most, met * (1.0 - 1e-12));
      std::int32_t nearest = 0;
      DeviationRange far{0.0, 9.0}, near{0.0, 0.9 * met};
      extend_deviation(target, c, reach, far, nearest);
      EXPECT_EQ(far.bound, 9.0) << "known to be far less";
      extend_deviation(target, c, reach, near, nearest);
      EXPECT_GE(near.bound, met * (1.0 - 1e-12));
      worst = std::max(worst, most / met);
      sum += most / met;
      ++count;
    }
  }
  EXPECT_LT(sum / count, 1.5);
  EXPECT_LT(worst, 4.0);
}

TEST(SurfaceDeviation, IsAsTightForManyTrianglesAsForOne) {
  // What the bound of one triangle may lack must not add up over those that follow.
  const TriangleMesh mesh = make_torus(1.0, 0.4, 28, 16), moved = [&] {
    TriangleMesh m = make_torus(1.0, 0.4, 90, 60);
    Random random(7);
    for (Vec3& p : m.positions) p += 0.02 * random.in_cube(1.0);
    return m;
  }();
  const DeviationTarget target = build_deviation_target(mesh);
  DeviationRange range;
  std::int32_t nearest = 0;
  double sampled_most = 0.0;
  for (const auto& t : moved.triangles) {
    std::array<Vec3, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = moved.positions[static_cast<std::size_t>(t[k])];
    extend_deviation(target, c, 0.1, range, nearest);
    for (const Vec3& p : c) sampled_most = std::max(sampled_most, test::distance_by_loop(mesh, p));
  }
  EXPECT_GE(range.bound, sampled_most * (1.0 - 1e-12));
  EXPECT_LE(range.bound, 1.2 * sampled_most);
}

TEST(SurfaceDeviation, OfTheSurfaceItselfIsNone) {
  const TriangleMesh mesh = make_box({1, 2, 3}, {3, 3, 3});
  const DeviationTarget target = build_deviation_target(mesh);
  for (const auto& t : mesh.triangles)
    EXPECT_LT(bound(target, {mesh.positions[static_cast<std::size_t>(t[0])],
                             mesh.positions[static_cast<std::size_t>(t[1])],
                             mesh.positions[static_cast<std::size_t>(t[2])]}),
              1e-14);
  // A face moved out by a tenth.
  const Vec3 out(0.1, 0, 0), half(0.5, 0, 0);
  EXPECT_NEAR(bound(target, {half + out + Vec3(0, -0.9, -1.4), half + out + Vec3(0, 0.9, -1.4),
                             half + out + Vec3(0, 0.9, 1.4)}),
              0.1, 1e-12);
}

}  // namespace
}  // namespace thigma
