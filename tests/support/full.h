#pragma once
// Whether tests run their full counts (scripts/test --full).

#include <cstdlib>

namespace thigma::test {

/// Set and not empty: scripts/test empties it for the presets that run the usual counts.
inline bool is_full() {
  const char* full = std::getenv("THIGMA_FULL");
  return full != nullptr && *full != '\0';
}

}  // namespace thigma::test
