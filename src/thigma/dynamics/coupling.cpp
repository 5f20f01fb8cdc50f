#include "thigma/dynamics/coupling.h"

#include <cmath>

#include "thigma/core/error.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

SpringVector spring(const std::optional<Saturation>& saturation, double stiffness,
                    const Vec3& stretch) THIGMA_RT {
  if (saturation) return spring_force(*saturation, stretch);
  return {stiffness * stretch, stiffness * Mat3::Identity()};
}

// Force at the grasp point and torque of the angular spring and damper, which act on body and hand
// alike.
struct GraspForces {
  Vec3 arm;  // R c
  Vec3 force;
  Vec3 couple;
  Mat3 linear_stiffness;
  Mat3 angular_stiffness;
  Mat34 angular_by_q;
};

GraspForces grasp_forces(const Coupling& c, const Motion& device, const BodyState& state,
                         const Mat3& rotation, const Twist& velocity) THIGMA_RT {
  GraspForces g;
  g.arm = rotation * c.body_from_grasp.position;
  const CouplingStretch stretch = coupling_stretch(c, device.pose, state);
  const SpringVector linear = spring(c.linear_saturation, c.linear_stiffness, stretch.linear);
  const SpringVector angular = spring(c.angular_saturation, c.angular_stiffness, stretch.angular);
  const Vec3 grasp_velocity = velocity.linear + velocity.angular.cross(g.arm);
  g.force = linear.force + c.linear_damping * (device.twist.linear - grasp_velocity);
  g.couple = angular.force + c.angular_damping * (device.twist.angular - velocity.angular);
  g.linear_stiffness = linear.stiffness;
  g.angular_stiffness = angular.stiffness;
  g.angular_by_q = stretch.angular_by_q;
  return g;
}

}  // namespace

Saturation make_saturation(double stiffness, double linear_range, double max_force) {
  const double linear_force = stiffness * linear_range;
  if (!(stiffness > 0.0) || !(linear_range >= 0.0) || !(max_force > linear_force) ||
      !std::isfinite(max_force)) {
    throw InputError(
        "saturation: expected stiffness > 0, linear range >= 0, maximum > stiffness * linear "
        "range");
  }
  const double full_range = linear_range + 2.0 * (max_force - linear_force) / stiffness;
  return {.stiffness = stiffness,
          .linear_range = linear_range,
          .full_range = full_range,
          .max_force = max_force};
}

bool is_monotone(const Saturation& s) THIGMA_RT {
  const double width = s.full_range - s.linear_range;
  return width > 0.0 && width <= 3.0 * (s.max_force - s.stiffness * s.linear_range) / s.stiffness;
}

SpringForce spring_force(const Saturation& s, double stretch) THIGMA_RT {
  if (stretch <= s.linear_range) return {s.stiffness * stretch, s.stiffness};
  if (stretch >= s.full_range) return {s.max_force, 0.0};
  // Cubic Hermite from (x1, k0 x1, slope k0) to (x2, F_max, slope 0), in powers of t.
  const double width = s.full_range - s.linear_range;
  const double t = (stretch - s.linear_range) / width;
  const double start = s.stiffness * s.linear_range;
  const double rise = s.max_force - start;
  const double c1 = s.stiffness * width;
  const double c2 = 3.0 * rise - 2.0 * c1;
  const double c3 = c1 - 2.0 * rise;
  return {start + t * (c1 + t * (c2 + t * c3)), (c1 + t * (2.0 * c2 + t * 3.0 * c3)) / width};
}

SpringVector spring_force(const Saturation& s, const Vec3& stretch) THIGMA_RT {
  const double length = std::sqrt(stretch.squaredNorm());
  if (length <= s.linear_range || length == 0.0)
    return {s.stiffness * stretch, s.stiffness * Mat3::Identity()};
  const SpringForce f = spring_force(s, length);
  const Vec3 u = stretch / length;
  const double across = f.force / length;
  return {f.force * u, (f.slope - across) * u * u.transpose() + across * Mat3::Identity()};
}

Pose grasp(const BodyState& state, const Pose& world_from_device) THIGMA_RT {
  return inverse(Pose{state.position, state.orientation}) * world_from_device;
}

