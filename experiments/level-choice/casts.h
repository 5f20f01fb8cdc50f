#pragma once
// Scans of dental casts, which are not part of the project.

#include <optional>

#include "experiments/common/session_pair.h"

namespace thigma::experiments::level_choice {

/// The lower cast in the hand, under the upper one; none where the folder THIGMA_SHARED names has no such meshes.
/// Thread     [offline].
std::optional<SessionPair> casts_session(Assets& assets, double seconds);

}  // namespace thigma::experiments::level_choice
