#include "thigma/dynamics/implicit_step.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

#include "thigma/dynamics/coupling.h"
#include "thigma/dynamics/explicit_step.h"
#include "thigma/dynamics/linear_contact_model.h"

namespace thigma {
namespace {

Coupling soft_coupling(Random& random) {
  return {.linear_stiffness = 300.0,
          .linear_damping = 0.5,
          .angular_stiffness = 0.3,
          .angular_damping = 1e-3,
          .body_from_grasp = {random.in_cube(0.05), random.orientation()},
          .is_grasped = true,
          .linear_saturation = {},
          .angular_saturation = {}};
}

struct Forces {
  Wrench wrench;
  WrenchJacobian jacobian = WrenchJacobian::Zero();
};

Forces coupled(const Coupling& c, const Motion& hand, const RigidBody& body, const BodyState& y) {
  Forces f;
  f.wrench = coupling_wrench(c, hand, body, y, &f.jacobian);
  return f;
}

BodyState advance(const Coupling& c, const Motion& hand, const RigidBody& body,
                  const BodyState& y) {
  const Forces f = coupled(c, hand, body, y);
  return implicit_step(body, y, f.wrench, f.jacobian, 1e-3);
}

double distance(const BodyState& a, const BodyState& b) {
  return (to_vector(a) - to_vector(b)).norm();
}

TEST(ImplicitStep, six_unknowns_give_what_thirteen_give) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const RigidBody body = test::random_body(random, Vec3(0.0, 0.0, -9.81));
    const BodyState state = test::random_state(random, body, random.orientation());
    const Coupling c = soft_coupling(random);
    Motion hand{Pose{state.position, state.orientation} * c.body_from_grasp, {}};
    hand.pose.position += 5e-3 * random.direction();
    hand.pose.orientation = rotation_from_vector(random.direction()) * hand.pose.orientation;
    hand.twist = {random.in_cube(0.1), random.in_cube(1.0)};
    const Forces f = coupled(c, hand, body, state);
    for (const double h : {1e-4, 1e-3, 1e-2}) {
      const BodyState six = implicit_step_6(body, state, f.wrench, f.jacobian, h);
      const BodyState thirteen = implicit_step_13(body, state, f.wrench, f.jacobian, h);
      EXPECT_LE(distance(six, thirteen), 1e-11 * to_vector(thirteen).norm()) << h;
    }
  }
}

// The tangent form differs from Eq. 5.7 only by the radial quaternion mode, a term of second order
// in h.
TEST(ImplicitStep, tangent_form_approaches_the_thirteen_with_the_square_of_the_step) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Coupling c = soft_coupling(random);
    Motion hand{Pose{state.position, state.orientation} * c.body_from_grasp, {}};
    hand.pose.position += Vec3(1e-3, 0.0, 0.0);
    const Forces f = coupled(c, hand, body, state);
    const auto gap = [&](double h) {
      return distance(implicit_step(body, state, f.wrench, f.jacobian, h),
                      implicit_step_13(body, state, f.wrench, f.jacobian, h));
    };
    EXPECT_LE(gap(1e-3), 1e-4);
    EXPECT_LE(gap(1e-4), 0.02 * gap(1e-3) + 1e-13);
  }
}

// Without forces only the map from rotation vector to quaternion differs: third order in the step.
TEST(ImplicitStep, tangent_form_turns_freely_as_the_thirteen_to_third_order) {
  Random random(10);
  for (int i = 0; i < 20; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    state.angular_momentum = body.inertia.trace() / 3.0 * 20.0 * random.direction();
    const auto gap = [&](double h) {
      const WrenchJacobian none = WrenchJacobian::Zero();
      return distance(implicit_step(body, state, {}, none, h),
                      implicit_step_13(body, state, {}, none, h));
    };
    EXPECT_LE(gap(1e-4), 2e-3 * gap(1e-3));
  }
}

// A rod spinning about its middle axis: without the half spin in the derivative of the rotation
// rate the system becomes singular at about a radian a step.
TEST(ImplicitStep, stays_regular_at_any_spin) {
  const RigidBody body = make_body(0.01, 1e-7 * Mat3(Vec3(1.0, 38.0, 39.0).asDiagonal()));
  const double h = 5e-3;
  for (double spin = 1.0; spin < 400.0; spin += 0.1) {
    BodyState y;
    y.angular_momentum = body.inertia * (spin * Vec3(0.02, 1.0, 0.02));
    const double turn = spin * h;
    const BodyState next = implicit_step(body, y, {}, WrenchJacobian::Zero(), h);
    const double turned = vector_from_rotation(next.orientation).norm();
    EXPECT_NEAR(turned, turn, 0.05 * turn) << spin;
  }
}

