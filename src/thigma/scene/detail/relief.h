#pragma once
// Textures of a scene: where they come from, and how the contact world gets them.

#include "thigma/clod/clod_asset.h"
#include "thigma/scene/load_scene.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::detail {

/// The texture of an object that has one instead of a mesh; logged.
/// Thread [offline]; InputError as load_texture.
BodyTextures load_relief(const SceneObject& object, const Log& log);

/// The textures over the levels of an object, null where a level has none; logged.
///
/// coarsest  lowered to the coarsest level whose textures, and those of all finer ones, fit
/// Thread    [offline]; InputError as read_level_textures and check_level_textures.
BodyTextures load_level_relief(const SceneObject& object, const ClodAsset& asset, const Log& log,
                               std::int32_t& coarsest);

/// Hands the textures of a scene to its contact world: of every body, or of none.
/// Thread [offline].
void use_textures(const Log& log, Scene& scene);

}  // namespace thigma::detail
