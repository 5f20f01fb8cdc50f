#include "thigma/models/golf.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace thigma::models {
namespace {

TEST(GolfBall, IsRoundWithDimplesAQuarterMillimetreDeep) {
  const TriangleMesh ball = make_golf_ball(100'000);
  double least = 1.0, greatest = 0.0;
  int in_dimples = 0;
  for (const Vec3& p : ball.positions) {
    least = std::min(least, p.norm());
    greatest = std::max(greatest, p.norm());
    if (p.norm() < 0.021335 - 1e-9) ++in_dimples;
  }
  EXPECT_NEAR(greatest, 0.021335, 1e-12);
  EXPECT_NEAR(greatest - least, 0.012 * 0.021335, 0.02e-3);
  // 392 caps of 0.093 rad, those that overlap counted once: about four fifths of the ball.
  EXPECT_NEAR(in_dimples / static_cast<double>(ball.positions.size()), 0.80, 0.08);
}

TEST(GolfClub, HasItsFaceItsScoreLinesAndItsHosel) {
  const TriangleMesh club = make_golf_club(104'888, 1);
  Vec3 low = Vec3::Constant(1.0), high = Vec3::Constant(-1.0);
  int scored = 0;
  for (const Vec3& p : club.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
    const double flat = 0.036 - (p.y() * p.y() + p.z() * p.z()) / (2.0 * 0.30);
    if (p.x() > 0.030 && std::fabs(p.y()) < 0.03 && p.x() < flat - 0.0003) ++scored;
  }
  EXPECT_NEAR(high.x(), 0.036, 0.0005);
  EXPECT_NEAR(high.y() - low.y(), 0.120, 0.008);
  EXPECT_GT(high.z(), 0.036);  // the hosel stands above the crown
  EXPECT_NEAR(low.z(), -0.026, 0.001);
  EXPECT_GT(scored, 300);
}

}  // namespace
}  // namespace thigma::models
