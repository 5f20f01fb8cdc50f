#include "reference/bent_depth.h"

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

double depth_after(const DepthTerm& term, const Vec6& motion,
                   const GradientByMotion& bend) THIGMA_RT {
  const double depth =
      term.depth + term.linear.dot(motion.head<3>()) + term.angular.dot(motion.tail<3>());
  return depth + 0.5 * motion.dot(bend * motion);
}

}  // namespace

double bent_depth_at(const DepthTerm& term, const BodyState& taken_at, const GradientByMotion& bend,
                     const BodyState& state) THIGMA_RT {
  const Mat34 turn = turn_by_orientation(taken_at.orientation, state.orientation);
  return depth_after(term, motion_between(taken_at, state, turn), bend);
}

PlaneForce bent_depth_force(const DepthTerm& term, const BodyState& taken_at,
                            const GradientByMotion& bend, const BodyAtState& at,
                            WrenchJacobian* jacobian) THIGMA_RT {
  const BodyKinematics& kin = at.kinematics;
  const Mat34 turn = turn_by_orientation(taken_at.orientation, at.state.orientation);
  const Vec6 motion = motion_between(taken_at, at.state, turn);
  Vec6 gradient, velocity;
  gradient << term.linear, term.angular;
  gradient += bend * motion;
  velocity << kin.velocity.linear, kin.velocity.angular;
  PlaneForce f;
  f.depth = depth_after(term, motion, bend);
  f.magnitude = term.stiffness * (f.depth + term.tolerance) + term.damping * gradient.dot(velocity);
  const bool is_bent_over = !(gradient.head<3>().dot(term.linear) > 0.0);
  f.is_active = f.depth + term.tolerance > 0.0 && f.magnitude > 0.0 && !is_bent_over;
  if (!f.is_active) return f;
  f.wrench = {-f.magnitude * gradient.head<3>(), -f.magnitude * gradient.tail<3>()};
  if (!jacobian) return f;
  // dm: of the depth the symmetric part of the bend counts alone
  const Vec6 by_motion = term.stiffness * gradient +
                         (0.5 * term.stiffness) * (bend.transpose() * motion - bend * motion) +
                         term.damping * (bend.transpose() * velocity);
  Vec13 by_y;  // dm/dy
  by_y.segment<3>(0) = by_motion.head<3>();
  by_y.segment<4>(3) = turn.transpose() * by_motion.tail<3>() +
                       kin.angular_velocity_by_q.transpose() * (term.damping * gradient.tail<3>());
  by_y.segment<3>(7) = (term.damping / at.body.mass) * gradient.head<3>();
  by_y.segment<3>(10) = kin.inverse_inertia * (term.damping * gradient.tail<3>());  // symmetric
  *jacobian -= gradient * by_y.transpose();
  jacobian->block<6, 3>(0, 0) -= f.magnitude * bend.leftCols<3>();
  jacobian->block<6, 4>(0, 3) -= f.magnitude * (bend.rightCols<3>() * turn);
  return f;
}

}  // namespace thigma
