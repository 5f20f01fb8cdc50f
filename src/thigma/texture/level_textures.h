#pragma once
// Haptic textures over the levels of detail of a .clod: on each the same fine surface.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/texture/texture_file.h"

namespace thigma {

/// By level, 0 the finest. None: the level is the fine surface itself, or close enough to need no
/// relief.
struct LevelTextures {
  std::vector<std::optional<TextureAsset>> levels;
};

/// The bytes of a .tex file of levels: one .tex file a level in it. Same textures, same bytes.
/// Thread  [offline]; no failure for at most 1000 levels.
std::string format_level_textures(const LevelTextures& textures);

/// Reads what format_level_textures wrote; as parse_texture.
LevelTextures parse_level_textures(std::string_view bytes, const std::string& name,
                                   double unit_scale = 1.0);

/// The same of a file. Throws InputError, too, when it cannot be read.
LevelTextures read_level_textures(const std::string& path, double unit_scale = 1.0);

/// Refuses textures over other levels.
///
/// levels  surfaces of all levels that are not free
/// name    of the textures, for messages
/// Thread  [offline]; throws InputError: other numbers of levels, vertices or triangles, vertices
///         elsewhere.
void check_level_textures(const LevelTextures& textures, std::span<const TriangleMesh> levels,
                          const std::string& name);

}  // namespace thigma
