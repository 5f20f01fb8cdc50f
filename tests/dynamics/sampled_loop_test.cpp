#include "thigma/dynamics/sampled_loop.h"

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "thigma/math/types.h"

namespace thigma {
namespace {

/// A body that does not move: the coupling is then the two-sided wall of docs/sources.md, E3 on a
/// handle without damping.
SampledLoop wall(double alpha, double beta, double delay_in_frames = 0.0) {
  const double mass = 0.1, period = 1e-3;
  return {.period = period,
          .delay = delay_in_frames * period,
          .handle_mass = mass,
          .body_mass = std::numeric_limits<double>::infinity(),
          .coupling_stiffness = alpha * mass / (period * period),
          .coupling_damping = beta * mass / period};
}

/// Largest root of z^3 + (-2 + (alpha + beta) / 2) z^2 + (1 + alpha / 2) z - beta / 2
/// (docs/sources.md, E3, check 1).
double largest_root(double alpha, double beta) {
  Mat3 companion = Mat3::Zero();
  companion(1, 0) = companion(2, 1) = 1.0;
  companion.col(2) << beta / 2.0, -(1.0 + alpha / 2.0), 2.0 - (alpha + beta) / 2.0;
  return companion.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(SampledLoop, GrowsAsTheCharacteristicPolynomialSays) {
  for (const double beta : {0.2, 0.5, 0.828, 1.2, 1.7}) {
    const double bound = 2.0 * beta * (2.0 - beta) / (2.0 + beta);
    for (const double share : {0.3, 0.7, 0.97, 1.03, 1.3}) {
      const double growth = loop_growth(wall(share * bound, beta));
      EXPECT_NEAR(growth, largest_root(share * bound, beta), 2e-3) << beta << " " << share;
      EXPECT_EQ(growth < 1.0, share < 1.0) << beta << " " << share;
    }
  }
}

TEST(SampledLoop, LateSamplesShrinkTheStableRangeAsPublished) {
  // docs/sources.md, E3: largest stable alpha 0.145, 0.063, 0.035 with one, two, three samples of
  // delay.
  const double betas[] = {0.42, 0.29, 0.22}, bounds[] = {0.145, 0.063, 0.035};
  for (int late = 1; late <= 3; ++late) {
    EXPECT_LT(loop_growth(wall(0.95 * bounds[late - 1], betas[late - 1], late)), 1.0) << late;
    EXPECT_GT(loop_growth(wall(1.05 * bounds[late - 1], betas[late - 1], late)), 1.0) << late;
  }
  // Between whole samples the delay counts as much as its part.
  EXPECT_GT(loop_growth(wall(0.10, 0.42, 1.5)), loop_growth(wall(0.10, 0.42, 1.0)));
  EXPECT_LT(loop_growth(wall(0.10, 0.42, 1.5)), loop_growth(wall(0.10, 0.42, 2.0)));
}

TEST(SampledLoop, AnArmAloneDecaysAsItsDampingSays) {
  for (const double stiffness : {100.0, 1500.0, 1e5}) {
    SampledLoop loop{.handle_mass = 0.05,
                     .handle_damping = 0.2,
                     .arm_mass = 0.15,
                     .arm_stiffness = stiffness,
                     .arm_damping = 1.8};
    EXPECT_NEAR(loop_growth(loop), std::exp(-1e-3 * 2.0 / (2.0 * 0.2)), 1e-3) << stiffness;
  }
}

TEST(SampledLoop, BackwardEulerHoldsALightBodyWithAnySpring) {
  for (const double body : {1e-5, 1e-3, 0.1}) {
    SampledLoop loop{.handle_mass = 0.075,
                     .arm_stiffness = 400.0,
                     .arm_damping = 8.0,
                     .body_mass = body,
                     .coupling_stiffness = 300.0};
    loop.coupling_damping = 2.0 * std::sqrt(300.0 * body);
    EXPECT_LT(loop_growth(loop), 1.0) << body;
    loop.contact_stiffness = 1e6;
    loop.contact_damping = 2.0 * std::sqrt(1e6 * body);
    EXPECT_LT(loop_growth(loop), 1.0) << body;
  }
}

TEST(SampledLoop, MotionThatDiesToNothingOrGrowsWithoutEndStaysANumber) {
  EXPECT_EQ(loop_growth(wall(50.0, 1.0)), 2.0);
  SampledLoop loop{.handle_mass = 0.01, .handle_damping = 100.0, .arm_stiffness = 1e4};
  EXPECT_GE(loop_growth(loop), 0.0);
  EXPECT_LT(loop_growth(loop), 1.0);
}

}  // namespace
}  // namespace thigma
