#pragma once

namespace thigma::test {

inline constexpr double kTick = 1e-3;  ///< of the devices under test [s]

}  // namespace thigma::test
