#include "thigma/dynamics/row_solve.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

Vec6 gradient_of(const VelocityRows& rows, int i) {
  Vec6 g;
  for (std::size_t k = 0; k < 6; ++k)
    g[static_cast<Eigen::Index>(k)] = rows.gradient[k][static_cast<std::size_t>(i)];
  return g;
}

void set_row(VelocityRows& rows, int i, const Vec6& gradient, double limit) {
  const auto r = static_cast<std::size_t>(i);
  for (std::size_t k = 0; k < 6; ++k) rows.gradient[k][r] = gradient[static_cast<Eigen::Index>(k)];
  rows.limit[r] = limit;
  rows.friction[r] = {};
}

Vec6 random_vector(Random& random) {
  Vec6 v;
  for (Eigen::Index k = 0; k < 6; ++k) v[k] = random.normal();
  return v;
}

/// Random rows; some twice, some through rest.
std::unique_ptr<VelocityRows> random_rows(Random& random, int count) {
  auto rows = std::make_unique<VelocityRows>();
  rows->count = count;
  for (int i = 0; i < count; ++i) {
    Vec6 g = random_vector(random);
    if (i > 1 && random.uniform() < 0.25) g = gradient_of(*rows, i - 1);
    set_row(*rows, i, g, random.uniform() < 0.6 ? 0.3 * random.uniform() : 0.0);
  }
  return rows;
}

/// The nearest point by trying every set of rows, with another factorization than the solver's.
Vec6 nearest_by_trying(const Mat6& metric, const Vec6& free, const VelocityRows& rows) {
  Vec6 best = Vec6::Zero();
  double least = std::numeric_limits<double>::infinity();
  for (int set = 0; set < 1 << rows.count; ++set) {
    Eigen::MatrixXd n(6, 0);
    Eigen::VectorXd c(0);
    for (int i = 0; i < rows.count; ++i) {
      if ((set >> i & 1) == 0) continue;
      n.conservativeResize(6, n.cols() + 1);
      c.conservativeResize(c.size() + 1);
      n.rightCols<1>() = gradient_of(rows, i);
      c[c.size() - 1] = rows.limit[static_cast<std::size_t>(i)];
    }
    Vec6 u = free;
    if (n.cols() > 6) continue;
    if (n.cols() > 0) {
      const Eigen::MatrixXd by = metric.ldlt().solve(n);
      const Eigen::FullPivLU<Eigen::MatrixXd> gram(n.transpose() * by);
      if (!gram.isInvertible()) continue;
      u -= by * gram.solve(n.transpose() * free - c);
    }
    bool is_allowed = true;
    for (int i = 0; i < rows.count; ++i) {
      const double limit = rows.limit[static_cast<std::size_t>(i)];
      if (gradient_of(rows, i).dot(u) > limit + 1e-9) is_allowed = false;
    }
    const double far = (u - free).dot(metric * (u - free));
    if (is_allowed && far < least) {
      least = far;
      best = u;
    }
  }
  return best;
}

TEST(RowSolve, FindsTheNearestVelocityOfAllSetsOfRows) {
  Random random(20);
  for (int trial = 0; trial < 400; ++trial) {
    Mat6 b;
    for (Eigen::Index k = 0; k < 36; ++k) b(k / 6, k % 6) = random.normal();
    const Mat6 metric = b * b.transpose() + 0.1 * Mat6::Identity();
    const auto rows = random_rows(random, 1 + trial % 8);
    const Vec6 free = random_vector(random);
    RowImpulses impulses;
    const RowSolution found = solve_rows(metric, free, *rows, impulses);
    ASSERT_TRUE(found.is_whole) << trial;
    EXPECT_LE(found.residual, 1e-9) << trial;
    EXPECT_LE((found.velocity - nearest_by_trying(metric, free, *rows)).norm(), 1e-6) << trial;
    // u = free + A^-1 impulse
    EXPECT_LE((metric * (found.velocity - free) - found.impulse).norm(), 1e-9) << trial;
  }
}

TEST(RowSolve, IsTheSameInAnyUnits) {
  // A nanogram under nanometre rows and a tonne under kilometre rows.
  for (const double mass : {1e-12, 1.0, 1e3}) {
    for (const double size : {1e-9, 1.0, 1e3}) {
      Random random(7);
      const auto rows = random_rows(random, 7);
      Mat6 metric = mass * Mat6::Identity();
      metric.bottomRightCorner<3, 3>() *= size * size;
      for (int i = 0; i < rows->count; ++i) {
        Vec6 g = gradient_of(*rows, i);
        g.tail<3>() *= size;
        set_row(*rows, i, g, size * rows->limit[static_cast<std::size_t>(i)]);
      }
      Vec6 free = random_vector(random);
      free.head<3>() *= size;
      RowImpulses impulses;
      const RowSolution found = solve_rows(metric, free, *rows, impulses);
      Vec6 scaled = found.velocity;
      scaled.head<3>() /= size;
      free.head<3>() /= size;
      Random again(7);
      const auto plain = random_rows(again, 7);
      RowImpulses fresh;
      const RowSolution expected = solve_rows(Mat6::Identity(), free, *plain, fresh);
      EXPECT_LE((scaled - expected.velocity).norm(), 1e-9) << mass << " kg, " << size << " m";
    }
  }
}

