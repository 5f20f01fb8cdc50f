#include "thigma/multibody/detail/joint_rows.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

constexpr double kArm = 0.05;
constexpr JointKind kKinds[] = {JointKind::fixed, JointKind::hinge, JointKind::slider,
                                JointKind::ball, JointKind::spring};

struct Pair {
  WorldJoint joint;
  std::vector<BodyState> bodies;
  Vec6 u[2];
};

/// Two bodies anywhere, their joint near its place, moving fast.
Pair random_pair(Random& random, JointKind kind, std::int32_t b) {
  Pair pair;
  pair.bodies.resize(2);
  for (BodyState& y : pair.bodies) {
    y.position = random.in_cube(0.1);
    y.orientation = random.orientation();
  }
  pair.joint = {{.kind = kind, .a = 0, .b = b}, "j"};
  place_joint(pair.joint, joint_frame(random.in_cube(0.1), random.direction()), pair.bodies);
  for (Vec6& u : pair.u) u << random.in_cube(1.0), random.in_cube(20.0);
  if (b < 0) pair.u[1].setZero();
  // Off its place, so that no derivative is at a special point.
  pair.bodies[0].position += random.in_cube(0.01);
  pair.bodies[0].orientation =
      unit(rotation_from_vector(random.in_cube(0.3)) * pair.bodies[0].orientation);
  return pair;
}

std::vector<BodyState> moved(const Pair& pair, double dt) {
  std::vector<BodyState> bodies = pair.bodies;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 turn = dt * pair.u[i].tail<3>();
    bodies[i].position += dt * pair.u[i].head<3>();
    bodies[i].orientation = unit(unit(Quat(1.0, 0.5 * turn.x(), 0.5 * turn.y(), 0.5 * turn.z())) *
                                 bodies[i].orientation);
  }
  return bodies;
}

JointRowList rows_of(const Pair& pair, const WorldJoint& joint, double dt, bool from_begin) {
  JointPart part{joint, 0};
  part.arm = kArm;
  part.a = 0;
  part.b = joint.b < 0 ? -1 : 1;
  part.begin = joint_ends(joint, pair.bodies);
  part.end = from_begin ? part.begin : joint_ends(joint, moved(pair, dt));
  part.u_a = pair.u[0];
  part.u_b = pair.u[1];
  part.dt = dt;
  part.share = 0.5;
  JointRowList list;
  list_part_rows(part, {}, list);
  return list;
}

double speed_of(const JointRow& row, const Pair& pair) {
  return row.on_a.dot(pair.u[0]) + (row.b < 0 ? 0.0 : row.on_b.dot(pair.u[1]));
}

TEST(JointRows, GradientsAreTheDerivativesOfErrorsAndCoordinate) {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const JointKind kind = kKinds[k % 5];
    Pair pair = random_pair(random, kind, k % 2 == 0 ? 1 : -1);
    if (has_coordinate(kind)) pair.joint.stiffness = 1.0;
    const JointRowList list = rows_of(pair, pair.joint, 1e-3, true);
    constexpr double kStep = 1e-6;
    std::array<double, 6> before{}, after{};
    const JointEnds low = joint_ends(pair.joint, moved(pair, -kStep));
    const JointEnds high = joint_ends(pair.joint, moved(pair, kStep));
    const int count = joint_errors(kind, low, kArm, before);
    joint_errors(kind, high, kArm, after);
    ASSERT_EQ(list.rows.size(), static_cast<std::size_t>(count + (has_coordinate(kind) ? 1 : 0)));
    for (std::size_t r = 0; r < list.rows.size(); ++r) {
      double expected = 0.0;
      if (r < static_cast<std::size_t>(count)) {
        expected = (after[r] - before[r]) / (2.0 * kStep);
      } else {
        const double scale = kind == JointKind::hinge ? kArm : 1.0;
        expected =
            scale *
            coordinate_difference(kind, joint_coordinate(kind, high), joint_coordinate(kind, low)) /
            (2.0 * kStep);
        // An angle about b's axis is followed where both axes are one.
        if (kind == JointKind::hinge) continue;
      }
      EXPECT_NEAR(speed_of(list.rows[r], pair), expected, 1e-7 * (1.0 + std::fabs(expected)))
          << static_cast<int>(kind) << ' ' << r;
    }
  }
}

