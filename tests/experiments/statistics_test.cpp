#include "experiments/common/statistics.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma::experiments {
namespace {

std::vector<double> wave(double frequency, double step, int count, double amplitude = 1.0) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(amplitude * sine(2.0 * kPi * frequency * step * i));
  return x;
}

TEST(Statistics, TellCentreAndSpread) {
  const std::vector<double> x = {2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0};
  EXPECT_DOUBLE_EQ(mean(x), 5.0);
  EXPECT_DOUBLE_EQ(standard_deviation(x), std::sqrt(32.0 / 7.0));
  EXPECT_DOUBLE_EQ(coefficient_of_variation(x), std::sqrt(32.0 / 7.0) / 5.0);
  EXPECT_DOUBLE_EQ(root_mean_square(x), std::sqrt(29.0));
}

TEST(Statistics, AreNoNumberWhereTheDataAreTooFew) {
  EXPECT_TRUE(std::isnan(mean({})));
  EXPECT_TRUE(std::isnan(standard_deviation(std::vector<double>{1.0})));
  EXPECT_TRUE(
      std::isnan(correlation(std::vector<double>{1.0, 1.0}, std::vector<double>{1.0, 2.0})));
  EXPECT_TRUE(
      std::isnan(correlation(std::vector<double>{1.0, 2.0}, std::vector<double>{1.0, 2.0, 3.0})));
  EXPECT_TRUE(
      std::isnan(fit_line(std::vector<double>{1.0, 1.0}, std::vector<double>{1.0, 2.0}).slope));
}

TEST(Statistics, CorrelateByValueAndByRank) {
  const std::vector<double> x = {1.0, 2.0, 3.0, 4.0, 5.0};
  const std::vector<double> line = {3.0, 5.0, 7.0, 9.0, 11.0};
  const std::vector<double> cubes = {1.0, 8.0, 27.0, 64.0, 125.0};
  EXPECT_NEAR(correlation(x, line), 1.0, 1e-14);
  EXPECT_LT(correlation(x, cubes), 0.95);
  EXPECT_NEAR(rank_correlation(x, cubes), 1.0, 1e-14);
  const std::vector<double> tied = {1.0, 1.0, 2.0, 2.0};
  EXPECT_NEAR(rank_correlation(tied, std::vector<double>{1.0, 2.0, 3.0, 4.0}), 2.0 / std::sqrt(5.0),
              1e-14);
  EXPECT_NEAR(rank_correlation(x, std::vector<double>{5.0, 4.0, 3.0, 2.0, 1.0}), -1.0, 1e-14);
}

TEST(Statistics, RanksCountAsOftenAsTheirWeightsSay) {
  const std::vector<double> x{1.0, 2.0, 3.0, 4.0}, y{2.0, 1.0, 4.0, 4.0};
  const std::vector<double> often{3.0, 1.0, 0.0, 2.0};
  const std::vector<double> repeated_x{1.0, 1.0, 1.0, 2.0, 4.0, 4.0},
      repeated_y{2.0, 2.0, 2.0, 1.0, 4.0, 4.0};
  EXPECT_NEAR(rank_correlation(x, y, std::vector<double>(4, 0.5)), rank_correlation(x, y), 1e-14);
  EXPECT_NEAR(rank_correlation(x, y, often), rank_correlation(repeated_x, repeated_y), 1e-14);
  EXPECT_TRUE(std::isnan(rank_correlation(x, std::vector<double>(4, 1.0), often)));
}

TEST(Statistics, MeasureAnErrorAgainstTheReference) {
  EXPECT_DOUBLE_EQ(relative_error(std::vector<double>{3.0, 6.0}, std::vector<double>{3.0, 4.0}),
                   0.4);
}

