#include "thigma/dynamics/linear_contact_model.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

// A plane term that is `depth` metres inside at this state.
PlaneTerm plane_at(Random& random, const BodyState& state, double depth) {
  PlaneTerm t;
  t.arm_body = random.in_cube(0.05);
  t.normal = random.direction();
  t.scene_point =
      state.position + rotation_matrix(state.orientation) * t.arm_body - depth * t.normal;
  t.stiffness = random.uniform(500.0, 5000.0);
  t.damping = random.uniform(0.0, 5.0);
  t.tolerance = 1e-3;
  return t;
}

Wrench wrench_of(const PlaneTerm& term, const RigidBody& body, const BodyState& y,
                 WrenchJacobian* J) {
  LinearContactModel model;
  model.planes.push_back(term);
  return contact_wrench(model, body, y, 1.0, J);
}

TEST(LinearContactModel, plane_jacobian_agrees_with_differences) {
  Random random(1);
  for (int i = 0; i < 5; ++i) {
    const RigidBody body = test::random_body(random);
    for (const test::NamedState& at : test::states_to_try(random, body)) {
      PlaneTerm term = plane_at(random, at.state, 2e-3);
      term.scene_velocity = random.in_cube(0.1);
      term.tolerance = 10e-3;  // far from the clamp's kink
      test::expect_jacobian(
          [&](const BodyState& y, WrenchJacobian* J) { return wrench_of(term, body, y, J); }, body,
          at, 1e-7);
    }
  }
}

TEST(LinearContactModel, several_terms_add_and_fading_scales_wrench_and_jacobian) {
  Random random(2);
  const RigidBody body = test::random_body(random);
  const test::NamedState at{"random", test::random_state(random, body, random.orientation())};
  LinearContactModel model;
  Wrench sum;
  for (int i = 0; i < 5; ++i) {
    PlaneTerm term = plane_at(random, at.state, 5e-3);
    term.damping = 0.0;
    model.planes.push_back(term);
    sum = sum + wrench_of(term, body, at.state, nullptr);
  }
  const Wrench full = contact_wrench(model, body, at.state);
  EXPECT_LE((full.force - sum.force).norm() + (full.torque - sum.torque).norm(), 1e-12);
  for (const double scale : {0.0, 0.25, 1.0}) {
    test::expect_jacobian(
        [&](const BodyState& y, WrenchJacobian* J) {
          return contact_wrench(model, body, y, scale, J);
        },
        body, at, 1e-7);
    EXPECT_LE((contact_wrench(model, body, at.state, scale).force - scale * full.force).norm(),
              1e-13);
  }
}

TEST(LinearContactModel, force_starts_at_the_tolerance_and_is_stiffness_times_tolerance_at_touch) {
  Random random(3);
  const RigidBody body = test::random_body(random);
  BodyState state = test::random_state(random, body, random.orientation());
  state.linear_momentum.setZero();
  state.angular_momentum.setZero();
  for (const double depth : {-2e-3, -1e-3 - 1e-9, -0.5e-3, 0.0, 1e-3}) {
    const PlaneTerm term = plane_at(random, state, depth);
    const Wrench w = wrench_of(term, body, state, nullptr);
    const double want = std::max(0.0, term.stiffness * (depth + term.tolerance));
    EXPECT_LE((w.force + want * term.normal).norm(), 1e-9) << depth;
    const Vec3 arm = rotation_matrix(state.orientation) * term.arm_body;
    EXPECT_LE((w.torque - arm.cross(w.force)).norm(), 1e-12);
  }
}

TEST(LinearContactModel, contact_never_pulls_whatever_the_motion) {
  Random random(4);
  int active = 0;
  for (int i = 0; i < 5000; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    state.linear_momentum *= 20.0;
    state.angular_momentum *= 20.0;
    PlaneTerm term = plane_at(random, state, random.uniform(-3e-3, 3e-3));
    term.scene_velocity = random.in_cube(1.0);
    const Wrench w = wrench_of(term, body, state, nullptr);
    EXPECT_LE(w.force.dot(term.normal), 0.0);
    active += w.force.squaredNorm() > 0.0;
  }
  EXPECT_GT(active, 1000);
}

// The test that `omega x r` with r in the body frame fails.
TEST(LinearContactModel, no_damping_when_the_body_turns_about_a_resting_contact_point) {
  Random random(5);
  for (int i = 0; i < 100; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    PlaneTerm term = plane_at(random, state, 1e-3);
    const Vec3 arm = rotation_matrix(state.orientation) * term.arm_body;
    state.linear_momentum = -body.mass * velocity(body, state).angular.cross(arm);
    term.damping = 100.0;
    const PlaneForce f = plane_force(term, at_state(body, state));
    EXPECT_NEAR(f.magnitude, term.stiffness * 2e-3, 1e-11 * term.stiffness);
    // a contact that moves with the body's point is at rest too
    BodyState carried = state;
    term.scene_velocity = Vec3(0.3, -0.2, 0.5);
    carried.linear_momentum += body.mass * term.scene_velocity;
    EXPECT_NEAR(plane_force(term, at_state(body, carried)).magnitude, f.magnitude, 1e-11);
  }
}

