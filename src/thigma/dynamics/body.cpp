#include "thigma/dynamics/body.h"

#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "thigma/core/error.h"
#include "thigma/math/rotation.h"

namespace thigma {

RigidBody make_body(double mass, const Mat3& inertia, const Vec3& gravity) {
  if (!(mass > 0.0) || !std::isfinite(mass)) {
    throw InputError("body: mass " + std::to_string(mass) +
                     ", expected a positive number of kilograms");
  }
  const double size = inertia.cwiseAbs().maxCoeff();
  const Mat3 scaled = inertia / size;  // of order one: no part is too small for what follows
  const bool is_symmetric = (scaled - scaled.transpose()).cwiseAbs().maxCoeff() <= 1e-9;
  if (!scaled.allFinite() || !is_symmetric || scaled.llt().info() != Eigen::Success) {
    throw InputError("body: inertia tensor, expected a symmetric positive definite 3 x 3 matrix");
  }
  if (!gravity.allFinite()) throw InputError("body: gravity, expected three finite numbers");
  return {.mass = mass,
          .inertia = inertia,
          .inverse_inertia = scaled.inverse() / size,
          .gravity = gravity};
}

Twist velocity(const RigidBody& body, const BodyState& state) THIGMA_RT {
  const Mat3 R = rotation_matrix(state.orientation);
  const Vec3 spin_body = body.inverse_inertia * (R.transpose() * state.angular_momentum);
  return {state.linear_momentum / body.mass, R * spin_body};
}

BodyKinematics kinematics(const RigidBody& body, const BodyState& state) THIGMA_RT {
  BodyKinematics k;
  k.rotation = rotation_matrix(state.orientation);
  const Mat3 RM = k.rotation * body.inverse_inertia;
  k.inverse_inertia = RM * k.rotation.transpose();
  const Vec3 spin_body = body.inverse_inertia * (k.rotation.transpose() * state.angular_momentum);
  k.velocity = {state.linear_momentum / body.mass, k.rotation * spin_body};
  // omega = R (M^-1 R^T L): both factors depend on q.
  k.angular_velocity_by_q =
      rotated_derivative(state.orientation, spin_body) +
      RM * inverse_rotated_derivative(state.orientation, state.angular_momentum);
  return k;
}

double kinetic_energy(const RigidBody& body, const BodyState& state) THIGMA_RT {
  const Twist v = velocity(body, state);
  return 0.5 * (state.linear_momentum.dot(v.linear) + state.angular_momentum.dot(v.angular));
}

Vec13 state_rate(const RigidBody& body, const BodyState& state, const Wrench& wrench) THIGMA_RT {
  const Twist v = velocity(body, state);
  Vec13 rate;
  rate.segment<3>(0) = v.linear;
  rate.segment<4>(3) = rate_matrix(state.orientation) * v.angular;
  rate.segment<3>(7) = wrench.force + body.mass * body.gravity;
  rate.segment<3>(10) = wrench.torque;
  return rate;
}

Vec13 to_vector(const BodyState& state) THIGMA_RT {
  Vec13 y;
  y << state.position, state.orientation.coeffs(), state.linear_momentum, state.angular_momentum;
  return y;
}

BodyState from_vector(const Vec13& y) THIGMA_RT {
  return {y.segment<3>(0), Quat(y[6], y[3], y[4], y[5]), y.segment<3>(7), y.segment<3>(10)};
}

}  // namespace thigma
