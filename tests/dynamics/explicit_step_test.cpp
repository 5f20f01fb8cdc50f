#include "thigma/dynamics/explicit_step.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

#include "thigma/dynamics/coupling.h"

namespace thigma {
namespace {

constexpr auto kNothing = [](const BodyState&, WrenchJacobian* J) {
  if (J) J->setZero();
  return Wrench{};
};

// Mass on a spring, k/m = 100: x = cos(10 t).
Vec3 spring_end(Integrator integrator, int steps) {
  const RigidBody body = make_body(0.5, 1e-3 * Mat3::Identity());
  BodyState y;
  y.position = Vec3(1.0, 0.0, 0.0);
  const auto spring = [](const BodyState& s, WrenchJacobian* J) {
    if (J) {
      J->setZero();
      J->topLeftCorner<3, 3>() = -50.0 * Mat3::Identity();
    }
    return Wrench{-50.0 * s.position, Vec3::Zero()};
  };
  for (int k = 0; k < steps; ++k) y = step_body(integrator, body, y, spring, 1.0 / steps);
  return y.position;
}

TEST(ExplicitStep, orders_of_the_schemes_on_the_harmonic_oscillator) {
  const double exact = std::cos(10.0);
  const auto error = [&](Integrator integrator, int steps) {
    return std::abs(spring_end(integrator, steps).x() - exact);
  };
  EXPECT_NEAR(error(Integrator::forward_euler, 20000) / error(Integrator::forward_euler, 40000),
              2.0, 0.05);
  EXPECT_NEAR(error(Integrator::runge_kutta, 200) / error(Integrator::runge_kutta, 400), 16.0, 1.0);
  EXPECT_NEAR(
      error(Integrator::implicit_tangent, 20000) / error(Integrator::implicit_tangent, 40000), 2.0,
      0.05);
}

TEST(ExplicitStep, free_rotation_keeps_momentum_and_unit_quaternion) {
  Random random(1);
  const RigidBody body = test::random_body(random);
  for (const Integrator integrator : {Integrator::forward_euler, Integrator::runge_kutta}) {
    BodyState y = test::random_state(random, body, random.orientation());
    const BodyState start = y;
    for (int k = 0; k < 1000; ++k) {
      y = step_body(integrator, body, y, kNothing, 1e-3);
      ASSERT_NEAR(y.orientation.norm(), 1.0, 4e-16);
    }
    EXPECT_EQ(y.angular_momentum, start.angular_momentum);
    const double drift = std::abs(kinetic_energy(body, y) / kinetic_energy(body, start) - 1.0);
    EXPECT_LE(drift, integrator == Integrator::runge_kutta ? 1e-10 : 0.05);
  }
}

// What Figs. 5.6 and 5.8 are about: a light body on a stiff spring, at 1 ms.
TEST(ExplicitStep, explicit_schemes_diverge_where_the_implicit_one_rests) {
  const RigidBody body = make_body(0.01, 1e-6 * Mat3::Identity());
  Coupling c;
  c.linear_stiffness = 1e5;  // h^2 k / m = 10
  c.angular_stiffness = 0.1;
  c.linear_damping = 1.0;
  c.angular_damping = 1e-3;
  const Motion hand;
  const auto forces = [&](const BodyState& y, WrenchJacobian* J) {
    return coupling_wrench(c, hand, body, y, J);
  };
  const auto distance_after = [&](Integrator integrator) {
    BodyState y;
    y.position = Vec3(1e-3, 0.0, 0.0);
    for (int k = 0; k < 200; ++k) y = step_body(integrator, body, y, forces, 1e-3);
    return y.position.norm();
  };
  EXPECT_LE(distance_after(Integrator::implicit_tangent), 1e-6);
  EXPECT_FALSE(distance_after(Integrator::forward_euler) < 1.0);
  EXPECT_FALSE(distance_after(Integrator::runge_kutta) < 1.0);
}

}  // namespace
}  // namespace thigma
