#pragma once
// A point that slides over a plate with an analytic relief: the texture force law in closed form
// (Sec. 4.3, 5.4.4).

#include <cstdint>

#include "reference/taylor_term.h"

#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/math/rotation.h"

namespace thigma {

/// Relief h(u, v) = offset + a_1 sin(k_1 u + f_1) + a_2 sin(k_2 v + f_2) over a plane.
/// Invariant: (u, v, n) orthonormal and right-handed, n out of the grasped object, into the plate.
struct SinusoidPlate {
  Vec3 u = Vec3::UnitX();
  Vec3 v = Vec3::UnitY();
  Vec3 n = Vec3::UnitZ();
  double offset = 0.0;                          // h_0 [m]
  double amplitude_u = 0.0, amplitude_v = 0.0;  // a [m]
  double wave_u = 0.0, wave_v = 0.0;            // k [rad/m]
  double phase_u = 0.0, phase_v = 0.0;          // f [rad]
};

/// Directional depth n . p - h at a point of the object and its derivatives by the point (Eq. 4.3,
/// one sample).
struct PlateDepth {
  double depth = 0.0;            // positive = penetrating [m]
  Vec3 gradient = Vec3::Zero();  // [-]
  Mat3 hessian = Mat3::Zero();   // [1/m]
};
PlateDepth plate_depth(const SinusoidPlate& plate, const Vec3& point) THIGMA_RT;

/// A probe point of the object above a plate.
struct TexturedPoint {
  SinusoidPlate plate;
  Vec3 arm_body = Vec3::Zero();  // r: from the centre of mass [m; body frame]
  double stiffness = 0.0;        // k [N/m]
};

enum class TextureJacobian : std::uint8_t {
  exact,         // with the relief's curvature: indefinite at crests
  gauss_newton,  // -k grad grad^T alone: never adds energy, needs no second derivatives
};

/// Texture wrench -k depth grad(depth) on the object; zero while depth <= 0.
///
/// kind      which Jacobian to give
/// jacobian  null, or d(force, torque)/dy (6 x 13)
/// returns   force [N] and torque about the centre of mass [N m]; world
/// Thread    [haptic]; no failure.
/// Source    Eqs. 4.5, 5.47-5.56; corrected: docs/sources.md.
Wrench texture_wrench(const TexturedPoint& probe, const BodyState& state,
                      TextureJacobian kind = TextureJacobian::gauss_newton,
                      WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// Taylor term at this state, with the Gauss-Newton Jacobian.
/// Thread    [contact].
TaylorTerm texture_term(const TexturedPoint& probe, const BodyState& state) THIGMA_RT;

/// The same wrench from depths alone: 11 evaluations (Eqs. 4.6-4.8).
///
/// depth  callable: directional depth [m] of the object at a Pose (centre of mass and orientation)
/// basis  rows u, v, n as above; along n the slope is 1 by definition
/// step   of translation [m]; `turn` of rotation about the centre of mass [rad], best step / |arm|
/// Thread  [contact] as far as `depth` is; no failure.
template <class Depth>
Wrench texture_wrench_by_differences(const Depth& depth, double stiffness, const Mat3& basis,
                                     const BodyState& state, double step, double turn) {
  const double depth_now = depth(Pose{state.position, state.orientation});
  if (!(depth_now > 0.0)) return {};
  const auto moved = [&](const Vec3& by) {
    return depth(Pose{state.position + by, state.orientation});
  };
  const auto turned = [&](const Vec3& by) {
    return depth(Pose{state.position, rotation_from_vector(by) * state.orientation});
  };
  Vec3 slope(0.0, 0.0, 1.0);
  Vec3 turn_slope;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = basis.row(i).transpose();
    if (i < 2) slope[i] = (moved(step * axis) - moved(-step * axis)) / (2.0 * step);
    turn_slope[i] = (turned(turn * axis) - turned(-turn * axis)) / (2.0 * turn);
  }
  const double scale = -stiffness * depth_now;
  return {scale * (basis.transpose() * slope), scale * (basis.transpose() * turn_slope)};
}

}  // namespace thigma
