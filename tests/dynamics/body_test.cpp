#include "thigma/dynamics/body.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

TEST(Body, vector_and_state_are_the_same_thirteen_numbers) {
  Random random(1);
  const RigidBody body = test::random_body(random);
  const BodyState state = test::random_state(random, body, random.orientation());
  const Vec13 y = to_vector(state);
  EXPECT_EQ(to_vector(from_vector(y)), y);
  EXPECT_EQ(y[3], state.orientation.x());
  EXPECT_EQ(y[6], state.orientation.w());
}

TEST(Body, velocity_is_momentum_through_the_turned_inertia) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Mat3 R = state.orientation.toRotationMatrix();
    const Twist v = velocity(body, state);
    const Vec3 L = R * body.inertia * R.transpose() * v.angular;
    EXPECT_LE((L - state.angular_momentum).norm(), 1e-12 * L.norm());
    EXPECT_LE((body.mass * v.linear - state.linear_momentum).norm(), 1e-15);
    const BodyKinematics k = kinematics(body, state);
    EXPECT_LE((k.velocity.angular - v.angular).norm(), 1e-12 * v.angular.norm());
    EXPECT_LE((k.inverse_inertia * state.angular_momentum - v.angular).norm(),
              1e-12 * v.angular.norm());
    const double energy = 0.5 * body.mass * v.linear.squaredNorm() + 0.5 * v.angular.dot(L);
    EXPECT_NEAR(kinetic_energy(body, state), energy, 1e-12 * energy);
  }
}

TEST(Body, angular_velocity_derivative_agrees_with_differences) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Mat34 numeric = finite_difference_jacobian<3, 4>(
        [&](const Vec4& q) -> Vec3 {
          BodyState moved = state;
          moved.orientation = Quat(q);
          return velocity(body, moved).angular;
        },
        Vec4(state.orientation.coeffs()), Vec4(Vec4::Constant(1e-3)));
    EXPECT_LE((kinematics(body, state).angular_velocity_by_q - numeric).norm(),
              1e-9 * (1.0 + numeric.norm()));
  }
}

// Euler's equation in the body frame is the independent form of what 5.1-5.2 say in the world
// frame.
TEST(Body, free_rotation_obeys_eulers_equation) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Vec13 rate = state_rate(body, state, {});
    const double h = 1e-4;
    const auto spin = [&](double t) -> Vec3 {
      const BodyState moved = from_vector(to_vector(state) + t * rate);
      return rotation_matrix(moved.orientation).transpose() * velocity(body, moved).angular;
    };
    const Vec3 acceleration = (spin(h) - spin(-h)) / (2.0 * h);
    const Vec3 w = spin(0.0);
    const Vec3 euler = body.inertia * acceleration + w.cross(Vec3(body.inertia * w));
    EXPECT_LE(euler.norm(), 1e-5 * (body.inertia * w).norm() * w.norm());
  }
}

TEST(Body, gravity_acts_at_the_centre_of_mass) {
  const RigidBody body = make_body(0.25, 1e-4 * Mat3::Identity(), Vec3(0.0, 0.0, -9.81));
  const Vec13 rate = state_rate(body, {}, {});
  EXPECT_EQ(rate[9], -9.81 * 0.25);
  EXPECT_EQ(rate.tail<3>(), Vec3::Zero());
}

TEST(Body, impossible_mass_properties_are_refused) {
  const Mat3 good = Vec3(1.0, 2.0, 2.5).asDiagonal();
  EXPECT_NO_THROW(make_body(1.0, good));
  EXPECT_NO_THROW(make_body(1e-60, 1e-150 * good));
  EXPECT_NO_THROW(make_body(1e60, 1e150 * good));
  EXPECT_THROW(make_body(0.0, good), InputError);
  EXPECT_THROW(make_body(-1.0, good), InputError);
  EXPECT_THROW(make_body(std::nan(""), good), InputError);
  EXPECT_THROW(make_body(1.0, -good), InputError);
  EXPECT_THROW(make_body(1.0, Mat3::Zero()), InputError);
  Mat3 skewed = good;
  skewed(0, 1) = 0.5;
  EXPECT_THROW(make_body(1.0, skewed), InputError);
  EXPECT_THROW(make_body(1.0, good, Vec3(0.0, 0.0, std::nan(""))), InputError);
}

}  // namespace
}  // namespace thigma
