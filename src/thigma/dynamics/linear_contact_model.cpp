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
