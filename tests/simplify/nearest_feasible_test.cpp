#include "thigma/simplify/nearest_feasible.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

Vec3 random_vector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

double violation(const Vec3& p, const std::vector<LinearConstraint>& constraints) {
  double most = 0.0;
  for (const LinearConstraint& c : constraints) most = std::max(most, c.normal.dot(p) - c.offset);
  return most;
}

TEST(NearestFeasible, LeavesATargetThatMeetsAll) {
  const std::vector<LinearConstraint> box{{Vec3::UnitX(), 1}, {-Vec3::UnitX(), 1}};
  EXPECT_EQ(*nearest_feasible({0.5, 7, -3}, Mat3::Identity(), box, 1e-12), Vec3(0.5, 7, -3));
}

TEST(NearestFeasible, GoesToFaceEdgeAndCornerOfABox) {
  const std::vector<LinearConstraint> box{
      {Vec3::UnitX(), 1}, {Vec3::UnitY(), 1}, {Vec3::UnitZ(), 1}};
  const auto nearest = [&](const Vec3& p) {
    return *nearest_feasible(p, Mat3::Identity(), box, 1e-12);
  };
  EXPECT_LT((nearest({3, 0, 0}) - Vec3(1, 0, 0)).norm(), 1e-12);
  EXPECT_LT((nearest({3, 4, 0}) - Vec3(1, 1, 0)).norm(), 1e-12);
  EXPECT_LT((nearest({3, 4, 9}) - Vec3(1, 1, 1)).norm(), 1e-12);
}

TEST(NearestFeasible, SaysWhenNothingMeetsAll) {
  const std::vector<LinearConstraint> apart{{Vec3::UnitX(), -1}, {-Vec3::UnitX(), -1}};
  EXPECT_FALSE(nearest_feasible(Vec3::Zero(), Mat3::Identity(), apart, 1e-12));
  EXPECT_FALSE(nearest_feasible(Vec3::Zero(), Mat3::Zero(), {}, 1e-12)) << "no metric";
}

TEST(NearestFeasible, TakesASlabAsThinAsRounding) {
  const std::vector<LinearConstraint> slab{{Vec3::UnitZ(), 1e-9}, {-Vec3::UnitZ(), 1e-9}};
  const auto p = nearest_feasible({2, 3, 5}, Mat3::Identity(), slab, 1e-10);
  ASSERT_TRUE(p);
  EXPECT_LT((*p - Vec3(2, 3, 0)).norm(), 1e-8);
}

/// Nearest in any norm: no way there from the answer to a feasible point goes downhill.
TEST(NearestFeasible, IsNearestInTheNormOfTheMetric) {
  Random random(7);
  int bound = 0;
  for (int round = 0; round < 300; ++round) {
    Mat3 root;
    for (int i = 0; i < 3; ++i) root.col(i) = random_vector(random);
    const Mat3 metric = root.transpose() * root + 0.01 * Mat3::Identity();
    std::vector<LinearConstraint> constraints;  // around a ball about the origin: feasible
    for (int i = 0; i < 30; ++i)
      constraints.push_back({random_vector(random).normalized(), random.uniform(0.5, 1.5)});
    const Vec3 target = 3.0 * random_vector(random);
    const auto p = nearest_feasible(target, metric, constraints, 1e-12);
    ASSERT_TRUE(p);
    ASSERT_LE(violation(*p, constraints), 1e-9);
    bound += (*p - target).norm() > 1e-9;
    const Vec3 slope = metric * (*p - target);
    for (int i = 0; i < 200; ++i) {
      Vec3 other = 1.5 * random_vector(random);
      const double outside = violation(other, constraints);
      if (outside > 0.0) other *= 0.5 / (0.5 + outside);
      if (violation(other, constraints) > 0.0) continue;
      ASSERT_GE(slope.dot(other - *p), -1e-7 * (1.0 + slope.norm()));
    }
  }
  EXPECT_GT(bound, 100);
}

}  // namespace
}  // namespace thigma
