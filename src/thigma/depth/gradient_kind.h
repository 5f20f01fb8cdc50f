#pragma once
// Ways to the gradient of directional depth.

#include <cstdint>

namespace thigma {

/// Ways to the gradient. docs/journal/textures.md compares them.
enum class GradientKind : std::uint8_t {
  // Eq. 4.8 over the moved configurations: smooth over one step, blind below it
  central_differences,
  // slopes of the two surfaces where the depth is: exact, jumps when the maximum switches places
  envelope,
  smoothed_envelope,  // the same, averaged over all places whose depth is near the maximum
};

}  // namespace thigma
