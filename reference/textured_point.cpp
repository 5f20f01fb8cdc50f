#include "reference/textured_point.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma {

PlateDepth plate_depth(const SinusoidPlate& plate, const Vec3& p) THIGMA_RT {
  const SinCos u = sin_cos(plate.wave_u * plate.u.dot(p) + plate.phase_u);
  const SinCos v = sin_cos(plate.wave_v * plate.v.dot(p) + plate.phase_v);
  const double slope_u = plate.amplitude_u * plate.wave_u;
  const double slope_v = plate.amplitude_v * plate.wave_v;
  PlateDepth d;
  d.depth = plate.n.dot(p) - plate.offset - plate.amplitude_u * u.sin - plate.amplitude_v * v.sin;
  d.gradient = plate.n - (slope_u * u.cos) * plate.u - (slope_v * v.cos) * plate.v;
  d.hessian = (slope_u * plate.wave_u * u.sin) * plate.u * plate.u.transpose() +
              (slope_v * plate.wave_v * v.sin) * plate.v * plate.v.transpose();
  return d;
}

Wrench texture_wrench(const TexturedPoint& probe, const BodyState& state, TextureJacobian kind,
                      WrenchJacobian* jacobian) THIGMA_RT {
  if (jacobian) jacobian->setZero();
  const Vec3 arm = rotation_matrix(state.orientation) * probe.arm_body;
  const PlateDepth d = plate_depth(probe.plate, state.position + arm);
  if (!(d.depth > 0.0)) return {};
  const Vec3 force = (-probe.stiffness * d.depth) * d.gradient;
  const Wrench wrench{force, arm.cross(force)};
  if (!jacobian) return wrench;

  const bool is_exact = kind == TextureJacobian::exact;
  const Mat34 arm_by_q = rotated_derivative(state.orientation, probe.arm_body);
  Mat3 by_point = d.gradient * d.gradient.transpose();
  if (is_exact) by_point += d.depth * d.hessian;
  by_point *= -probe.stiffness;
  jacobian->block<3, 3>(0, 0) = by_point;
  jacobian->block<3, 4>(0, 3) = by_point * arm_by_q;
  jacobian->block<3, 7>(3, 0) = skew(arm) * jacobian->block<3, 7>(0, 0);
  if (is_exact) jacobian->block<3, 4>(3, 3) -= skew(force) * arm_by_q;
  return wrench;
}

TaylorTerm texture_term(const TexturedPoint& probe, const BodyState& state) THIGMA_RT {
  TaylorTerm term;
  term.wrench = texture_wrench(probe, state, TextureJacobian::gauss_newton, &term.jacobian);
  term.normal = probe.plate.n;
  return term;
}

}  // namespace thigma
