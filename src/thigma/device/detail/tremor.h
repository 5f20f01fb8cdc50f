#pragma once
// Physiological tremor: a seeded sum of sines between 8 and 12 Hz on six axes.

#include <array>
#include <cmath>

#include "thigma/core/rt.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma::detail {

/// A function of time: no state to drift, the same for any step length.
struct Tremor {
  static constexpr int kWaves = 4;
  struct Wave {
    double frequency = 0.0;  // [Hz]
    double phase = 0.0;      // [turns]
  };
  std::array<std::array<Wave, kWaves>, 6> waves{};  // linear x y z, angular x y z

  explicit Tremor(std::uint64_t seed) THIGMA_RT {
    Random random(seed);
    for (auto& axis : waves) {
      for (Wave& wave : axis) {
        wave.frequency = random.uniform(8.0, 12.0);
        wave.phase = random.uniform();
      }
    }
  }

  /// Root mean square 1 over long times; grows from 0 during the first half second.
  double value(int axis, double time) const THIGMA_RT {
    double sum = 0.0;
    for (const Wave& wave : waves[static_cast<std::size_t>(axis)]) {
      const double turns = wave.frequency * time + wave.phase;
      sum += sine(2.0 * kPi * (turns - std::floor(turns)));
    }
    const double fade = time < 0.5 ? 2.0 * time : 1.0;
    return fade * sum *
           0.70710678118654752;  // each of four sines contributes 1/2 to the mean square
  }
};

}  // namespace thigma::detail