TEST(JointRows, AngleIsTheTurnAboutTheAxis) {
  Random random(2);
  for (int k = 0; k < 50; ++k) {
    Pair pair = random_pair(random, JointKind::hinge, -1);
    pair.joint.stiffness = 1.0;
    const Mat3 axes = joint_ends(pair.joint, pair.bodies).axes_b;
    // Turned about the axis alone.
    pair.bodies[0].orientation = rotation_from_vector(2.0 * random.uniform() * axes.col(2)) *
                                 Quat(axes) * pair.joint.a_from_joint.orientation.conjugate();
    pair.u[0].tail<3>() = 10.0 * axes.col(2);
    constexpr double kStep = 1e-6;
    const JointRowList list = rows_of(pair, pair.joint, kStep, true);
    const auto angle = [&](double dt) {
      return joint_coordinate(JointKind::hinge, joint_ends(pair.joint, moved(pair, dt)));
    };
    const double rate =
        coordinate_difference(JointKind::hinge, angle(kStep), angle(-kStep)) / (2.0 * kStep);
    EXPECT_NEAR(rate, 10.0, 1e-6);
    EXPECT_NEAR(speed_of(list.rows.back(), pair), kArm * rate, 1e-6 * kArm * rate);
  }
}

TEST(JointRows, ChangeOverAPartIsTheirSpeedExactly) {
  Random random(5);
  const double dt = 2e-3;  // a fifth of a turn in ten of them
  for (int k = 0; k < 200; ++k) {
    const JointKind kind = kKinds[k % 5];
    Pair pair = random_pair(random, kind, 1);
    if (kind == JointKind::slider || kind == JointKind::spring) pair.joint.stiffness = 1.0;
    const JointRowList list = rows_of(pair, pair.joint, dt, false);
    std::array<double, 6> before{}, after{};
    const JointEnds begin = joint_ends(pair.joint, pair.bodies);
    const JointEnds end = joint_ends(pair.joint, moved(pair, dt));
    const int count = joint_errors(kind, begin, kArm, before);
    joint_errors(kind, end, kArm, after);
    for (std::size_t r = 0; r < list.rows.size(); ++r) {
      const double by = r < static_cast<std::size_t>(count)
                            ? after[r] - before[r]
                            : joint_coordinate(kind, end) - joint_coordinate(kind, begin);
      EXPECT_NEAR(dt * speed_of(list.rows[r], pair), by, 1e-15) << static_cast<int>(kind);
    }
  }
}

TEST(JointRows, TakeFromOneBodyWhatTheyGiveTheOther) {
  Random random(6);
  for (int k = 0; k < 100; ++k) {
    const JointKind kind = kKinds[k % 5];
    Pair pair = random_pair(random, kind, 1);
    if (has_coordinate(kind)) pair.joint.stiffness = 1.0;
    const double dt = 1e-3;
    const std::vector<BodyState> end = moved(pair, dt);
    for (const JointRow& row : rows_of(pair, pair.joint, dt, false).rows) {
      EXPECT_LT((row.on_a.head<3>() + row.on_b.head<3>()).norm(), 1e-15);
      // About the origin, at the mean places.
      const auto turn = [&](std::size_t i, const Vec6& on) -> Vec3 {
        const Vec3 place = 0.5 * (pair.bodies[i].position + end[i].position);
        return place.cross(Vec3(on.head<3>())) + on.tail<3>();
      };
      // Where the two places lie apart the force acts along the way between them, or at one.
      Vec3 sum = turn(0, row.on_a) + turn(1, row.on_b);
      if (kind == JointKind::ball || kind == JointKind::hinge || kind == JointKind::fixed) {
        const JointEnds begin = joint_ends(pair.joint, pair.bodies);
        const JointEnds after = joint_ends(pair.joint, end);
        sum -= (0.5 * (begin.apart + after.apart)).cross(Vec3(row.on_a.head<3>()));
      }
      EXPECT_LT(sum.norm(), 1e-15);
    }
  }
}

}  // namespace
}  // namespace thigma::detail
