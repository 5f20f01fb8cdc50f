#pragma once
// Seeded random numbers with the same sequence everywhere; std::distributions differ between
// libraries.

#include <cmath>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/math/types.h"

namespace thigma {

/// SplitMix64. Two generators of different seeds are independent for all purposes here.
struct Random {
  std::uint64_t state = 0;

  explicit Random(std::uint64_t seed = 0) THIGMA_RT : state(seed) {}

  std::uint64_t next() THIGMA_RT {
    state += 0x9e3779b97f4a7c15ull;
    std::uint64_t z = state;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1).
  double uniform() THIGMA_RT { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double uniform(double low, double high) THIGMA_RT { return low + (high - low) * uniform(); }
  /// Uniform in 0..n-1, n >= 1 (bias below 2^-32 for n < 2^32).
  std::uint64_t below(std::uint64_t n) THIGMA_RT { return next() % n; }
  /// Mean 0, deviation 1: the sum of twelve uniforms, so within +-6 by construction.
  double normal() THIGMA_RT {
    double s = -6.0;
    for (int i = 0; i < 12; ++i) s += uniform();
    return s;
  }
  Vec3 in_cube(double half) THIGMA_RT {
    const double x = uniform(-half, half);
    const double y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
  /// Uniform on the unit sphere, by rejection.
  Vec3 direction() THIGMA_RT {
    for (;;) {
      const Vec3 v = in_cube(1.0);
      const double n2 = v.squaredNorm();
      if (n2 > 1e-4 && n2 <= 1.0) return v / std::sqrt(n2);
    }
  }
  /// Uniform on the rotations, by rejection.
  Quat orientation() THIGMA_RT {
    for (;;) {
      const Vec3 v = in_cube(1.0);
      const double w = uniform(-1.0, 1.0);
      const double n2 = v.squaredNorm() + w * w;
      if (n2 > 1e-4 && n2 <= 1.0) {
        const double s = 1.0 / std::sqrt(n2);
        return Quat(w * s, v.x() * s, v.y() * s, v.z() * s);
      }
    }
  }
};

}  // namespace thigma