TEST(LinearContactModel, power_of_a_contact_is_minus_stored_minus_lost) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    PlaneTerm term = plane_at(random, state, 1e-3);
    const BodyAtState here = at_state(body, state);
    const BodyKinematics& at = here.kinematics;
    const PlaneForce f = plane_force(term, here);
    if (!f.is_active) continue;
    const double power =
        f.wrench.force.dot(at.velocity.linear) + f.wrench.torque.dot(at.velocity.angular);
    const Vec3 arm = at.rotation * term.arm_body;
    const double rate = term.normal.dot(at.velocity.linear + at.velocity.angular.cross(arm));
    const double stored = term.stiffness * (f.depth + term.tolerance) * rate;
    EXPECT_NEAR(power, -stored - term.damping * rate * rate, 1e-12);
  }
}

DepthTerm any_depth(Random& random) {
  DepthTerm t;
  t.depth = random.uniform(0.0, 1e-3);
  t.linear = random.direction() + random.in_cube(0.3);
  t.angular = random.in_cube(0.05);
  t.stiffness = 2000.0;
  t.damping = random.uniform(0.0, 20.0);
  t.tolerance = 1e-3;
  return t;
}

TEST(LinearContactModel, depth_term_jacobian_is_its_derivative) {
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const RigidBody body = test::random_body(random);
    const test::NamedState at{"random", test::random_state(random, body, random.orientation())};
    LinearContactModel model;
    model.state = at.state;
    model.state.position += random.in_cube(1e-4);
    model.state.orientation = rotation_from_vector(random.in_cube(1e-2)) * model.state.orientation;
    if (i % 2 == 1) model.state.orientation.coeffs() *= -1.0;
    for (int k = 0; k < 3; ++k) {
      model.depths.push_back(any_depth(random));
      model.depths[static_cast<std::size_t>(k)].depth += 3e-3;  // far from the clamp's kink
    }
    ASSERT_GT(contact_wrench(model, body, at.state).force.norm(), 0.0);
    test::expect_jacobian([&](const BodyState& y,
                              WrenchJacobian* J) { return contact_wrench(model, body, y, 0.7, J); },
                          body, at, 1e-7);
  }
}

TEST(LinearContactModel, depth_term_of_a_plane_is_the_plane) {
  // The depth of a point over a plane has the gradient (n, Rr x n): one step further both agree to
  // second order.
  Random random(12);
  for (int i = 0; i < 100; ++i) {
    const RigidBody body = test::random_body(random);
    LinearContactModel planes, depths;
    planes.state = depths.state = test::random_state(random, body, random.orientation());
    const PlaneTerm plane = plane_at(random, planes.state, random.uniform(0.0, 1e-3));
    const BodyAtState here = at_state(body, planes.state);
    const Vec3 arm = here.kinematics.rotation * plane.arm_body;
    DepthTerm depth;
    depth.depth = plane_force(plane, here).depth;
    depth.linear = plane.normal;
    depth.angular = arm.cross(plane.normal);
    depth.stiffness = plane.stiffness;
    depth.damping = plane.damping;
    depth.tolerance = plane.tolerance;
    planes.planes.push_back(plane);
    depths.depths.push_back(depth);
    const Wrench a = contact_wrench(planes, body, planes.state),
                 b = contact_wrench(depths, body, planes.state);
    EXPECT_LE((a.force - b.force).norm(), 1e-12 * (1.0 + a.force.norm()));
    EXPECT_LE((a.torque - b.torque).norm(), 1e-12 * (1.0 + a.force.norm()));
    const double angle = 1e-4;
    BodyState moved = planes.state;
    moved.position += random.in_cube(1e-5);
    moved.orientation = rotation_from_vector(angle * random.direction()) * moved.orientation;
    const double of_plane = plane_force(plane, at_state(body, moved)).depth;
    EXPECT_NEAR(depth_at(depth, depths.state, moved), of_plane, angle * angle * arm.norm());
  }
}

TEST(LinearContactModel, depth_term_never_pulls_and_only_loses_energy_to_damping) {
  Random random(13);
  int active = 0;
  for (int i = 0; i < 2000; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    state.linear_momentum *= 10.0;
    const DepthTerm term = any_depth(random);
    const BodyState taken_at = state;
    state.position += random.in_cube(2e-3);
    const BodyAtState here = at_state(body, state);
    const BodyKinematics& at = here.kinematics;
    const PlaneForce f = depth_force(term, taken_at, here);
    EXPECT_LE(f.wrench.force.dot(term.linear), 0.0);
    if (!f.is_active) {
      EXPECT_EQ(f.wrench.force, Vec3::Zero());
      continue;
    }
    ++active;
    const double rate = term.linear.dot(at.velocity.linear) + term.angular.dot(at.velocity.angular);
    const double power =
        f.wrench.force.dot(at.velocity.linear) + f.wrench.torque.dot(at.velocity.angular);
    const double stored = term.stiffness * (f.depth + term.tolerance) * rate;
    EXPECT_NEAR(power, -stored - term.damping * rate * rate, 1e-9 * (1.0 + std::fabs(power)));
  }
  EXPECT_GT(active, 300);
}

}  // namespace
}  // namespace thigma
