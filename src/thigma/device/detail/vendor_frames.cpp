#include "thigma/device/detail/vendor_frames.h"

#include <cmath>
#include <limits>

namespace thigma::detail {

bool nearest_rotation(const Mat3& matrix, Quat& rotation) THIGMA_RT {
  if (!matrix.allFinite()) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    rotation = Quat(nan, nan, nan, nan);
    return true;
  }
  constexpr double kMostOff = 0.05;
  const Mat3 off = matrix.transpose() * matrix - Mat3::Identity();
  if (off.cwiseAbs().maxCoeff() > kMostOff || matrix.determinant() < 0.0) return false;
  // Newton's steps for the polar factor: 0.05 off becomes 1e-3, 1e-7, rounding.
  Mat3 r = matrix;
  for (int step = 0; step < 4; ++step) {
    const Mat3 inverse_transpose = r.inverse().transpose();
    r = 0.5 * (r + inverse_transpose);
  }
  rotation = Quat(r);
  rotation.normalize();
  return true;
}

Wrench sendable(const Wrench& wrench, const DeviceLimits& limits) THIGMA_RT {
  if (!wrench.force.allFinite() || !wrench.torque.allFinite()) return {};
  const auto cut = [](const Vec3& part, double most) -> Vec3 {
    const double norm = part.norm();
    return norm > most ? Vec3(part * (most / norm)) : part;
  };
  Wrench sent;
  if (limits.actuates_translation) sent.force = cut(wrench.force, limits.max_force);
  if (limits.actuates_rotation) sent.torque = cut(wrench.torque, limits.max_torque);
  return sent;
}

}  // namespace thigma::detail
