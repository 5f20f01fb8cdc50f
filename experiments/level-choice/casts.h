#pragma once
// Scans of dental casts, which are not part of the project.

#include <optional>

#include "thigma/scene/scene_description.h"

namespace thigma::experiments::level_choice {

/// The lower cast in the hand, under the upper one; none where the folder THIGMA_SHARED names has
/// no such meshes.
/// Thread     [offline].
std::optional<SceneDescription> casts_scene();

}  // namespace thigma::experiments::level_choice
