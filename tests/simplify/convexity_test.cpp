#include "thigma/simplify/convexity.h"

#include <vector>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

double volume(const ConvexityConstraint& c, const Vec3& v3) {  // Eq. 3.2 with vb = v3
  return (v3 - c.va).cross(c.vc - c.va).dot(c.vd - c.va);
}

TEST(SolveConvexity, FindsTheEndsOfWhatASweepFinds) {
  Random random(21);
  int feasible = 0, partial = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Vec3 v_hat = random.in_cube(1.0), v_tilde = random.in_cube(1.0);
    std::vector<ConvexityConstraint> constraints;
    for (int i = 0; i < 3; ++i)
      constraints.push_back({random.in_cube(1.0), random.in_cube(1.0), random.in_cube(1.0),
                             trial % 2 ? 0.01 * random.uniform() : 0.0});
    const UnitInterval solved = solve_convexity(v_hat, v_tilde, constraints);
    double low = 2.0, high = -1.0;
    for (int i = 0; i <= 4000; ++i) {
      const double u = i / 4000.0;
      bool meets = true;
      for (const auto& c : constraints)
        meets = meets && volume(c, mix(u, v_hat, v_tilde)) <= c.slack;
      if (!meets) continue;
      low = std::min(low, u);
      high = std::max(high, u);
    }
    if (low > 1.0) {
      EXPECT_TRUE(!solved.is_feasible || solved.high - solved.low < 1.0 / 4000);
      continue;
    }
    ++feasible;
    ASSERT_TRUE(solved.is_feasible);
    partial += solved.low > 0.0 && solved.high < 1.0;
    EXPECT_NEAR(solved.low, low, 1.0 / 3999);
    EXPECT_NEAR(solved.high, high, 1.0 / 3999);
  }
  EXPECT_GT(feasible, 50);
  EXPECT_GT(partial, 5);
}

TEST(SolveConvexity, ConvexMeansNegativeVolume) {
  // Two triangles on the edge from (0,0,0) to (0,1,0); v3 on the left, vd on the right, both below:
  // a ridge, convex. Above: a valley.
  const ConvexityConstraint ridge{{0, 1, 0}, {0, 0, 0}, {1, 0.5, -0.2}};
  EXPECT_LT(volume(ridge, {-1, 0.5, -0.2}), 0.0);
  EXPECT_GT(volume(ridge, {-1, 0.5, 0.6}), 0.0);
  const UnitInterval u = solve_convexity({-1, 0.5, -0.2}, {-1, 0.5, 0.6}, {{ridge}});
  EXPECT_TRUE(u.is_feasible);
  EXPECT_NEAR(u.low, 0.5, 1e-12);  // flat at z = 0.2
  EXPECT_EQ(u.high, 1.0);
}

TEST(Bisect, ReturnsTheLastAcceptedValue) {
  std::vector<double> asked;
  const auto from = [&](double g) {
    asked.clear();
    return [&asked, g](double u) {
      asked.push_back(u);
      return u >= g;
    };
  };
  EXPECT_EQ(bisect(0.25, 1.0, 3, from(0.2)).u, 0.25);
  EXPECT_EQ(asked.size(), 1u);
  const BisectionResult found = bisect(0.0, 1.0, 3, from(0.3));
  EXPECT_TRUE(found.is_accepted);
  EXPECT_EQ(asked, (std::vector<double>{0.0, 1.0, 0.5, 0.25, 0.375}));
  EXPECT_EQ(found.u, 0.375);
  EXPECT_FALSE(bisect(0.0, 0.9, 3, from(0.95)).is_accepted);
  EXPECT_FALSE(bisect(1.0, 1.0, 3, from(2.0)).is_accepted);
  EXPECT_EQ(asked.size(), 1u) << "one position is asked once";
}

}  // namespace
}  // namespace thigma
