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

// 2 vec(q q_0^-1), the rotation vector from q_0 to q to second order, with -q for q when that is
// nearer: linear in q.
Mat34 turn_by_orientation(const Quat& from, const Quat& to) THIGMA_RT {
  const double side = to.coeffs().dot(from.coeffs()) < 0.0 ? -2.0 : 2.0;
  Mat34 matrix;
  matrix.leftCols<3>() = side * (from.w() * Mat3::Identity() + skew(from.vec()));
  matrix.col(3) = -side * from.vec();
  return matrix;
}

Vec6 motion_between(const BodyState& from, const BodyState& to, const Mat34& turn) THIGMA_RT {
  Vec6 motion;
  motion << to.position - from.position, turn * to.orientation.coeffs();
  return motion;
}

double depth_after(const DepthTerm& term, const Vec6& motion, const DepthBend* bend) THIGMA_RT {
  const double depth =
      term.depth + term.linear.dot(motion.head<3>()) + term.angular.dot(motion.tail<3>());
  return bend == nullptr ? depth : depth + 0.5 * motion.dot(*bend * motion);
}

}  // namespace

double depth_at(const DepthTerm& term, const BodyState& taken_at, const BodyState& state,
                const DepthBend* bend) THIGMA_RT {
  const Mat34 turn = turn_by_orientation(taken_at.orientation, state.orientation);
  return depth_after(term, motion_between(taken_at, state, turn), bend);
}

PlaneForce depth_force(const DepthTerm& term, const BodyState& taken_at, const RigidBody& body,
                       const BodyState& state, const BodyKinematics& at, double scale,
                       WrenchJacobian* jacobian, const DepthBend* bend) THIGMA_RT {
  const Mat34 turn = turn_by_orientation(taken_at.orientation, state.orientation);
  const Vec6 motion = motion_between(taken_at, state, turn);
  Vec6 gradient, velocity;
  gradient << term.linear, term.angular;
  velocity << at.velocity.linear, at.velocity.angular;
  PlaneForce f;
  f.depth = depth_after(term, motion, bend);
  if (bend != nullptr) gradient += *bend * motion;
  f.magnitude = term.stiffness * (f.depth + term.tolerance) + term.damping * gradient.dot(velocity);
  // A gradient bent to the other side is of no surface near.
  const bool is_bent_over = bend != nullptr && !(gradient.head<3>().dot(term.linear) > 0.0);
  f.is_active = f.depth + term.tolerance > 0.0 && f.magnitude > 0.0 && !is_bent_over;
  if (!f.is_active) return f;
  f.wrench = {-f.magnitude * gradient.head<3>(), -f.magnitude * gradient.tail<3>()};
  if (!jacobian) return f;
  // dm: of the depth the symmetric part of the bend counts alone
  Vec6 by_motion = term.stiffness * gradient;
  if (bend != nullptr) {
    by_motion += (0.5 * term.stiffness) * (bend->transpose() * motion - *bend * motion) +
                 term.damping * (bend->transpose() * velocity);
  }
  Vec13 by_y;  // dm/dy
  by_y.segment<3>(0) = by_motion.head<3>();
  by_y.segment<4>(3) = turn.transpose() * by_motion.tail<3>() +
                       at.angular_velocity_by_q.transpose() * (term.damping * gradient.tail<3>());
  by_y.segment<3>(7) = (term.damping / body.mass) * gradient.head<3>();
  by_y.segment<3>(10) = at.inverse_inertia * (term.damping * gradient.tail<3>());  // symmetric
  *jacobian -= (scale * gradient) * by_y.transpose();
  if (bend == nullptr) return f;
  const double along = scale * f.magnitude;
  jacobian->block<6, 3>(0, 0) -= along * bend->leftCols<3>();
  jacobian->block<6, 4>(0, 3) -= along * (bend->rightCols<3>() * turn);
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
  for (std::size_t i = 0; i < model.depths.size(); ++i) {
    const PlaneForce f = depth_force(model.depths[i], model.state, body, state, at, scale, jacobian,
                                     bend_of(model, i));
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
