#pragma once
// A texel, and bounds of texels, in double precision.

#include "thigma/texture/haptic_texture.h"

namespace thigma::detail {

/// With its fourth float, which is 0: two vector registers instead of three numbers.
inline Eigen::Vector4d texel_vector(const Texel& t) noexcept {
  return Eigen::Map<const Eigen::Vector4f, Eigen::Aligned16>(&t.x).cast<double>();
}

/// Largest product of a vector with a displacement within bounds.
inline double largest_along(const Vec3& m, const TexelBounds& b) noexcept {
  const Eigen::Vector4d m4(m.x(), m.y(), m.z(), 0.0);
  return m4.cwiseProduct(texel_vector(b.low)).cwiseMax(m4.cwiseProduct(texel_vector(b.high))).sum();
}

}  // namespace thigma::detail