TEST(RowSolve, StartsWarmWithTheSameAnswer) {
  Random random(3);
  const auto rows = random_rows(random, 12);
  Vec6 free = random_vector(random);
  RowImpulses warm;
  solve_rows(Mat6::Identity(), free, *rows, warm);
  free += 1e-3 * random_vector(random);
  RowImpulses cold;
  const RowSolution a = solve_rows(Mat6::Identity(), free, *rows, warm);
  const RowSolution b = solve_rows(Mat6::Identity(), free, *rows, cold);
  EXPECT_LE((a.velocity - b.velocity).norm(), 1e-12);
}

TEST(RowSolve, SaysWhenRowsContradictEachOther) {
  VelocityRows rows;
  rows.count = 2;
  set_row(rows, 0, Vec6::Unit(2), -1e-3);
  set_row(rows, 1, -Vec6::Unit(2), -1e-3);
  RowImpulses impulses;
  EXPECT_FALSE(solve_rows(Mat6::Identity(), Vec6::Zero(), rows, impulses).is_whole);
  rows.limit[0] = rows.limit[1] = 0.0;  // squeezed: slides out, does not move along
  Vec6 free = Vec6::Unit(0) + Vec6::Unit(2);
  const RowSolution squeezed = solve_rows(Mat6::Identity(), free, rows, impulses);
  EXPECT_TRUE(squeezed.is_whole);
  EXPECT_LE((squeezed.velocity - Vec6::Unit(0)).norm(), 1e-12);
}

/// A block of 1 kg on a slope: four corners press, gravity in the plane x, z.
struct Slope {
  std::unique_ptr<VelocityRows> rows = std::make_unique<VelocityRows>();
  Mat6 metric = Mat6::Identity();
  RowImpulses impulses;
  Vec6 velocity = Vec6::Zero();

  explicit Slope(double friction) : Slope(friction, friction) {}
  Slope(double friction, double at_rest) {
    metric.bottomRightCorner<3, 3>() *= 1e-3;
    for (const double x : {-0.05, 0.05}) {
      for (const double y : {-0.05, 0.05}) {
        const auto r = static_cast<std::size_t>(rows->count);
        const Vec3 arm(x, y, -0.02), normal = -Vec3::UnitZ();
        Vec6 g;
        g << normal, arm.cross(normal);
        set_row(*rows, rows->count++, g, 0.0);
        rows->friction[r] = {friction, at_rest};
        rows->arm[r] = arm;
        rows->tangent[r] = Vec3::UnitX();
      }
    }
  }

  void step(double angle, double h) {
    Vec6 free = velocity;
    free[0] += h * 9.81 * std::sin(angle);
    free[2] -= h * 9.81 * std::cos(angle);
    velocity = solve_rows(metric, free, *rows, impulses).velocity;
  }
};

TEST(RowSolve, SticksBelowTheConeAndSlidesAsCoulombSays) {
  const double friction = 0.5, h = 1e-3;
  Slope below(friction), above(friction);
  double crept = 0.0;
  for (int k = 0; k < 2000; ++k) {
    below.step(0.95 * std::atan(friction), h);
    crept += h * below.velocity.head<3>().norm();
    above.step(1.3 * std::atan(friction), h);
  }
  EXPECT_LE(crept, 1e-7);
  const double angle = 1.3 * std::atan(friction);
  const double expected = 2.0 * 9.81 * (std::sin(angle) - friction * std::cos(angle));
  EXPECT_NEAR(above.velocity[0], expected, 1e-3 * expected);
  EXPECT_LE(std::fabs(above.velocity[2]), 1e-9);
}

TEST(RowSolve, HoldsWithTheStaticAndSlidesWithTheKineticCoefficient) {
  const double kinetic = 0.3, at_rest = 0.6, h = 1e-3, g = 9.81, angle = 0.45;  // tan: 0.483
  Slope held(kinetic, at_rest), pushed(kinetic, at_rest);
  pushed.velocity[0] = 0.1;
  double crept = 0.0;
  for (int k = 0; k < 2000; ++k) {
    held.step(angle, h);
    crept += h * held.velocity.head<3>().norm();
    pushed.step(angle, h);
  }
  EXPECT_LE(crept, 1e-7);
  const double expected = 0.1 + 2.0 * g * (std::sin(angle) - kinetic * std::cos(angle));
  EXPECT_NEAR(pushed.velocity[0], expected, 1e-3 * expected);
}

