#pragma once
// Analytic Jacobians of wrenches against central differences, at the states where they go wrong.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/dynamics/body.h"
#include "thigma/math/elementary.h"
#include "thigma/math/finite_difference.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma::test {

/// A body like the spoon of Sec. 5.5.3: 10 to 100 g, no symmetry, inertia not diagonal in its own
/// frame.
inline RigidBody random_body(Random& random, const Vec3& gravity = Vec3::Zero()) {
  const double mass = random.uniform(0.01, 0.1);
  const Vec3 a =
      Vec3(random.uniform(0.01, 0.02), random.uniform(0.02, 0.04), random.uniform(0.05, 0.08));
  const Vec3 principal = mass / 5.0 *
                         Vec3(a.y() * a.y() + a.z() * a.z(), a.x() * a.x() + a.z() * a.z(),
                              a.x() * a.x() + a.y() * a.y());
  const Mat3 R = random.orientation().toRotationMatrix();
  const Mat3 tensor = R * principal.asDiagonal() * R.transpose();
  return make_body(mass, 0.5 * (tensor + tensor.transpose()), gravity);
}

/// A state of `body` at this orientation, moving at about 0.1 m/s and 3 rad/s.
inline BodyState random_state(Random& random, const RigidBody& body, const Quat& orientation) {
  BodyState state;
  state.position = random.in_cube(0.05);
  state.orientation = orientation;
  state.linear_momentum = body.mass * random.in_cube(0.1);
  state.angular_momentum = body.inertia.trace() / 3.0 * random.in_cube(3.0);
  return state;
}

struct NamedState {
  std::string name;
  BodyState state;
};

/// Orientations where formulas for rotations go wrong: identity, 1e-8 rad, close to half a turn,
/// both covers, anywhere.
inline std::vector<NamedState> states_to_try(Random& random, const RigidBody& body) {
  std::vector<NamedState> list;
  const auto add = [&](const char* name, const Quat& q) {
    list.push_back({name, random_state(random, body, q)});
  };
  add("identity", Quat::Identity());
  add("minus identity", Quat(-1.0, 0.0, 0.0, 0.0));
  add("tiny", rotation_from_vector(1e-8 * random.direction()));
  add("small", rotation_from_vector(1e-3 * random.direction()));
  add("near pi", rotation_from_vector((kPi - 0.02) * random.direction()));
  for (int i = 0; i < 4; ++i) add("random", random.orientation());
  return list;
}

/// Expects the Jacobian that `forces` (as the concept BodyForces) returns to be the derivative of
/// its wrench. tolerance: largest error relative to the largest entry of the block (force or torque
/// by x, q, P or L).
template <class Forces>
void expect_jacobian(const Forces& forces, const RigidBody& body, const NamedState& at,
                     double tolerance) {
  const auto wrench = [&](const Vec13& y) -> Vec6 {
    const Wrench w = forces(from_vector(y), nullptr);
    Vec6 v;
    v << w.force, w.torque;
    return v;
  };
  Vec13 steps;
  steps << Vec3::Constant(1e-5), Vec4::Constant(3e-4), Vec3::Constant(1e-3 * body.mass),
      Vec3::Constant(1e-2 * body.inertia.trace());
  WrenchJacobian analytic;
  forces(at.state, &analytic);
  const WrenchJacobian numeric =
      finite_difference_jacobian<6, 13>(wrench, to_vector(at.state), steps);
  const Vec6 value = wrench(to_vector(at.state));
  const int first[] = {0, 3, 7, 10, 13};
  for (int row = 0; row < 6; row += 3) {
    for (int b = 0; b < 4; ++b) {
      const auto want = numeric.block(row, first[b], 3, first[b + 1] - first[b]);
      const auto got = analytic.block(row, first[b], 3, first[b + 1] - first[b]);
      const double size = want.cwiseAbs().maxCoeff();
      // Differences of a wrench cannot be finer than its rounding over the step.
      const double noise = 1e-13 * (value.segment<3>(row).norm() + 1e-6) / steps[first[b]];
      EXPECT_LE((got - want).cwiseAbs().maxCoeff(), tolerance * size + noise)
          << at.name << ", rows " << row << ".., columns " << first[b] << "..\ngot\n"
          << got << "\nwant\n"
          << want;
    }
  }
}

}  // namespace thigma::test
