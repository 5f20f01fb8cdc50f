#include "reference/textured_point.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

// A probe `depth` metres inside the relief at this state.
TexturedPoint probe_at(Random& random, const BodyState& state, double depth) {
  TexturedPoint t;
  const Mat3 R = random.orientation().toRotationMatrix();
  t.plate = {.u = R.col(0), .v = R.col(1), .n = R.col(2)};
  t.plate.amplitude_u = 2e-4;
  t.plate.amplitude_v = 1e-4;
  t.plate.wave_u = random.uniform(500.0, 1500.0);
  t.plate.wave_v = random.uniform(500.0, 1500.0);
  t.plate.phase_u = random.uniform(0.0, 6.0);
  t.plate.phase_v = random.uniform(0.0, 6.0);
  t.arm_body = random.in_cube(0.05);
  t.stiffness = 1000.0;
  const Vec3 p = state.position + rotation_matrix(state.orientation) * t.arm_body;
  t.plate.offset = plate_depth(t.plate, p).depth - depth;
  return t;
}

TEST(TexturedPoint, exact_jacobian_agrees_with_differences) {
  Random random(1);
  const RigidBody body = test::random_body(random);
  for (int i = 0; i < 5; ++i) {
    for (const test::NamedState& at : test::states_to_try(random, body)) {
      const TexturedPoint probe = probe_at(random, at.state, 2e-3);
      test::expect_jacobian(
          [&](const BodyState& y, WrenchJacobian* J) {
            return texture_wrench(probe, y, TextureJacobian::exact, J);
          },
          body, at, 1e-4);
    }
  }
}

// dT/dtheta = -(H + T^*/2) on SO(3): a symmetric -H alone is wrong by up to a quarter.
TEST(TexturedPoint, rotational_block_has_the_half_torque_term) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    BodyState state;
    state.orientation = random.orientation();
    const TexturedPoint probe = probe_at(random, state, 1e-3);
    WrenchJacobian J;
    const Wrench w = texture_wrench(probe, state, TextureJacobian::exact, &J);
    const Mat3 by_phi = J.block<3, 4>(3, 3) * rate_matrix(state.orientation);
    const Mat3 antisymmetric = 0.5 * (by_phi - by_phi.transpose());
    EXPECT_LE((antisymmetric + 0.5 * skew(w.torque)).norm(), 1e-12 * by_phi.norm());
  }
}

TEST(TexturedPoint, gauss_newton_jacobian_is_symmetric_and_never_adds_energy) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    BodyState state;
    state.orientation = random.orientation();
    const TexturedPoint probe = probe_at(random, state, 1e-3);
    WrenchJacobian J;
    texture_wrench(probe, state, TextureJacobian::gauss_newton, &J);
    Mat6 by_motion;
    by_motion << J.leftCols<3>(), J.middleCols<4>(3) * rate_matrix(state.orientation);
    EXPECT_LE((by_motion - by_motion.transpose()).norm(), 1e-12 * by_motion.norm());
    const Vec6 move = Vec6::NullaryExpr([&] { return random.uniform(-1.0, 1.0); });
    EXPECT_LE(move.dot(by_motion * move), 1e-12 * by_motion.norm());
    EXPECT_EQ((J.rightCols<6>()), (Mat6::Zero()));
  }
}

TEST(TexturedPoint, wrench_is_minus_the_gradient_of_the_energy) {
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    BodyState state;
    state.orientation = random.orientation();
    const TexturedPoint probe = probe_at(random, state, 1e-3);
    const auto energy = [&](const Vec6& move) -> Eigen::Matrix<double, 1, 1> {
      const Vec3 x = state.position + move.head<3>();
      const Quat q = rotation_from_vector(move.tail<3>()) * state.orientation;
      const double d = plate_depth(probe.plate, x + rotation_matrix(q) * probe.arm_body).depth;
      return Eigen::Matrix<double, 1, 1>(0.5 * probe.stiffness * d * d);
    };
    const Eigen::Matrix<double, 1, 6> slope =
        finite_difference_jacobian<1, 6>(energy, Vec6(Vec6::Zero()), Vec6(Vec6::Constant(1e-5)));
    const Wrench w = texture_wrench(probe, state);
    Vec6 wrench;
    wrench << w.force, w.torque;
    EXPECT_LE((wrench + slope.transpose()).norm(), 1e-6 * wrench.norm());
  }
}

TEST(TexturedPoint, eleven_evaluations_agree_with_the_closed_form) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    BodyState state;
    state.orientation = random.orientation();
    const TexturedPoint probe = probe_at(random, state, 1e-3);
    Mat3 basis;
    basis << probe.plate.u.transpose(), probe.plate.v.transpose(), probe.plate.n.transpose();
    int evaluations = 0;
    const auto depth = [&](const Pose& pose) {
      ++evaluations;
      return plate_depth(probe.plate, transform_point(pose, probe.arm_body)).depth;
    };
    const double step = 1e-6;
    const Wrench w = texture_wrench_by_differences(depth, probe.stiffness, basis, state, step,
                                                   step / probe.arm_body.norm());
    const Wrench exact = texture_wrench(probe, state);
    EXPECT_EQ(evaluations, 11);
    EXPECT_LE((w.force - exact.force).norm(), 1e-5 * exact.force.norm());
    EXPECT_LE((w.torque - exact.torque).norm(), 1e-5 * exact.torque.norm());
  }
}

TEST(TexturedPoint, taylor_term_is_the_wrench_at_its_state_and_nothing_outside) {
  Random random(6);
  BodyState state;
  state.orientation = random.orientation();
  const TexturedPoint probe = probe_at(random, state, 1e-3);
  const TaylorTerm term = texture_term(probe, state);
  EXPECT_EQ(extrapolate(term, state, state).force, texture_wrench(probe, state).force);
  EXPECT_LT(term.wrench.force.dot(term.normal), 0.0);
  const TexturedPoint outside = probe_at(random, state, -1e-6);
  EXPECT_EQ(texture_wrench(outside, state).force, Vec3::Zero());
  EXPECT_EQ(texture_term(outside, state).jacobian, WrenchJacobian::Zero());
}

}  // namespace
}  // namespace thigma
