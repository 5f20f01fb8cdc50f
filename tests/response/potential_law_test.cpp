// The law on its own: points of an area with depths that are linear in the motion.
#include "thigma/response/potential_law.h"

#include <cmath>
#include <vector>

#include "tests/support/jacobian.h"
#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr double kStiffness = 3000.0;
constexpr double kTolerance = 2e-4;

PotentialLaw law_of(int exponent) { return {exponent, 2e-5}; }

std::vector<AreaPoint> some_points(Random& random) {
  std::vector<AreaPoint> points;
  for (int i = 0; i < 40; ++i) {
    AreaPoint p;
    p.area = random.uniform(1e-7, 2e-6);
    p.depth = random.uniform(1e-4, 8e-4);
    p.push = random.direction();
    p.arm = random.in_cube(0.01);
    p.turn = p.arm.cross(p.push);
    points.push_back(p);
  }
  return points;
}

/// Every depth as it is after a motion, the gradients as they were.
PotentialMoments moments_after(const std::vector<AreaPoint>& points, const Vec6& motion, int p) {
  PotentialMoments m;
  for (AreaPoint point : points) {
    const double by_motion = point.push.dot(motion.head<3>()) + point.turn.dot(motion.tail<3>());
    point.depth += by_motion;
    add_point(point, p, m);
  }
  return m;
}

Vec6 both(const Wrench& w) {
  Vec6 v;
  v << w.force, w.torque;
  return v;
}

TEST(PotentialLaw, ForceAndJacobianAreDerivativesOfTheEnergy) {
  Random random(3);
  for (const int p : {2, 4}) {
    const std::vector<AreaPoint> points = some_points(random);
    const PotentialLaw law = law_of(p);
    const PotentialForce f =
        potential_force(moments_after(points, Vec6::Zero(), p), kStiffness, law);
    const Mat6 jacobian = f.jacobian;
    for (int j = 0; j < 6; ++j) {
      const double h = j < 3 ? 1e-7 : 1e-5;
      const PotentialForce more =
          potential_force(moments_after(points, h * Vec6::Unit(j), p), kStiffness, law);
      const PotentialForce less =
          potential_force(moments_after(points, -h * Vec6::Unit(j), p), kStiffness, law);
      const Vec6 force = both(f.wrench);
      EXPECT_NEAR(-(more.energy - less.energy) / (2.0 * h), force[j],
                  1e-6 * (j < 3 ? force.head<3>().norm() : force.tail<3>().norm()))
          << "p " << p << ", " << j;
      const Vec6 column = (both(more.wrench) - both(less.wrench)) / (2.0 * h);
      for (int i = 0; i < 6; ++i) {
        EXPECT_NEAR(column[i], jacobian(i, j), 1e-6 * std::sqrt(jacobian(i, i) * jacobian(j, j)))
            << "p " << p << ", " << i << " by " << j;
      }
    }
    EXPECT_LT((jacobian - jacobian.transpose()).norm(), 1e-12 * jacobian.norm());
    // Stiff or slack, never unstable.
    const Eigen::SelfAdjointEigenSolver<Mat6> values(-jacobian);
    EXPECT_GT(values.eigenvalues().minCoeff(), -1e-9 * values.eigenvalues().maxCoeff());
  }
}

TEST(PotentialLaw, ATriangleIsTheSumOfItsPoints) {
  Random random(9);
  for (const int p : {2, 4}) {
    std::vector<AreaPoint> c = some_points(random);
    PotentialMoments exact, sum;
    add_triangle(c[0], c[1], c[2], 0.5, p, exact);
    // Of so many small triangles, by their middles.
    constexpr int kSteps = 200;
    const double area = 0.25 * (c[1].arm - c[0].arm).cross(c[2].arm - c[0].arm).norm();
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < 2 * (kSteps - i) - 1; ++j) {
        const double s = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3.0) / kSteps;
        const double t = (j / 2 + (j % 2 == 0 ? 1.0 : 2.0) / 3.0) / kSteps;
        const auto mixed = [&](auto field) {
          return Vec3((1.0 - s - t) * c[0].*field + s * c[1].*field + t * c[2].*field);
        };
        AreaPoint point;
        point.area = area / (kSteps * kSteps);
        point.depth = (1.0 - s - t) * c[0].depth + s * c[1].depth + t * c[2].depth;
        point.push = mixed(&AreaPoint::push);
        point.turn = mixed(&AreaPoint::turn);
        point.arm = mixed(&AreaPoint::arm);
        add_point(point, p, sum);
      }
    }
    EXPECT_LT((exact.sum - sum.sum).norm(), 1e-4 * exact.sum.norm()) << p;
    EXPECT_LT((exact.place - sum.place).norm(), 1e-4 * exact.place.norm()) << p;
  }
}

