#include "thigma/dynamics/friction.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

constexpr CombineRule kRules[] = {CombineRule::geometric, CombineRule::average,
                                  CombineRule::minimum, CombineRule::maximum};

TEST(Friction, PairsAreBetweenTheirMaterialsAndTheSameEitherWay) {
  Random random(5);
  for (int trial = 0; trial < 1000; ++trial) {
    const double a = random.uniform(0.0, 2.0), b = random.uniform(0.0, 2.0);
    const Friction first{a, a * random.uniform(1.0, 3.0)}, second{b, b * random.uniform(1.0, 3.0)};
    for (const CombineRule rule : kRules) {
      const Friction pair = combined(first, second, rule);
      EXPECT_EQ(pair, combined(second, first, rule));
      EXPECT_TRUE(is_valid(pair)) << pair.kinetic << " " << pair.at_rest;
      EXPECT_GE(pair.kinetic, std::min(a, b) * (1.0 - 1e-15));
      EXPECT_LE(pair.kinetic, std::max(a, b) * (1.0 + 1e-15));
      EXPECT_EQ(combined(first, first, rule), first);  // to the last bit
    }
  }
}

TEST(Friction, RulesAreWhatTheirNamesSay) {
  const Friction a{0.2, 0.45}, b{0.8, 0.8};
  EXPECT_NEAR(combined(a, b, CombineRule::geometric).kinetic, 0.4, 1e-15);
  EXPECT_NEAR(combined(a, b, CombineRule::geometric).at_rest, 0.6, 1e-15);
  EXPECT_NEAR(combined(a, b, CombineRule::average).kinetic, 0.5, 1e-15);
  EXPECT_EQ(combined(a, b, CombineRule::minimum).at_rest, 0.45);
  EXPECT_EQ(combined(a, b, CombineRule::maximum).kinetic, 0.8);
  // What has no friction slides on everything.
  EXPECT_EQ(combined(Friction{}, b, CombineRule::geometric), Friction{});
  // Out of range only where the materials are.
  const double large = 1e300;
  EXPECT_TRUE(is_valid(combined({large, large}, {0.5 * large, large}, CombineRule::geometric)));
}

TEST(Friction, KnowsWhatMakesNoSense) {
  EXPECT_TRUE(is_valid({0.0, 0.0}));
  EXPECT_TRUE(is_valid({0.0, 0.5}));
  EXPECT_FALSE(is_valid({-0.1, 0.5}));
  EXPECT_FALSE(is_valid({0.5, 0.4}));
  EXPECT_FALSE(is_valid({std::nan(""), 0.5}));
  EXPECT_FALSE(is_valid({0.5, std::nan("")}));
  EXPECT_FALSE(is_valid({0.5, std::numeric_limits<double>::infinity()}));
}

}  // namespace
}  // namespace thigma
