#include "thigma/dynamics/implicit_step.h"

#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "thigma/dynamics/detail/small_solve.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using Mat6Rows = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

// Power of two near the radius of gyration. With L measured in units of length * P, masses and
// inertias drop out of the 6 x 6 system and its rows are of like size; a power of two scales
// without rounding.
double inertia_length(const BodyAtState& at) THIGMA_RT {
  const double length2 = 3.0 / (at.body.mass * at.kinematics.inverse_inertia.trace());
  int exponent = 0;
  std::frexp(std::sqrt(length2), &exponent);
  return std::ldexp(1.0, exponent);
}

/// What stands for the orientation, R numbers r: dr = G dL + g.
template <int R>
struct RotationStep {
  Eigen::Matrix<double, 6, R> by_rotation;  // d(force, torque)/dr
  Eigen::Matrix<double, R, 3> G;
  Eigen::Matrix<double, R, 1> g;
};

// Solves for (dP, dL):  dP, dL = h (wrench + J_x dx + J_r dr + J_P dP + J_L dL)  with
// dx = (h/m)(P + dP),  dr = G dL + g.
template <int R>
Vec6 solve_momentum(const BodyAtState& at, const Wrench& wrench, const WrenchJacobian& jacobian,
                    double h, const RotationStep<R>& r) THIGMA_RT {
  const RigidBody& body = at.body;
  const WrenchJacobian& J = jacobian;
  const double h_per_mass = h / body.mass;
  Mat6Rows A = Mat6Rows::Identity();
  A.leftCols<3>() -= h * (J.middleCols<3>(7) + h_per_mass * J.leftCols<3>());
  A.rightCols<3>() -= h * (J.rightCols<3>() + r.by_rotation * r.G);
  Vec6 b;
  b << wrench.force + body.mass * body.gravity, wrench.torque;
  b = h * (b + J.leftCols<3>() * (h_per_mass * at.state.linear_momentum) + r.by_rotation * r.g);

  const double length = inertia_length(at);
  A.topRightCorner<3, 3>() *= length;
  A.bottomLeftCorner<3, 3>() *= 1.0 / length;
  b.tail<3>() *= 1.0 / length;
  solve_in_place<6, 1>(A, b);
  b.tail<3>() *= length;
  return b;
}

BodyState moved(const BodyAtState& at, const Quat& orientation, const Vec6& change,
                double h) THIGMA_RT {
  const BodyState& state = at.state;
  BodyState next;
  next.linear_momentum = state.linear_momentum + change.head<3>();
  next.angular_momentum = state.angular_momentum + change.tail<3>();
  next.position = state.position + (h / at.body.mass) * next.linear_momentum;
  next.orientation = unit(orientation);
  return next;
}

}  // namespace

BodyState implicit_step(const BodyAtState& at, const Wrench& wrench, const WrenchJacobian& jacobian,
                        double h) THIGMA_RT {
  const Mat3& inverse_inertia = at.kinematics.inverse_inertia;
  const Vec3& omega = at.kinematics.velocity.angular;
  // d(dphi/dt)/dphi = d omega/dphi + omega^*/2. Without the second term the block can become
  // singular.
  const Mat3 D = inverse_inertia * skew(at.state.angular_momentum) - 0.5 * skew(omega);
  const Mat3 hE = h * (Mat3::Identity() - h * D).inverse();
  RotationStep<3> r;
  r.G = hE * inverse_inertia;
  r.g = hE * omega;
  r.by_rotation = jacobian.middleCols<4>(3) * rate_matrix(at.state.orientation);
  const Vec6 change = solve_momentum(at, wrench, jacobian, h, r);
  const Vec3 phi = r.G * change.tail<3>() + r.g;
  return moved(at, rotation_from_vector(phi) * at.state.orientation, change, h);
}

BodyState implicit_step(const RigidBody& body, const BodyState& state, const Wrench& wrench,
                        const WrenchJacobian& jacobian, double h) THIGMA_RT {
  return implicit_step(at_state(body, state), wrench, jacobian, h);
}

BodyState implicit_step_6(const RigidBody& body, const BodyState& state, const Wrench& wrench,
                          const WrenchJacobian& jacobian, double h) THIGMA_RT {
  const BodyAtState at = at_state(body, state);
  const BodyKinematics& kin = at.kinematics;
  const Mat43 Q = rate_matrix(state.orientation);
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> B =
      Mat4::Identity() -
      h * (rate_derivative(kin.velocity.angular) + Q * kin.angular_velocity_by_q);
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> Gg;  // (G | g)
  Gg.leftCols<3>() = h * Q * kin.inverse_inertia;
  Gg.col(3) = h * Q * kin.velocity.angular;
  solve_in_place<4, 4>(B, Gg);
  RotationStep<4> r;
  r.G = Gg.leftCols<3>();
  r.g = Gg.col(3);
  r.by_rotation = jacobian.middleCols<4>(3);
  const Vec6 change = solve_momentum(at, wrench, jacobian, h, r);
  const Vec4 q = state.orientation.coeffs() + r.G * change.tail<3>() + r.g;
  return moved(at, Quat(q), change, h);
}

BodyState implicit_step_13(const RigidBody& body, const BodyState& state, const Wrench& wrench,
                           const WrenchJacobian& jacobian, double h) THIGMA_RT {
  Eigen::Matrix<double, 13, 13, Eigen::RowMajor> A =
      Mat13::Identity() - h * state_rate_jacobian(body, state, jacobian);
  Vec13 change = h * state_rate(body, state, wrench);
  solve_in_place<13, 1>(A, change);
  BodyState next = from_vector(to_vector(state) + change);
  next.orientation = unit(next.orientation);
  return next;
}

Mat13 state_rate_jacobian(const RigidBody& body, const BodyState& state,
                          const WrenchJacobian& wrench_jacobian) THIGMA_RT {
  const BodyKinematics at = kinematics(body, state);
  const Mat43 Q = rate_matrix(state.orientation);
  Mat13 J = Mat13::Zero();
  J.block<3, 3>(0, 7) = Mat3::Identity() / body.mass;  // Eq. 5.9
  J.block<4, 4>(3, 3) =
      rate_derivative(at.velocity.angular) + Q * at.angular_velocity_by_q;  // Eq. 5.12
  J.block<4, 3>(3, 10) = Q * at.inverse_inertia;                            // Eq. 5.11
  J.bottomRows<6>() = wrench_jacobian;
  return J;
}

}  // namespace thigma
