#include "reference/glued_plane.h"

#include "thigma/math/rotation.h"

namespace thigma {

PlaneForce glued_plane_force(const PlaneTerm& term, const BodyAtState& at,
                             WrenchJacobian* jacobian) THIGMA_RT {
  PlaneForce f;
  const BodyKinematics& kin = at.kinematics;
  const Vec3& n = term.normal;
  const Vec3& omega = kin.velocity.angular;
  const Vec3 arm = kin.rotation * term.arm_body;
  f.depth = n.dot(at.state.position + arm - term.scene_point);
  const Vec3 point_velocity = kin.velocity.linear + omega.cross(arm);
  f.magnitude = term.stiffness * (f.depth + term.tolerance) +
                term.damping * n.dot(point_velocity - term.scene_velocity);
  f.is_active = true;
  const Vec3 moment = arm.cross(n);
  f.wrench = {-f.magnitude * n, -f.magnitude * moment};
  if (!jacobian) return f;
  const Mat34 arm_by_q = rotated_derivative(at.state.orientation, term.arm_body);
  Vec13 by_y;  // of the magnitude
  by_y.segment<3>(0) = term.stiffness * n;
  by_y.segment<4>(3) = arm_by_q.transpose() * (term.stiffness * n + term.damping * n.cross(omega)) +
                       kin.angular_velocity_by_q.transpose() * (term.damping * moment);
  by_y.segment<3>(7) = (term.damping / at.body.mass) * n;
  by_y.segment<3>(10) = kin.inverse_inertia * (term.damping * moment);  // the matrix is symmetric
  jacobian->topRows<3>() -= n * by_y.transpose();
  jacobian->bottomRows<3>() -= moment * by_y.transpose();
  jacobian->block<3, 4>(3, 3) += skew(f.magnitude * n) * arm_by_q;
  return f;
}

}  // namespace thigma
