#pragma once
// Quaternions as four numbers q = (x, y, z, s), and their derivatives (Appendix A).
//
// R(q) is the homogeneous quadratic form A.21: |q|^2 times a rotation. Derivatives by q are those
// of that polynomial in the four ambient numbers (A.23). A rotation-vector perturbation q <-
// exp(phi) q has d/dphi = d/dq * Q(q).

#include <array>
#include <cmath>

#include "thigma/core/rt.h"
#include "thigma/math/types.h"

namespace thigma {

/// u^* with u^* v = u x v (A.5).
/// Thread    [haptic].
inline Mat3 skew(const Vec3& u) THIGMA_RT {
  Mat3 m;
  m << 0.0, -u.z(), u.y(), u.z(), 0.0, -u.x(), -u.y(), u.x(), 0.0;
  return m;
}

/// R(q), Eq. A.21, homogeneous: R(2 q) = 4 R(q).
/// Thread    [haptic].
Mat3 rotation_matrix(const Quat& q) THIGMA_RT;

/// dR/dq_i for i = x, y, z, s (A.23).
/// Thread    [haptic].
std::array<Mat3, 4> rotation_matrix_derivatives(const Quat& q) THIGMA_RT;

/// d(R(q) v)/dq and d(R(q)^T v)/dq for a fixed v (3 x 4).
/// Thread    [haptic].
Mat34 rotated_derivative(const Quat& q, const Vec3& v) THIGMA_RT;
Mat34 inverse_rotated_derivative(const Quat& q, const Vec3& v) THIGMA_RT;

/// Q(q) with dq/dt = Q(q) omega, omega in the world frame (A.25); Q^T Q = |q|^2 / 4.
/// Thread [haptic].
Mat43 rate_matrix(const Quat& q) THIGMA_RT;

/// d(Q(q) omega)/dq for a fixed omega (4 x 4); Q is linear in q, so this does not depend on q.
/// Thread [haptic].
Mat4 rate_derivative(const Vec3& omega) THIGMA_RT;

/// A(a) with a b = A(a) b as four numbers (A.15).
/// Thread    [haptic].
Mat4 left_product_matrix(const Quat& a) THIGMA_RT;

/// Unit quaternion of a rotation vector [rad] (A.18); exact to rounding at and near zero.
/// Thread [haptic].
Quat rotation_from_vector(const Vec3& rotation_vector) THIGMA_RT;

/// Rotation vector of q, the shorter way round: |u| <= pi, q and -q give the same u.
///
/// q           any length but zero; the result does not depend on it
/// derivative  null, or du/dq (3 x 4), of the cover that q lies on
/// returns     u = 2 atan2(|v|, s) v / |v| for (v, s) = +-q with s >= 0 [rad]
/// Thread      [haptic]; discontinuous at half turns only.
/// Source      Eqs. 5.18, 5.25; the printed ones lack 1/sin(|u|/2) and are singular at rest.
Vec3 vector_from_rotation(const Quat& q, Mat34* derivative = nullptr) THIGMA_RT;

/// q / |q|, by one square root.
/// Thread    [haptic].
inline Quat unit(const Quat& q) THIGMA_RT {
  const double scale =
      1.0 / std::sqrt(q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w());
  return Quat(q.w() * scale, q.x() * scale, q.y() * scale, q.z() * scale);
}

}  // namespace thigma