void grasp(Coupling& coupling, const BodyState& state, const Pose& world_from_device) THIGMA_RT {
  coupling.body_from_grasp = grasp(state, world_from_device);
  coupling.is_grasped = true;
}

void release(Coupling& coupling) THIGMA_RT { coupling.is_grasped = false; }

Coupling faded(const Coupling& coupling, double weight) THIGMA_RT {
  Coupling result = coupling;
  result.linear_stiffness *= weight;
  result.angular_stiffness *= weight;
  for (std::optional<Saturation>* spring :
       {&result.linear_saturation, &result.angular_saturation}) {
    if (!*spring) continue;
    (*spring)->stiffness *= weight;
    (*spring)->max_force *= weight;
  }
  return result;
}

CouplingStretch coupling_stretch(const Coupling& coupling, const Pose& world_from_device,
                                 const BodyState& state) THIGMA_RT {
  CouplingStretch s;
  const Vec3 arm = rotation_matrix(state.orientation) * coupling.body_from_grasp.position;
  s.linear = world_from_device.position - state.position - arm;
  // dq = (q_h q_c^-1) q^-1, linear in q: dq = A(q_h q_c^-1) diag(-1, -1, -1, 1) q (Eq. 5.20).
  const Quat hand_from_body =
      world_from_device.orientation * coupling.body_from_grasp.orientation.conjugate();
  Mat34 by_dq;
  s.angular = vector_from_rotation(hand_from_body * state.orientation.conjugate(), &by_dq);
  Mat4 C = left_product_matrix(hand_from_body);
  C.leftCols<3>() *= -1.0;
  s.angular_by_q = by_dq * C;
  return s;
}

Wrench coupling_wrench(const Coupling& coupling, const Motion& device, const BodyAtState& at,
                       WrenchJacobian* jacobian) THIGMA_RT {
  if (!coupling.is_grasped) {
    if (jacobian) jacobian->setZero();
    return {};
  }
  const BodyKinematics& kin = at.kinematics;
  const GraspForces g = grasp_forces(coupling, device, at.state, kin.rotation, kin.velocity);
  const Wrench wrench{g.force, g.arm.cross(g.force) + g.couple};
  if (!jacobian) return wrench;

  const double b_c = coupling.linear_damping;
  const double b_t = coupling.angular_damping;
  const Mat3 arm = skew(g.arm);
  const Mat34 arm_by_q =
      rotated_derivative(at.state.orientation, coupling.body_from_grasp.position);
  WrenchJacobian& J = *jacobian;
  J.block<3, 3>(0, 0) = -g.linear_stiffness;  // Eq. 5.21
  J.block<3, 4>(0, 3) =
      b_c * arm * kin.angular_velocity_by_q -
      (g.linear_stiffness + b_c * skew(kin.velocity.angular)) * arm_by_q;  // Eq. 5.23
  J.block<3, 3>(0, 7) = (-b_c / at.body.mass) * Mat3::Identity();          // Eq. 5.26
  J.block<3, 3>(0, 10) = b_c * arm * kin.inverse_inertia;                  // Eq. 5.28
  J.bottomRows<3>() = arm * J.topRows<3>();
  J.block<3, 4>(3, 3) += g.angular_stiffness * g.angular_by_q - b_t * kin.angular_velocity_by_q -
                         skew(g.force) * arm_by_q;    // Eq. 5.24
  J.block<3, 3>(3, 10) -= b_t * kin.inverse_inertia;  // Eq. 5.29
  return wrench;
}

Wrench coupling_wrench(const Coupling& coupling, const Motion& device, const RigidBody& body,
                       const BodyState& state, WrenchJacobian* jacobian) THIGMA_RT {
  return coupling_wrench(coupling, device, at_state(body, state), jacobian);
}

Wrench coupling_reaction(const Coupling& coupling, const Motion& device, const RigidBody& body,
                         const BodyState& state) THIGMA_RT {
  if (!coupling.is_grasped) return {};
  const Mat3 R = rotation_matrix(state.orientation);
  const GraspForces g = grasp_forces(coupling, device, state, R, velocity(body, state));
  return {-g.force, -g.couple};
}

}  // namespace thigma
