#include "reference/taylor_term.h"

#include "support/jacobian.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

TaylorTerm any_taylor(Random& random) {
  TaylorTerm t;
  t.normal = random.direction();
  t.wrench = {-2.0 * t.normal, random.in_cube(0.1)};
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 13; ++j) t.jacobian(i, j) = random.uniform(-1.0, 1.0);
  }
  return t;
}

TEST(TaylorTerm, takes_the_nearer_of_q_and_minus_q) {
  Random random(7);
  const RigidBody body = test::random_body(random);
  const BodyState state = test::random_state(random, body, random.orientation());
  const TaylorTerm term = any_taylor(random);
  BodyState other = state;
  other.orientation.coeffs() *= -1.0;
  WrenchJacobian J, J_other;
  const Wrench w = pushing_wrench(term, state, state, &J);
  const Wrench w_other = pushing_wrench(term, state, other, &J_other);
  EXPECT_LE((w.force - w_other.force).norm() + (w.torque - w_other.torque).norm(), 1e-15);
  EXPECT_LE((w.force - term.wrench.force).norm(), 1e-15);
  for (const test::NamedState& at :
       {test::NamedState{"same", state}, test::NamedState{"other", other}}) {
    test::expect_jacobian(
        [&](const BodyState& y, WrenchJacobian* jacobian) {
          return pushing_wrench(term, state, y, jacobian);
        },
        body, at, 1e-7);
  }
}

TEST(TaylorTerm, that_would_pull_is_dropped) {
  Random random(8);
  const RigidBody body = test::random_body(random);
  const BodyState state = test::random_state(random, body, random.orientation());
  TaylorTerm term = any_taylor(random);
  term.jacobian.setZero();
  term.jacobian.block<3, 3>(0, 0) = 1000.0 * Mat3::Identity();
  BodyState away = state;
  away.position += 0.0019 * term.normal;
  EXPECT_LT(pushing_wrench(term, state, away).force.dot(term.normal), 0.0);
  away.position += 0.0002 * term.normal;
  WrenchJacobian J;
  EXPECT_EQ(pushing_wrench(term, state, away, &J).force, Vec3::Zero());
  EXPECT_EQ(J, WrenchJacobian::Zero());
}

}  // namespace
}  // namespace thigma
