#include "thigma/math/quantile.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(SampleQuantile, LiesBetweenTheSamplesOnEitherSide) {
  const std::vector<double> x = {9.0, 4.0, 2.0, 5.0, 4.0, 7.0, 4.0, 5.0};
  EXPECT_DOUBLE_EQ(sample_quantile(x, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(sample_quantile(x, 0.5), 4.5);
  EXPECT_DOUBLE_EQ(sample_quantile(x, 0.75), 5.5);
  EXPECT_DOUBLE_EQ(sample_quantile(x, 1.0), 9.0);
}

TEST(SampleQuantile, RisesWithTheShare) {
  const std::vector<double> x = {0.3, -1.0, 8.0, 0.3, 2.5};
  double last = sample_quantile(x, 0.0);
  for (int i = 1; i <= 100; ++i) {
    const double now = sample_quantile(x, 0.01 * i);
    EXPECT_GE(now, last) << i;
    last = now;
  }
}

TEST(SampleQuantile, HoldsTheShareToWhatThereIs) {
  EXPECT_DOUBLE_EQ(sample_quantile({3.0}, 0.99), 3.0);
  EXPECT_DOUBLE_EQ(sample_quantile({1.0, 2.0}, -0.5), 1.0);
  EXPECT_DOUBLE_EQ(sample_quantile({1.0, 2.0}, 1.5), 2.0);
  EXPECT_TRUE(std::isnan(sample_quantile({}, 0.5)));
}

}  // namespace
}  // namespace thigma
