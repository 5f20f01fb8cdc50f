#include "reference/glued_plane.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

PlaneTerm plane_at(Random& random, const BodyState& state, double depth) {
  PlaneTerm t;
  t.arm_body = random.in_cube(0.05);
  t.normal = random.direction();
  t.scene_point =
      state.position + rotation_matrix(state.orientation) * t.arm_body - depth * t.normal;
  t.scene_velocity = random.in_cube(0.1);
  t.stiffness = random.uniform(500.0, 5000.0);
  t.damping = random.uniform(0.0, 5.0);
  t.tolerance = 1e-3;
  return t;
}

TEST(GluedPlane, jacobian_is_its_derivative_at_any_depth) {
  Random random(1);
  for (int i = 0; i < 5; ++i) {
    const RigidBody body = test::random_body(random);
    for (const test::NamedState& at : test::states_to_try(random, body)) {
      const PlaneTerm term = plane_at(random, at.state, random.uniform(-5e-3, 5e-3));
      test::expect_jacobian(
          [&](const BodyState& y, WrenchJacobian* J) {
            if (J) J->setZero();
            return glued_plane_force(term, at_state(body, y), J).wrench;
          },
          body, at, 1e-7);
    }
  }
}

TEST(GluedPlane, is_the_plane_of_the_engine_where_that_pushes) {
  Random random(2);
  int pushing = 0, pulling = 0;
  for (int i = 0; i < 200; ++i) {
    const RigidBody body = test::random_body(random);
    const BodyState state = test::random_state(random, body, random.orientation());
    const PlaneTerm term = plane_at(random, state, random.uniform(-5e-3, 5e-3));
    const BodyAtState at = at_state(body, state);
    WrenchJacobian J = WrenchJacobian::Zero(), J_glued = J;
    const PlaneForce f = plane_force(term, at, 1.0, &J),
                     glued = glued_plane_force(term, at, &J_glued);
    EXPECT_EQ(f.depth, glued.depth);
    EXPECT_EQ(f.magnitude, glued.magnitude);
    if (f.is_active) {
      ++pushing;
      EXPECT_EQ(f.wrench.torque, glued.wrench.torque);
      EXPECT_EQ(J, J_glued);
    } else {
      ++pulling;
      EXPECT_GT(glued.wrench.force.norm(), 0.0);
    }
  }
  EXPECT_GT(pushing, 20);
  EXPECT_GT(pulling, 20);
}

}  // namespace
}  // namespace thigma
