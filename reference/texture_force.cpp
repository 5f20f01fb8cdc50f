#include "reference/texture_force.h"

#include "thigma/math/rotation.h"

namespace thigma {

Wrench texture_wrench(double depth, const DepthGradient& gradient, double stiffness) noexcept {
  if (!(depth > 0.0) || !gradient.is_valid) return {};
  const double scale = -stiffness * depth;
  return {scale * gradient.linear, scale * gradient.angular};
}

WrenchJacobian texture_jacobian(double depth, const DepthGradient& gradient, double stiffness,
                                const Quat& orientation) noexcept {
  WrenchJacobian jacobian = WrenchJacobian::Zero();
  if (!(depth > 0.0) || !gradient.is_valid) return jacobian;
  Vec6 g;
  g << gradient.linear, gradient.angular;
  // A rotation vector about the centre, global axes, changes with q by 4 Q(q)^T.
  Eigen::Matrix<double, 1, 7> by_pose;
  by_pose << gradient.linear.transpose(),
      4.0 * gradient.angular.transpose() * rate_matrix(orientation).transpose();
  jacobian.leftCols<7>() = -stiffness * g * by_pose;
  return jacobian;
}

Wrench reaction(const Wrench& on_object, const Vec3& object_centre,
                const Vec3& scene_centre) noexcept {
  const Vec3 force = -on_object.force;
  return {force, -on_object.torque + (object_centre - scene_centre).cross(force)};
}

}  // namespace thigma
