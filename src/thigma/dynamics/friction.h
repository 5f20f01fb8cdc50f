#pragma once
// Coulomb's coefficients of two surfaces, and what two materials make of theirs.

#include <cmath>
#include <cstdint>

#include "thigma/core/rt.h"

namespace thigma {

/// Coulomb's coefficients of a material, or of two surfaces that touch. Dimensionless.
struct Friction {
  double kinetic = 0.0;  // while they slide, >= 0
  double at_rest = 0.0;  // until they do, >= kinetic
  friend bool operator==(const Friction&, const Friction&) = default;
};

/// What coefficients two materials make together.
enum class CombineRule : std::uint8_t { geometric, average, minimum, maximum };

/// Whether both are finite and in order.
/// Thread    [haptic].
inline bool is_valid(const Friction& f) THIGMA_RT {
  return f.kinetic >= 0.0 && f.at_rest >= f.kinetic && std::isfinite(f.at_rest);
}

/// Coefficients of two surfaces. By the geometric mean a surface without friction slides on
/// everything, and two of one material have what the material has.
/// Thread    [haptic]; valid where both are.
Friction combined(const Friction& a, const Friction& b, CombineRule rule) THIGMA_RT;

}  // namespace thigma
