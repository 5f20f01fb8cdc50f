#pragma once
// The ridges that the block and the gear of Fig. 4.11 have in common.

#include <algorithm>
#include <cmath>
#include <functional>

namespace thigma::models {

inline constexpr double kRidgeHeight = 0.002, kRidgePitch = 0.010;  // [m]; the text tells no size

/// Height of ridges over half their height, -1 to 1, over the place along the surface in pitches.
using RidgeProfile = std::function<double(double turns)>;

/// Half of a flank as a share of the pitch: a quarter of the pitch each for top, flank, bottom and
/// flank.
inline constexpr double kRidgeFlank = 0.125;

/// A RidgeProfile with flat tops and straight flanks, as teeth have them: -1 in a groove, 1 on a
/// top. Odd about 0 as a sine is, so that two such surfaces lie in each other.
///
/// turns  place along the surface over the pitch
/// flank  half of a flank over the pitch, above 0; 0.25: no top is left
inline double flat_ridge(double turns, double flank = kRidgeFlank) {
  const double place = turns - std::floor(turns);
  const double from_middle = place < 0.25 ? place : place < 0.75 ? 0.5 - place : place - 1.0;
  return std::clamp(from_middle / flank, -1.0, 1.0);
}

}  // namespace thigma::models