TEST(ImplicitStep, state_rate_jacobian_agrees_with_differences) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const Coupling c = soft_coupling(random);
    const Motion hand{{random.in_cube(0.1), state.orientation * c.body_from_grasp.orientation}, {}};
    Vec13 steps;
    steps << Vec3::Constant(1e-4), Vec4::Constant(1e-3), Vec3::Constant(1e-3 * body.mass),
        Vec3::Constant(1e-2 * body.inertia.trace());
    const Mat13 numeric = finite_difference_jacobian<13, 13>(
        [&](const Vec13& y) -> Vec13 {
          const BodyState moved = from_vector(y);
          return state_rate(body, moved, coupling_wrench(c, hand, body, moved));
        },
        to_vector(state), steps);
    const Mat13 analytic = state_rate_jacobian(body, state, coupled(c, hand, body, state).jacobian);
    for (int column = 0; column < 13; ++column) {
      const double size = numeric.col(column).norm();
      EXPECT_LE((analytic.col(column) - numeric.col(column)).norm(), 1e-7 * size) << column;
    }
  }
}

TEST(ImplicitStep, free_rotation_keeps_momentum_exactly_and_loses_little_energy) {
  Random random(4);
  for (int i = 0; i < 10; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState start = test::random_state(random, body, random.orientation());
    start.angular_momentum = body.inertia.trace() / 3.0 * 5.0 * random.direction();
    const double energy = kinetic_energy(body, start);
    const auto loss = [&](int steps) {
      BodyState y = start;
      for (int k = 0; k < steps; ++k) {
        y = implicit_step(body, y, {}, WrenchJacobian::Zero(), 1.0 / steps);
        EXPECT_EQ(y.angular_momentum, start.angular_momentum);
        EXPECT_EQ(y.linear_momentum, start.linear_momentum);
        EXPECT_NEAR(y.orientation.norm(), 1.0, 4e-16);
        EXPECT_LE(kinetic_energy(body, y), energy * (1.0 + 1e-9));
      }
      return energy - kinetic_energy(body, y);
    };
    const double coarse = loss(1000);
    EXPECT_LE(coarse, 0.02 * energy);
    EXPECT_NEAR(coarse / loss(2000), 2.0, 0.1);  // first order
  }
}

// First order: halving the step halves the distance to a reference of tiny steps.
TEST(ImplicitStep, error_is_of_first_order_in_the_step) {
  Random random(5);
  const RigidBody body = test::random_body(random, Vec3(0.0, 0.0, -9.81));
  const BodyState start = test::random_state(random, body, random.orientation());
  const Coupling c = soft_coupling(random);
  const Motion hand{Pose{start.position, start.orientation} * c.body_from_grasp, {}};
  const auto forces = [&](const BodyState& y, WrenchJacobian* J) {
    return coupling_wrench(c, hand, body, y, J);
  };
  const auto run = [&](Integrator integrator, int steps) {
    BodyState y = start;
    for (int k = 0; k < steps; ++k) y = step_body(integrator, body, y, forces, 0.02 / steps);
    return y;
  };
  const BodyState exact = run(Integrator::runge_kutta, 20000);
  for (const Integrator integrator :
       {Integrator::implicit_tangent, Integrator::implicit_6, Integrator::implicit_13}) {
    const double coarse = distance(run(integrator, 400), exact);
    const double fine = distance(run(integrator, 800), exact);
    EXPECT_NEAR(coarse / fine, 2.0, 0.1);
  }
}

