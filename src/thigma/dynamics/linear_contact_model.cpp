#include "thigma/dynamics/linear_contact_model.h"

#include "thigma/math/rotation.h"

namespace thigma {

PlaneForce plane_force(const PlaneTerm& term, const RigidBody& body, const BodyState& state,
                       const BodyKinematics& at, double scale, WrenchJacobian* jacobian) THIGMA_RT {
  PlaneForce f;
  const Vec3& n = term.normal;
  const Vec3& omega = at.velocity.angular;
  const Vec3 arm = at.rotation * term.arm_body;
  const Vec3 point_velocity = at.velocity.linear + omega.cross(arm);
  f.depth = n.dot(state.position + arm - term.scene_point);
  f.magnitude = term.stiffness * (f.depth + term.tolerance) +
                term.damping * n.dot(point_velocity - term.scene_velocity);
  f.is_active = !term.is_unilateral || (f.depth + term.tolerance > 0.0 && f.magnitude > 0.0);
  if (!f.is_active) return f;
  const Vec3 moment = arm.cross(n);
  f.wrench = {-f.magnitude * n, -f.magnitude * moment};
  if (!jacobian) return f;

  // (F, T) = -m (n, Rr x n). The first factor's derivative is a row, so most of the Jacobian has
  // rank one.
  const Mat34 arm_by_q = rotated_derivative(state.orientation, term.arm_body);
  Vec13 by_y;  // dm/dy
  by_y.segment<3>(0) = term.stiffness * n;
  by_y.segment<4>(3) = arm_by_q.transpose() * (term.stiffness * n + term.damping * n.cross(omega)) +
                       at.angular_velocity_by_q.transpose() * (term.damping * moment);
  by_y.segment<3>(7) = (term.damping / body.mass) * n;
  by_y.segment<3>(10) = at.inverse_inertia * (term.damping * moment);  // the matrix is symmetric
  jacobian->topRows<3>() -= (scale * n) * by_y.transpose();
  jacobian->bottomRows<3>() -= (scale * moment) * by_y.transpose();
  jacobian->block<3, 4>(3, 3) += skew((scale * f.magnitude) * n) * arm_by_q;
  return f;
}

namespace {

// 2 vec(q q_0^-1), the rotation vector from q_0 to q to second order, with -q for q when that is nearer: linear in q.
Mat34 turn_by_orientation(const Quat& from, const Quat& to) THIGMA_RT {
  const double side = to.coeffs().dot(from.coeffs()) < 0.0 ? -2.0 : 2.0;
  Mat34 matrix;
  matrix.leftCols<3>() = side * (from.w() * Mat3::Identity() + skew(from.vec()));
  matrix.col(3) = -side * from.vec();
  return matrix;
}

}  // namespace

double depth_at(const DepthTerm& term, const BodyState& taken_at, const BodyState& state) THIGMA_RT {
  const Vec3 turn =
      turn_by_orientation(taken_at.orientation, state.orientation) * state.orientation.coeffs();
  return term.depth + term.linear.dot(state.position - taken_at.position) + term.angular.dot(turn);
}

PlaneForce depth_force(const DepthTerm& term, const BodyState& taken_at, const RigidBody& body,
                       const BodyState& state, const BodyKinematics& at, double scale,
                       WrenchJacobian* jacobian) THIGMA_RT {
  PlaneForce f;
  f.depth = depth_at(term, taken_at, state);
  f.magnitude = term.stiffness * (f.depth + term.tolerance) +
                term.damping * (term.linear.dot(at.velocity.linear) +
                                term.angular.dot(at.velocity.angular));
  f.is_active = f.depth + term.tolerance > 0.0 && f.magnitude > 0.0;
  if (!f.is_active) return f;
  f.wrench = {-f.magnitude * term.linear, -f.magnitude * term.angular};
  if (!jacobian) return f;
  const Mat34 turn = turn_by_orientation(taken_at.orientation, state.orientation);
  Vec13 by_y;  // dm/dy
  by_y.segment<3>(0) = term.stiffness * term.linear;
  by_y.segment<4>(3) = turn.transpose() * (term.stiffness * term.angular) +
                       at.angular_velocity_by_q.transpose() * (term.damping * term.angular);
  by_y.segment<3>(7) = (term.damping / body.mass) * term.linear;
  by_y.segment<3>(10) = at.inverse_inertia * (term.damping * term.angular);  // symmetric
  jacobian->topRows<3>() -= (scale * term.linear) * by_y.transpose();
  jacobian->bottomRows<3>() -= (scale * term.angular) * by_y.transpose();
  return f;
}

Wrench extrapolate(const TaylorTerm& term, const BodyState& taken_at, const BodyState& state,
                   WrenchJacobian* jacobian) THIGMA_RT {
  const double cover =
      state.orientation.coeffs().dot(taken_at.orientation.coeffs()) < 0.0 ? -1.0 : 1.0;
  BodyState aligned = state;
  aligned.orientation.coeffs() *= cover;
  const Vec6 change = term.jacobian * (to_vector(aligned) - to_vector(taken_at));
  if (jacobian) {
    *jacobian = term.jacobian;
    jacobian->middleCols<4>(3) *= cover;
  }
  return {term.wrench.force + change.head<3>(), term.wrench.torque + change.tail<3>()};
}

Wrench contact_wrench(const LinearContactModel& model, const RigidBody& body,
                      const BodyState& state, const BodyKinematics& at, double scale,
                      WrenchJacobian* jacobian) THIGMA_RT {
  Wrench sum;
  if (jacobian) jacobian->setZero();
  for (const PlaneTerm& term : model.planes) {
    const PlaneForce f = plane_force(term, body, state, at, scale, jacobian);
    if (f.is_active) sum = sum + f.wrench;
  }
  for (const DepthTerm& term : model.depths) {
    const PlaneForce f = depth_force(term, model.state, body, state, at, scale, jacobian);
    if (f.is_active) sum = sum + f.wrench;
  }
  for (const TaylorTerm& term : model.taylors) {
    WrenchJacobian term_jacobian;
    const Wrench w = extrapolate(term, model.state, state, jacobian ? &term_jacobian : nullptr);
    if (!(w.force.dot(term.normal) <= 0.0)) continue;  // it would pull
    sum = sum + w;
    if (jacobian) *jacobian += scale * term_jacobian;
  }
  return scale * sum;
}

Wrench contact_wrench(const LinearContactModel& model, const RigidBody& body,
                      const BodyState& state, double scale, WrenchJacobian* jacobian) THIGMA_RT {
  return contact_wrench(model, body, state, kinematics(body, state), scale, jacobian);
}

}  // namespace thigma
