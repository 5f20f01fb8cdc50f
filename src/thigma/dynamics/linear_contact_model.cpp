#include "thigma/dynamics/linear_contact_model.h"

#include "thigma/math/rotation.h"

namespace thigma {

PlaneForce plane_force(const PlaneTerm& term, const BodyAtState& at, double scale,
                       WrenchJacobian* jacobian) THIGMA_RT {
  PlaneForce f;
  const BodyKinematics& kin = at.kinematics;
  const Vec3& n = term.normal;
  const Vec3& omega = kin.velocity.angular;
  const Vec3 arm = kin.rotation * term.arm_body;
  const Vec3 point_velocity = kin.velocity.linear + omega.cross(arm);
  f.depth = n.dot(at.state.position + arm - term.scene_point);
  f.magnitude = term.stiffness * (f.depth + term.tolerance) +
                term.damping * n.dot(point_velocity - term.scene_velocity);
  f.is_active = f.depth + term.tolerance > 0.0 && f.magnitude > 0.0;
  if (!f.is_active) return f;
  const Vec3 moment = arm.cross(n);
  f.wrench = {-f.magnitude * n, -f.magnitude * moment};
  if (!jacobian) return f;

  // (F, T) = -m (n, Rr x n). The first factor's derivative is a row, so most of the Jacobian has
  // rank one.
  const Mat34 arm_by_q = rotated_derivative(at.state.orientation, term.arm_body);
  Vec13 by_y;  // dm/dy
  by_y.segment<3>(0) = term.stiffness * n;
  by_y.segment<4>(3) = arm_by_q.transpose() * (term.stiffness * n + term.damping * n.cross(omega)) +
                       kin.angular_velocity_by_q.transpose() * (term.damping * moment);
  by_y.segment<3>(7) = (term.damping / at.body.mass) * n;
  by_y.segment<3>(10) = kin.inverse_inertia * (term.damping * moment);  // the matrix is symmetric
  jacobian->topRows<3>() -= (scale * n) * by_y.transpose();
  jacobian->bottomRows<3>() -= (scale * moment) * by_y.transpose();
  jacobian->block<3, 4>(3, 3) += skew((scale * f.magnitude) * n) * arm_by_q;
  return f;
}

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

namespace {

double depth_after(const DepthTerm& term, const Vec6& motion) THIGMA_RT {
  return term.depth + term.linear.dot(motion.head<3>()) + term.angular.dot(motion.tail<3>());
}

}  // namespace

double depth_at(const DepthTerm& term, const BodyState& taken_at,
                const BodyState& state) THIGMA_RT {
  const Mat34 turn = turn_by_orientation(taken_at.orientation, state.orientation);
  return depth_after(term, motion_between(taken_at, state, turn));
}

PlaneForce depth_force(const DepthTerm& term, const BodyState& taken_at, const BodyAtState& at,
                       double scale, WrenchJacobian* jacobian) THIGMA_RT {
  const BodyKinematics& kin = at.kinematics;
  const Mat34 turn = turn_by_orientation(taken_at.orientation, at.state.orientation);
  Vec6 gradient, velocity;
  gradient << term.linear, term.angular;
  velocity << kin.velocity.linear, kin.velocity.angular;
  PlaneForce f;
  f.depth = depth_after(term, motion_between(taken_at, at.state, turn));
  f.magnitude = term.stiffness * (f.depth + term.tolerance) + term.damping * gradient.dot(velocity);
  f.is_active = f.depth + term.tolerance > 0.0 && f.magnitude > 0.0;
  if (!f.is_active) return f;
  f.wrench = {-f.magnitude * gradient.head<3>(), -f.magnitude * gradient.tail<3>()};
  if (!jacobian) return f;
  const Vec6 by_motion = term.stiffness * gradient;
  Vec13 by_y;  // dm/dy
  by_y.segment<3>(0) = by_motion.head<3>();
  by_y.segment<4>(3) = turn.transpose() * by_motion.tail<3>() +
                       kin.angular_velocity_by_q.transpose() * (term.damping * gradient.tail<3>());
  by_y.segment<3>(7) = (term.damping / at.body.mass) * gradient.head<3>();
  by_y.segment<3>(10) = kin.inverse_inertia * (term.damping * gradient.tail<3>());  // symmetric
  *jacobian -= (scale * gradient) * by_y.transpose();
  return f;
}

Wrench contact_wrench(const LinearContactModel& model, const BodyAtState& at, double scale,
                      WrenchJacobian* jacobian) THIGMA_RT {
  Wrench sum;
  if (jacobian) jacobian->setZero();
  for (const PlaneTerm& term : model.planes) {
    const PlaneForce f = plane_force(term, at, scale, jacobian);
    if (f.is_active) sum = sum + f.wrench;
  }
  for (const DepthTerm& term : model.depths) {
    const PlaneForce f = depth_force(term, model.state, at, scale, jacobian);
    if (f.is_active) sum = sum + f.wrench;
  }
  return scale * sum;
}

Wrench contact_wrench(const LinearContactModel& model, const RigidBody& body,
                      const BodyState& state, double scale, WrenchJacobian* jacobian) THIGMA_RT {
  return contact_wrench(model, at_state(body, state), scale, jacobian);
}

}  // namespace thigma