// A stiff contact under gravity with a coupling: springs and dampers only, so what the body can
// give back never grows.
TEST(ImplicitStep, energy_of_a_damped_system_never_grows) {
  Random random(6);
  for (int i = 0; i < 10; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState y = test::random_state(random, body, random.orientation());
    Coupling c = soft_coupling(random);
    grasp(c, y, {y.position + random.in_cube(0.05), random.orientation()});
    Motion hand{Pose{y.position, y.orientation} * c.body_from_grasp, {}};
    hand.pose.position += 0.01 * random.direction();
    hand.pose.orientation = rotation_from_vector(0.5 * random.direction()) * hand.pose.orientation;
    PlaneTerm wall;
    wall.arm_body = random.in_cube(0.03);
    wall.normal = random.direction();
    wall.scene_point = y.position + y.orientation * wall.arm_body;
    wall.stiffness = 20000.0;
    wall.damping = 1.0;
    LinearContactModel model;
    model.planes.push_back(wall);
    const auto energy = [&] {
      const CouplingStretch s = coupling_stretch(c, hand.pose, y);
      const double depth = std::max(0.0, plane_force(wall, at_state(body, y)).depth);
      return kinetic_energy(body, y) + 0.5 * c.linear_stiffness * s.linear.squaredNorm() +
             0.5 * c.angular_stiffness * s.angular.squaredNorm() +
             0.5 * wall.stiffness * depth * depth;
    };
    const double start = energy();
    double last = start;
    for (int k = 0; k < 4000; ++k) {
      Forces f = coupled(c, hand, body, y);
      WrenchJacobian contact;
      f.wrench = f.wrench + contact_wrench(model, body, y, 1.0, &contact);
      f.jacobian += contact;
      y = implicit_step(body, y, f.wrench, f.jacobian, 1e-3);
      const double now = energy();
      // Linearising a unilateral contact once a step lets a step across the surface gain a little,
      // never more.
      ASSERT_LE(now, last + 0.02 * start) << i << ' ' << k;
      last = now;
    }
    EXPECT_LE(kinetic_energy(body, y), 1e-6 * start);
  }
}

TEST(ImplicitStep, holds_a_stiff_contact_at_any_step_length) {
  const RigidBody body = make_body(0.01, 1e-6 * Mat3::Identity(), Vec3(0.0, 0.0, -9.81));
  LinearContactModel model;
  PlaneTerm floor;
  floor.normal = Vec3(0.0, 0.0, -1.0);
  floor.stiffness = 1e6;
  floor.damping = 10.0;
  model.planes.push_back(floor);
  for (const double h : {1e-5, 1e-3, 1e-2}) {
    BodyState y;
    y.position.z() = -1e-6;
    for (int k = 0; k < 5000; ++k) {
      Forces f;
      f.wrench = contact_wrench(model, body, y, 1.0, &f.jacobian);
      y = implicit_step(body, y, f.wrench, f.jacobian, h);
    }
    EXPECT_NEAR(y.position.z(), -0.01 * 9.81 / 1e6, 1e-9) << h;
    EXPECT_LE(y.linear_momentum.norm(), 1e-8) << h;
  }
}

TEST(ImplicitStep, works_for_a_nanometre_part_and_a_kilometre_part) {
  Random random(9);
  for (const double size : {1e-9, 1.0, 1e3}) {
    const double mass = 1000.0 * size * size * size;
    const RigidBody body =
        make_body(mass, mass * size * size * Mat3(Vec3(0.2, 0.3, 0.4).asDiagonal()));
    BodyState y;
    Coupling c = soft_coupling(random);
    c.linear_stiffness = mass * 1e4;  // 16 Hz
    c.linear_damping = mass * 1e2;
    c.angular_stiffness = mass * size * size * 1e4;
    c.angular_damping = mass * size * size * 1e2;
    Motion hand{{size * random.in_cube(1.0), random.orientation()}, {}};
    grasp(c, y, hand.pose);
    hand.pose.position += size * Vec3(0.5, 0.2, 0.1);
    for (int k = 0; k < 3000; ++k) y = advance(c, hand, body, y);
    const CouplingStretch s = coupling_stretch(c, hand.pose, y);
    EXPECT_LE(s.linear.norm(), 1e-6 * size) << size;
    EXPECT_LE(s.angular.norm(), 1e-6) << size;
  }
}

TEST(ImplicitStep, not_a_number_in_shows_in_the_state) {
  Forces f;
  f.wrench.force.x() = std::nan("");
  const BodyState y =
      implicit_step(make_body(1.0, Mat3::Identity()), {}, f.wrench, f.jacobian, 1e-3);
  EXPECT_FALSE(to_vector(y).allFinite());
}

}  // namespace
}  // namespace thigma
