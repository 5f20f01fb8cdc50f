#include "thigma/models/ring_surface.h"

#include <algorithm>
#include <cmath>

#include "support/closed_surface.h"
#include <gtest/gtest.h>

namespace thigma::models {
namespace {

TEST(RingSurface, MeetsAnyEvenCountWithNearlyEquilateralTriangles) {
  std::vector<ProfilePoint> profile;
  add_arc(profile, {Vec2::Zero(), 1.0, -0.5 * kPi, 0.5 * kPi, true});
  for (const int wished : {500, 2000, 12'346, 40'000}) {
    SCOPED_TRACE(wished);
    const TriangleMesh ball = make_ring_surface(
        profile, wished,
        [](const ProfilePoint& at, const SinCos& a) { return turned_place(at, a); });
    EXPECT_EQ(static_cast<int>(ball.triangles.size()), wished);
    const test::SurfaceCount count = test::count_surface(ball);
    EXPECT_EQ(count.boundary, 0);
    EXPECT_EQ(count.euler, 2);
    EXPECT_NEAR(count.volume, 4.0 / 3.0 * kPi, 4.0 * kPi * 10.0 / wished);
    double slimmest = 1.0;
    for (const auto& t : ball.triangles) {
      const auto at = [&](int i) { return ball.positions[static_cast<std::size_t>(t[i])]; };
      const double area2 = (at(1) - at(0)).cross(at(2) - at(0)).norm();
      const double longest = std::max({(at(1) - at(0)).squaredNorm(), (at(2) - at(1)).squaredNorm(),
                                       (at(0) - at(2)).squaredNorm()});
      slimmest = std::min(slimmest, area2 / longest);
    }
    EXPECT_GT(slimmest, 0.25);  // 0.87 is equilateral
  }
}

TEST(RingSurface, DensityPutsTrianglesWhereTheyAreWanted) {
  // The upper half of a ball has twice the edges per length: four fifths of the triangles.
  std::vector<ProfilePoint> profile;
  add_arc(profile, {Vec2::Zero(), 1.0, -0.5 * kPi, 0.0, true, 1.0});
  add_arc(profile, {Vec2::Zero(), 1.0, 0.0, 0.5 * kPi, true, 2.0});
  const TriangleMesh ball = make_ring_surface(
      profile, 20'000, [](const ProfilePoint& at, const SinCos& a) { return turned_place(at, a); });
  int above = 0;
  for (const auto& t : ball.triangles) {
    if (ball.positions[static_cast<std::size_t>(t[0])].z() > 0.0) ++above;
  }
  EXPECT_NEAR(above / 20'000.0, 0.8, 0.02);
}

TEST(WaveRelief, HasItsHeightAndDependsOnItsSeed) {
  const WaveRelief one = make_waves(1, 2.0, 0.1, 0.3, 24), two = make_waves(2, 2.0, 0.1, 0.3, 24);
  double squares = 0.0;
  int n = 0;
  for (double x = 0.0; x < 3.0; x += 0.07) {
    for (double y = 0.0; y < 3.0; y += 0.07, ++n) squares += std::pow(one.at({x, y, 0.1}), 2);
  }
  EXPECT_NEAR(std::sqrt(squares / n), 2.0, 0.3);
  EXPECT_NE(one.at({0.1, 0.2, 0.3}), two.at({0.1, 0.2, 0.3}));
}

}  // namespace
}  // namespace thigma::models