TEST(Statistics, FitLinesWithAnInterval) {
  // Anscombe's first set: slope 0.5 with standard error 0.1179, t of 9 degrees of freedom 2.262.
  const std::vector<double> x = {10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
  const std::vector<double> y = {8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68};
  const LineFit fit = fit_line(x, y);
  EXPECT_NEAR(fit.slope, 0.5001, 1e-4);
  EXPECT_NEAR(fit.intercept, 3.0001, 1e-4);
  EXPECT_NEAR(fit.r_squared, 0.6665, 1e-4);
  EXPECT_NEAR(fit.slope_high - fit.slope, 2.262 * 0.1179, 2e-4);
  EXPECT_NEAR(fit.slope - fit.slope_low, 2.262 * 0.1179, 2e-4);
}

TEST(Statistics, FitPowersAndLeaveOutWhatHasNoLogarithm) {
  std::vector<double> x = {1.0, 10.0, 100.0, 1000.0, 0.0}, y;
  for (const double v : x) y.push_back(3.0 * std::sqrt(v));
  const LineFit fit = fit_power(x, y);
  EXPECT_NEAR(fit.slope, 0.5, 1e-12);
  EXPECT_NEAR(fit.slope_high, 0.5, 1e-6);
}

TEST(Statistics, TellProportionalFromAffine) {
  const std::vector<double> x = {1.0, 2.0, 3.0, 4.0};
  EXPECT_NEAR(proportional_r_squared(x, std::vector<double>{2.0, 4.0, 6.0, 8.0}), 1.0, 1e-12);
  EXPECT_LT(proportional_r_squared(x, std::vector<double>{10.0, 10.1, 10.2, 10.3}), 0.0);
}

TEST(Statistics, LowPassKeepsSlowAndStopsFastWithoutDelay) {
  const double step = 0.001;
  const std::vector<double> slow = wave(5.0, step, 1000), fast = wave(300.0, step, 1000);
  EXPECT_LT(relative_error(low_pass(slow, step, 50.0), slow), 1e-3);
  // Ends are continued through their last value, whatever it is: only the inside is free of it.
  const std::vector<double> stopped = low_pass(fast, step, 50.0);
  EXPECT_LT(root_mean_square(std::vector<double>(stopped.begin() + 100, stopped.end() - 100)),
            1e-3);
  // Half the power of each of the two passes at the cutoff itself.
  EXPECT_NEAR(root_mean_square(low_pass(wave(50.0, step, 2000), step, 50.0)) * std::sqrt(2.0), 0.5,
              0.01);
  const std::vector<double> constant(50, 3.0);
  for (const double v : low_pass(constant, step, 50.0)) EXPECT_NEAR(v, 3.0, 1e-9);
}

TEST(Statistics, LowPassKeepsAStraightLineToItsEnds) {
  std::vector<double> line(400);
  std::iota(line.begin(), line.end(), 0.0);
  const std::vector<double> passed = low_pass(line, 0.001, 50.0);
  ASSERT_EQ(passed.size(), line.size());
  for (std::size_t i = 0; i < line.size(); ++i) EXPECT_NEAR(passed[i], line[i], 0.05) << i;
}

TEST(Statistics, DeriveTwice) {
  const double step = 0.01;
  std::vector<double> x;
  for (int i = 0; i < 10; ++i) x.push_back(7.0 * i * i * step * step);
  const std::vector<double> d = second_derivative(x, step);
  ASSERT_EQ(d.size(), 8u);
  for (const double v : d) EXPECT_NEAR(v, 14.0, 1e-8);
}

TEST(Statistics, MeasureABandAndNothingElse) {
  const double step = 0.001;
  std::vector<double> x = wave(10.0, step, 1000, 2.0);
  const std::vector<double> other = wave(100.0, step, 1000, 5.0);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += other[i] + 30.0;
  EXPECT_NEAR(band_level(x, step, 5.0, 20.0), 2.0 / std::sqrt(2.0), 0.01);
  EXPECT_NEAR(band_level(x, step, 50.0, 200.0), 5.0 / std::sqrt(2.0), 0.01);
  EXPECT_LT(band_level(x, step, 30.0, 60.0), 0.01);
}

TEST(Statistics, TellsAReferenceFromWhatIsAsStrongInItsBand) {
  const double step = 1e-3;
  const std::vector<double> reference = wave(20.0, step, 500);
  std::vector<double> weaker = wave(20.0, step, 500, 0.3);
  const std::vector<double> other = wave(26.0, step, 500, 2.0);
  for (std::size_t i = 0; i < weaker.size(); ++i) weaker[i] += other[i] + 7.0;
  EXPECT_NEAR(band_share(reference, reference, step, 10.0, 40.0), 1.0, 1e-12);
  EXPECT_NEAR(band_share(weaker, reference, step, 10.0, 40.0), 0.3, 0.02);
  EXPECT_NEAR(band_share(other, reference, step, 10.0, 40.0), 0.0, 0.02);
  EXPECT_GT(band_level(other, step, 10.0, 40.0), band_level(reference, step, 10.0, 40.0));
  EXPECT_TRUE(std::isnan(band_share(reference, std::vector<double>(500, 1.0), step, 10.0, 40.0)));
}

}  // namespace
}  // namespace thigma::experiments
