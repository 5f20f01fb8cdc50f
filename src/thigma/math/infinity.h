#pragma once
#include <limits>

namespace thigma {

/// Beyond every length, force and time: where a least value starts.
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace thigma