TEST(RowSolve, BreaksAwayAtTheStaticForceAndSticksAgainWhereItStops) {
  const double kinetic = 0.3, at_rest = 0.6, h = 1e-3, g = 9.81;
  Slope block(kinetic, at_rest);
  const auto pull = [&](double force) {  // on 1 kg
    Vec6 free = block.velocity;
    free[0] += h * force;
    free[2] -= h * g;
    block.velocity = solve_rows(block.metric, free, *block.rows, block.impulses).velocity;
  };
  double force = 0.0;
  while (force < g && block.velocity[0] < 1e-3) pull(force += 1e-3 * g);
  EXPECT_NEAR(force, at_rest * g, 0.01 * at_rest * g);
  const double before = block.velocity[0];
  for (int k = 0; k < 100; ++k) pull(0.45 * g);  // too little to break it away
  EXPECT_NEAR(block.velocity[0] - before, 0.1 * (0.45 - kinetic) * g, 1e-3 * 0.1 * 0.15 * g);
  for (int k = 0; k < 1000; ++k) pull(0.0);
  EXPECT_LE(block.velocity.norm(), 1e-9);
  for (int k = 0; k < 100; ++k) pull(0.55 * g);
  EXPECT_LE(block.velocity.norm(), 1e-9);
}

TEST(RowSolve, FrictionNeverDrives) {
  Random random(11);
  Slope block(0.3, 0.8);
  for (int k = 0; k < 2000; ++k) {
    Vec6 free = 0.1 * random_vector(random);
    free[2] -= 0.2;
    const RowSolution with = solve_rows(block.metric, free, *block.rows, block.impulses);
    // Rows and friction together only take energy from the free motion.
    const double before = free.dot(block.metric * free);
    const double after = with.velocity.dot(block.metric * with.velocity);
    EXPECT_LE(after, before * (1.0 + 1e-9)) << k;
  }
}

TEST(RowSolve, FrictionIsTheSameInEveryDirection) {
  for (int k = 0; k < 24; ++k) {
    const double angle = 0.1 + 0.26 * k;
    Slope block(0.5);
    Vec6 free = Vec6::Zero();
    free[0] = 0.02 * std::cos(angle);
    free[1] = 0.02 * std::sin(angle);
    free[2] = -0.01;
    const Vec6 u = solve_rows(block.metric, free, *block.rows, block.impulses).velocity;
    const Vec3 pull = free.head<3>() - u.head<3>();
    EXPECT_NEAR(std::hypot(pull.x(), pull.y()), 0.5 * 0.01, 2e-5) << angle;
  }
}

/// 64 places of a flat foot that all press, pulled aside.
std::unique_ptr<VelocityRows> flat_foot() {
  auto rows = std::make_unique<VelocityRows>();
  rows->count = 64;
  for (int i = 0; i < rows->count; ++i) {
    const Vec3 arm(5e-3 * (i % 8 - 3.5), 5e-3 * (i / 8 - 3.5), -0.01), down = -Vec3::UnitZ();
    Vec6 gradient;
    gradient << down, arm.cross(down);
    set_row(*rows, i, gradient, 0.0);
    const auto r = static_cast<std::size_t>(i);
    rows->friction[r] = {0.3, 0.3};
    rows->arm[r] = arm;
    rows->tangent[r] = Vec3::UnitX();
  }
  return rows;
}

TEST(RowSolve, SixtyFourRowsWithFrictionTakeFewSweeps) {
  Mat6 metric = Mat6::Zero();
  metric.diagonal() << 0.056, 0.056, 0.056, 1.25e-5, 1.25e-5, 1.25e-5;
  const auto rows = flat_foot();
  RowImpulses impulses;
  impulses.normal.fill(1e-5);
  for (const double aside : {2e-3, 2e-2}) {  // within the cone, and beyond it
    Vec6 free = Vec6::Zero();
    free.x() = aside;
    free.z() = -0.02;
    RowSolution found;
    for (int k = 0; k < 20; ++k) {
      found = solve_rows(metric, free, *rows, impulses);
      EXPECT_LE(found.sweeps * 64, 400) << k;
    }
    ASSERT_TRUE(found.is_whole);
    EXPECT_LE(found.residual, 1e-12);
    // Coulomb's law for the foot as a whole: it holds up to 0.3 of the press.
    const double expected = std::max(aside - 0.3 * 0.02, 0.0);
    EXPECT_NEAR(found.velocity.x(), expected, 1e-4 * aside);
    EXPECT_EQ(found.slip.sticking > 0, expected == 0.0);
    EXPECT_EQ(found.slip.sliding > 0, expected > 0.0);
    const double pressed = 0.056 * 0.02;
    EXPECT_NEAR(found.slip.work, 0.3 * pressed * expected, 1e-3 * 0.3 * pressed * aside);
  }
}

}  // namespace
}  // namespace thigma
