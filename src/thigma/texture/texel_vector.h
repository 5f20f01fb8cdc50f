#pragma once
// A texel in double precision.

#include "thigma/texture/haptic_texture.h"

namespace thigma::detail {

/// With its fourth float, which is 0: two vector registers instead of three numbers.
inline Eigen::Vector4d texel_vector(const Texel& t) noexcept {
  return Eigen::Map<const Eigen::Vector4f, Eigen::Aligned16>(&t.x).cast<double>();
}

}  // namespace thigma::detail
