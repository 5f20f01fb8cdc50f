#pragma once
// Textures of a run: where they come from, and how the contact world gets them.

#include "clod_cache.h"
#include "run_session.h"

namespace thigma::app {

/// The coarse surface of a texture at full resolution, as an asset.
/// Thread [offline].
ClodAsset coarse_asset(const HapticTexture& texture);

/// The texture of an object that has one instead of a mesh; told.
/// Thread [offline]; InputError as load_texture.
BodyTextures load_relief(const scenes::SceneObject& object, const Tell& tell);

/// The textures over the levels of an object, null where a level has none; told.
///
/// coarsest  lowered to the coarsest level whose textures, and those of all finer ones, fit
/// Thread    [offline]; InputError as read_level_textures and check_level_textures.
BodyTextures load_level_relief(const scenes::SceneObject& object, const ClodAsset& asset,
                               const Tell& tell, std::int32_t& coarsest);

/// Hands textures to the contact world: of every body, or of none.
/// Thread [offline].
void use_textures(Run& run, const Tell& tell);

}  // namespace thigma::app
