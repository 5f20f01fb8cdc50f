#include "thigma/dynamics/coupling.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

Coupling any_coupling(Random& random, bool saturating) {
  Coupling c;
  c.linear_stiffness = random.uniform(100.0, 500.0);
  c.linear_damping = random.uniform(0.1, 2.0);
  c.angular_stiffness = random.uniform(0.1, 1.0);
  c.angular_damping = random.uniform(1e-4, 1e-2);
  c.body_from_grasp = {random.in_cube(0.1), random.orientation()};
  if (saturating) {
    c.linear_saturation =
        make_saturation(c.linear_stiffness, 2e-3, 3.0 + 2e-3 * c.linear_stiffness);
    c.angular_saturation =
        make_saturation(c.angular_stiffness, 0.05, 0.1 + 0.05 * c.angular_stiffness);
  }
  return c;
}

// A hand whose handle is `stretch` metres and `turn` radians away from where the body's grasp frame
// is.
Motion hand_near(Random& random, const Coupling& c, const BodyState& state, double stretch,
                 double turn) {
  Motion device;
  device.pose = Pose{state.position, state.orientation} * c.body_from_grasp;
  device.pose.position += stretch * random.direction();
  device.pose.orientation =
      rotation_from_vector(turn * random.direction()) * device.pose.orientation;
  device.twist = {random.in_cube(0.1), random.in_cube(1.0)};
  return device;
}

TEST(Coupling, jacobian_agrees_with_differences) {
  Random random(1);
  for (const bool saturating : {false, true}) {
    for (const double turn : {0.0, 1e-8, 1e-3, 0.04, 0.3, 2.0, kPi - 0.02}) {
      const RigidBody body = test::random_body(random);
      for (const test::NamedState& at : test::states_to_try(random, body)) {
        const Coupling c = any_coupling(random, saturating);
        const double stretch = random.below(2) ? 1e-3 : 8e-3;
        const Motion device = hand_near(random, c, at.state, stretch, turn);
        test::expect_jacobian(
            [&](const BodyState& y, WrenchJacobian* J) {
              return coupling_wrench(c, device, body, y, J);
            },
            body, at, 1e-6);
      }
    }
  }
}

// The test that a wrong rotation vector fails: printed Eq. 5.18 has slope zero at rest.
TEST(Coupling, torque_slope_at_alignment_is_the_angular_stiffness) {
  Random random(2);
  const RigidBody body = test::random_body(random);
  BodyState state = test::random_state(random, body, random.orientation());
  state.linear_momentum.setZero();
  state.angular_momentum.setZero();
  Coupling c = any_coupling(random, false);
  for (double turn = 1.0; turn > 1e-12; turn *= 0.1) {
    Motion device{Pose{state.position, state.orientation} * c.body_from_grasp, {}};
    const Vec3 axis = random.direction();
    device.pose.orientation = rotation_from_vector(turn * axis) * device.pose.orientation;
    const Wrench w = coupling_wrench(c, device, body, state);
    EXPECT_LE((w.torque - c.angular_stiffness * turn * axis).norm(),
              1e-3 * c.angular_stiffness * turn + 1e-13)
        << turn;
    EXPECT_LE((coupling_reaction(c, device, body, state).torque + w.torque).norm(), 1e-13);
  }
}

// The test that `omega x c` with c in the body frame fails.
TEST(Coupling, no_damping_force_when_the_body_spins_about_a_resting_grasp_point) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    Coupling c = any_coupling(random, false);
    c.linear_stiffness = 0.0;
    const Twist v = velocity(body, state);
    const Vec3 arm = state.orientation * c.body_from_grasp.position;
    state.linear_momentum = -body.mass * v.angular.cross(arm);
    Motion device = hand_near(random, c, state, 0.0, 0.0);
    device.twist = {Vec3::Zero(), v.angular};
    const double scale = c.linear_damping * v.angular.norm() * arm.norm();
    EXPECT_LE(coupling_wrench(c, device, body, state).force.norm(), 1e-13 * scale);
  }
}

