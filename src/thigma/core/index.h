#pragma once
// Meshes and trees keep their indices in 32 bits with a sign (negative: none); containers ask for
// std::size_t.

#include <cstddef>
#include <cstdint>

namespace thigma {

/// i as an index of a container. i must not be negative.
[[nodiscard]] constexpr std::size_t idx(std::int32_t i) noexcept {
  return static_cast<std::size_t>(i);
}

}  // namespace thigma
