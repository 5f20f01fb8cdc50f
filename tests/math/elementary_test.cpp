#include "thigma/math/elementary.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

// The C library is the oracle for the value; the bits are ours.
TEST(Elementary, sine_and_cosine_agree_with_the_library) {
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const double x = i % 3 == 0 ? random.uniform(-1e5, 1e5) : random.uniform(-7.0, 7.0);
    const SinCos r = sin_cos(x);
    ASSERT_NEAR(r.sin, std::sin(x), 4e-16 + 1e-21 * std::fabs(x)) << x;
    ASSERT_NEAR(r.cos, std::cos(x), 4e-16 + 1e-21 * std::fabs(x)) << x;
  }
}

TEST(Elementary, small_angles_keep_relative_precision) {
  for (double x = 1.0; x > 1e-300; x *= 0.37) {
    ASSERT_NEAR(sine(x), std::sin(x), 4e-16 * x) << x;
    ASSERT_NEAR(arc_tangent2(x, 1.0), std::atan(x), 1e-15 * x) << x;
  }
}

TEST(Elementary, arc_tangent_covers_all_quadrants) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const double x = random.uniform(-2.0, 2.0);
    const double y = random.uniform(-2.0, 2.0);
    const double want = std::atan2(y, x);
    ASSERT_NEAR(arc_tangent2(y, x), want, 1e-15 * std::fabs(want)) << y << ' ' << x;
  }
  EXPECT_EQ(arc_tangent2(0.0, 0.0), 0.0);
  EXPECT_EQ(arc_tangent2(0.0, -1.0), kPi);
  EXPECT_EQ(arc_tangent2(-0.0, -1.0), -kPi);
}

TEST(Elementary, exponential_agrees_with_the_library) {
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const double x = random.uniform(-700.0, 700.0);
    ASSERT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-15) << x;
  }
  EXPECT_EQ(exponential(-1000.0), 0.0);
  EXPECT_TRUE(std::isinf(exponential(1000.0)));
}

TEST(Elementary, not_a_number_stays_one) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(sine(nan)));
  EXPECT_TRUE(std::isnan(cosine(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(arc_tangent2(nan, 1.0)));
}

}  // namespace
}  // namespace thigma