TEST(Coupling, grasping_anywhere_starts_without_force) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    state.linear_momentum.setZero();
    state.angular_momentum.setZero();
    Coupling c = any_coupling(random, i % 2 == 0);
    const Motion device{{random.in_cube(0.3), random.orientation()}, {}};
    grasp(c, state, device.pose);
    const Wrench w = coupling_wrench(c, device, body, state);
    EXPECT_LE(w.force.norm(), 1e-12 * c.linear_stiffness);
    EXPECT_LE(w.torque.norm(), 1e-12 * (c.angular_stiffness + c.linear_stiffness));
  }
}

TEST(Coupling, released_coupling_gives_nothing_and_a_new_grasp_starts_at_rest) {
  Random random(5);
  const RigidBody body = test::random_body(random);
  BodyState state = test::random_state(random, body, random.orientation());
  Coupling c = any_coupling(random, true);
  Motion device = hand_near(random, c, state, 0.01, 0.2);
  EXPECT_GT(coupling_wrench(c, device, body, state).force.norm(), 0.0);
  release(c);
  WrenchJacobian J = WrenchJacobian::Ones();
  EXPECT_EQ(coupling_wrench(c, device, body, state, &J).force, Vec3::Zero());
  EXPECT_EQ(J, WrenchJacobian::Zero());
  EXPECT_EQ(coupling_reaction(c, device, body, state).torque, Vec3::Zero());
  state.linear_momentum.setZero();
  state.angular_momentum.setZero();
  device.twist = {};
  grasp(c, state, device.pose);
  EXPECT_LE(coupling_wrench(c, device, body, state).force.norm(), 1e-10);
}

TEST(Coupling, hand_gets_the_reaction_about_the_handle) {
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Coupling c = any_coupling(random, i % 2 == 0);
    const Motion device = hand_near(random, c, state, 5e-3, 0.2);
    const Wrench on_body = coupling_wrench(c, device, body, state);
    const Wrench on_hand = coupling_reaction(c, device, body, state);
    const Vec3 arm = state.orientation * c.body_from_grasp.position;
    EXPECT_LE((on_hand.force + on_body.force).norm(), 1e-14 * on_body.force.norm());
    EXPECT_LE((on_hand.torque + on_body.torque - arm.cross(on_body.force)).norm(), 1e-13);
  }
}

// d/dt (energy of both springs) = power in at hand and body - what the dampers take, which is never
// negative.
TEST(Coupling, dampers_take_power_and_springs_store_the_rest) {
  Random random(7);
  for (int i = 0; i < 300; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Coupling c = any_coupling(random, false);
    const Motion device = hand_near(random, c, state, 0.01, 1.0);
    const Twist v = velocity(body, state);
    const auto energy = [&](double t) {
      BodyState y = state;
      y.position += t * v.linear;
      y.orientation = rotation_from_vector(t * v.angular) * state.orientation;
      Pose hand = device.pose;
      hand.position += t * device.twist.linear;
      hand.orientation = rotation_from_vector(t * device.twist.angular) * hand.orientation;
      const CouplingStretch s = coupling_stretch(c, hand, y);
      return 0.5 * c.linear_stiffness * s.linear.squaredNorm() +
             0.5 * c.angular_stiffness * s.angular.squaredNorm();
    };
    const double h = 1e-4;
    const double stored =
        (8.0 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12.0 * h);
    const Wrench body_wrench = coupling_wrench(c, device, body, state);
    const Wrench hand_wrench = coupling_reaction(c, device, body, state);
    const double to_body = body_wrench.force.dot(v.linear) + body_wrench.torque.dot(v.angular);
    const double to_hand =
        hand_wrench.force.dot(device.twist.linear) + hand_wrench.torque.dot(device.twist.angular);
    const double lost = -(to_body + to_hand) - stored;
    const Vec3 arm = state.orientation * c.body_from_grasp.position;
    const Vec3 dv = device.twist.linear - v.linear - v.angular.cross(arm);
    const Vec3 dw = device.twist.angular - v.angular;
    const double want = c.linear_damping * dv.squaredNorm() + c.angular_damping * dw.squaredNorm();
    EXPECT_NEAR(lost, want, 1e-7 * (want + std::abs(stored)));
  }
}