TEST(PotentialLaw, SpringsHaveItsEnergyForceAndJacobian) {
  Random random(5);
  for (const int p : {2, 4}) {
    const std::vector<AreaPoint> points = some_points(random);
    const PotentialLaw law = law_of(p);
    const PotentialMoments moments = moments_after(points, Vec6::Zero(), p);
    const PotentialForce f = potential_force(moments, kStiffness, law);
    const RigidBody body = test::random_body(random);
    LinearContactModel model;
    model.state = test::random_state(random, body, random.orientation());
    model.state.linear_momentum.setZero();
    model.state.angular_momentum.setZero();
    const PenaltyParams penalty{.stiffness = kStiffness, .damping = 3.0, .tolerance = kTolerance};
    add_springs(moments, penalty, law, Mat3::Identity(), model.depths);
    EXPECT_EQ(model.depths.size(), 12u);

    WrenchJacobian jacobian;
    const Wrench w = contact_wrench(model, body, model.state, 1.0, &jacobian);
    EXPECT_LT((w.force - f.wrench.force).norm(), 1e-10 * f.wrench.force.norm());
    EXPECT_LT((w.torque - f.wrench.torque).norm(), 1e-10 * f.wrench.torque.norm());
    // By the way, and by the turn: dq = turn / 2 about q.
    Mat6 by_motion;
    by_motion.leftCols<3>() = jacobian.leftCols<3>();
    const Quat& q = model.state.orientation;
    for (int k = 0; k < 3; ++k) {
      const Quat dq = Quat(0.0, 0.5 * (k == 0), 0.5 * (k == 1), 0.5 * (k == 2)) * q;
      by_motion.col(3 + k) = jacobian.middleCols<4>(3) * dq.coeffs();
    }
    EXPECT_LT((by_motion - f.jacobian).norm(), 1e-9 * f.jacobian.norm());
    double energy = 0.0;
    for (const DepthTerm& t : model.depths)
      energy += 0.5 * t.stiffness * std::pow(t.depth + t.tolerance, 2);
    EXPECT_NEAR(energy, f.energy, 1e-12 * f.energy);
  }
}

TEST(PotentialLaw, ASpringModelNeverPulls) {
  Random random(7);
  const std::vector<AreaPoint> points = [&] {
    std::vector<AreaPoint> flat = some_points(random);
    for (AreaPoint& p : flat) {
      p.push = Vec3::UnitZ();
      p.turn = p.arm.cross(p.push);
    }
    return flat;
  }();
  PotentialMoments moments = moments_after(points, Vec6::Zero(), 4);
  LinearContactModel model;
  add_springs(moments, {.stiffness = kStiffness, .tolerance = kTolerance}, law_of(4),
              Mat3::Identity(), model.depths);
  const RigidBody body = make_body(0.1, Mat3(1e-5 * Mat3::Identity()));
  for (int i = 0; i < 200; ++i) {
    BodyState state = model.state;
    state.position = random.in_cube(2e-3);
    state.orientation = rotation_from_vector(random.in_cube(0.1));
    EXPECT_LE(contact_wrench(model, body, state).force.z(), 0.0);
  }
}

TEST(PotentialLaw, AreasAddUpAndASecondContactNeverLowersTheForce) {
  for (const int p : {2, 4}) {
    AreaPoint foot{.area = 1.6e-5,
                   .depth = 1e-3,
                   .push = -Vec3::UnitZ(),
                   .turn = {0.0, 0.01, 0.0},
                   .arm = {0.01, 0.0, 0.0}};
    PotentialMoments one;
    add_point(foot, p, one);
    const double alone = potential_force(one, kStiffness, law_of(p)).wrench.force.z();
    // k (A/A0)^(2/p) w
    EXPECT_NEAR(alone, kStiffness * std::pow(0.8, 2.0 / p) * 1e-3, 1e-12);
    double before = alone;
    foot.arm.x() *= -1.0;
    foot.turn.y() *= -1.0;
    for (int i = 0; i <= 10; ++i) {
      foot.depth = 1e-4 * i;
      PotentialMoments two = one;
      if (i > 0) add_point(foot, p, two);
      const double now = potential_force(two, kStiffness, law_of(p)).wrench.force.z();
      EXPECT_GE(now, before * (1.0 - 1e-12)) << "p " << p << ", foot 2 at " << foot.depth;
      before = now;
    }
    EXPECT_NEAR(before, alone * std::pow(2.0, 2.0 / p), 1e-9 * before);
  }
}

TEST(PotentialLaw, WithoutAreaThereIsNoForce) {
  LinearContactModel model;
  add_springs({}, {}, law_of(4), Mat3::Identity(), model.depths);
  EXPECT_TRUE(model.depths.empty());
  const PotentialForce f = potential_force({}, kStiffness, law_of(2));
  EXPECT_EQ(f.energy, 0.0);
  EXPECT_EQ(f.wrench.force.norm(), 0.0);
}

}  // namespace
}  // namespace thigma