TEST(Coupling, saturation_is_smooth_monotone_and_keeps_its_limit) {
  Random random(8);
  for (int i = 0; i < 20; ++i) {
    const double k = random.uniform(50.0, 2000.0);
    const double x1 = random.uniform(0.0, 5e-3);
    const double limit = k * x1 + random.uniform(0.5, 5.0);
    const Saturation s = make_saturation(k, x1, limit);
    EXPECT_TRUE(is_monotone(s));
    double last = 0.0;
    for (double r = 0.0; r < 2.0 * s.full_range; r += s.full_range / 500.0) {
      const SpringForce f = spring_force(s, r);
      EXPECT_GE(f.force, last - 1e-12 * limit);
      EXPECT_LE(f.force, limit * (1.0 + 1e-14));
      EXPECT_GE(f.slope, -1e-9 * k);
      EXPECT_LE(f.slope, k * (1.0 + 1e-12));
      last = f.force;
    }
    for (const double joint : {s.linear_range, s.full_range}) {
      const double e = 1e-9 * s.full_range;
      EXPECT_NEAR(spring_force(s, joint - e).force, spring_force(s, joint + e).force, 4.0 * k * e);
      EXPECT_NEAR(spring_force(s, joint - e).slope, spring_force(s, joint + e).slope, 1e-6 * k);
    }
    EXPECT_LE(spring_force(s, Vec3(100.0 * random.direction())).force.norm(),
              limit * (1.0 + 1e-14));
    EXPECT_EQ(spring_force(s, Vec3(Vec3::Zero())).force, Vec3::Zero());
  }
  EXPECT_FALSE(is_monotone(
      {.stiffness = 100.0, .linear_range = 0.01, .full_range = 0.05, .max_force = 2.0}));
  EXPECT_THROW(make_saturation(0.0, 0.1, 1.0), InputError);
  EXPECT_THROW(make_saturation(100.0, 0.1, 5.0), InputError);
  EXPECT_THROW(make_saturation(100.0, -0.1, 5.0), InputError);
}

TEST(Coupling, FadedSpringsPullLessByTheWeightAndDampersStay) {
  Random random(31);
  for (const bool saturating : {false, true}) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::states_to_try(random, body).front().state;
    const Coupling c = any_coupling(random, saturating);
    Motion still = hand_near(random, c, state, 4e-3, 0.1);
    still.twist = Twist{};
    BodyState at_rest = state;
    at_rest.linear_momentum.setZero();
    at_rest.angular_momentum.setZero();
    const Wrench whole = coupling_reaction(c, still, body, at_rest);
    for (const double weight : {1.0, 0.3, 0.0}) {
      const Wrench part = coupling_reaction(faded(c, weight), still, body, at_rest);
      EXPECT_LE((part.force - weight * whole.force).norm(), 1e-12 * whole.force.norm());
      EXPECT_LE((part.torque - weight * whole.torque).norm(), 1e-12 * whole.torque.norm());
    }
    const Wrench same = coupling_reaction(faded(c, 1.0), still, body, at_rest);
    EXPECT_EQ(same.force, whole.force);
    EXPECT_EQ(same.torque, whole.torque);
    EXPECT_EQ(faded(c, 0.0).linear_damping, c.linear_damping);
    EXPECT_EQ(faded(c, 0.0).angular_damping, c.angular_damping);
  }
}

}  // namespace
}  // namespace thigma
