// A chunk of a .tex file of levels holds the bytes of a whole .tex file.
#include "thigma/texture/level_textures.h"

#include <algorithm>
#include <charconv>

#include "thigma/files/file.h"
#include "thigma/mesh/measure.h"
#include "thigma/texture/detail/texture_error.h"

namespace thigma {
namespace {

using detail::fail;

constexpr std::string_view kCount = "levels", kLevel = "level_";
constexpr int kMostLevels = 1000;

/// The level a chunk is of, -1 of another chunk.
int level_of(const Chunk& chunk) {
  const std::string_view name = chunk.name;
  if (!name.starts_with(kLevel)) return -1;
  int level = -1;
  const char* const last = name.data() + name.size();
  const auto [end, error] = std::from_chars(name.data() + kLevel.size(), last, level);
  return error == std::errc() && end == last && level < kMostLevels ? level : -1;
}

/// Levels the file says it has.
int count_of(const std::vector<Chunk>& chunks, const std::string& name) {
  for (const Chunk& chunk : chunks) {
    if (chunk.name != kCount) continue;
    std::int32_t count = 0;
    if (chunk.bytes.size() != sizeof count) break;
    std::copy(chunk.bytes.begin(), chunk.bytes.end(), reinterpret_cast<char*>(&count));
    if (count < 1 || count > kMostLevels)
      fail(name, std::to_string(count) + " levels, in its table", "1 to 1000");
    return count;
  }
  fail(name, "no textures of levels, in its table", "what `thigma bake --onto F.clod` writes");
}

}  // namespace

std::string format_level_textures(const LevelTextures& textures) {
  std::vector<std::string> files;
  std::size_t bytes = 0, chunks = 1;
  for (const auto& level : textures.levels) {
    files.push_back(level ? format_texture(*level) : std::string());
    bytes += files.back().size();
    chunks += level ? 1 : 0;
  }
  ChunkWriter file(kTextureKind, chunks, bytes);
  file.begin(kCount, true, sizeof(std::int32_t));
  const auto count = static_cast<std::int32_t>(textures.levels.size());
  file.out().append(reinterpret_cast<const char*>(&count), sizeof count);
  for (std::size_t k = 0; k < files.size(); ++k) {
    if (!textures.levels[k]) continue;
    file.begin(std::string(kLevel) + std::to_string(k), true, 1);
    file.out() += files[k];
  }
  return file.finish();
}

LevelTextures parse_level_textures(std::string_view bytes, const std::string& name,
                                   double unit_scale) {
  const std::vector<Chunk> chunks = read_chunks(kTextureKind, bytes, name);
  LevelTextures textures;
  textures.levels.resize(static_cast<std::size_t>(count_of(chunks, name)));
  for (const Chunk& chunk : chunks) {
    const int level = level_of(chunk);
    if (level < 0) {
      if (chunk.is_required && chunk.name != kCount)
        fail(name, "needs what this version does not know, chunk " + chunk.name, "a newer thigma");
      continue;
    }
    if (static_cast<std::size_t>(level) >= textures.levels.size())
      fail(name, "a texture of level " + std::to_string(level) + ", in its table",
           "at most " + std::to_string(textures.levels.size() - 1));
    textures.levels[static_cast<std::size_t>(level)] =
        parse_texture(chunk.bytes, name + ", level " + std::to_string(level), unit_scale);
  }
  return textures;
}

LevelTextures read_level_textures(const std::string& path, double unit_scale) {
  return parse_level_textures(read_file(path), path, unit_scale);
}

void check_level_textures(const LevelTextures& textures, std::span<const TriangleMesh> levels,
                          const std::string& name) {
  if (textures.levels.size() != levels.size())
    fail(name, "textures of " + std::to_string(textures.levels.size()) + " levels, in its table",
         std::to_string(levels.size()) + ", as the levels of detail have");
  for (std::size_t k = 0; k < levels.size(); ++k) {
    if (!textures.levels[k]) continue;
    const TriangleMesh& own = textures.levels[k]->texture.coarse;
    const TriangleMesh& mesh = levels[k];
    bool is_same = own.triangles == mesh.triangles && own.positions.size() == mesh.positions.size();
    // Scaled twice, in another order: equal to rounding.
    const double slack = is_same ? 1e-9 * enclosing_ball(mesh.positions).radius : 0.0;
    for (std::size_t i = 0; is_same && i < own.positions.size(); ++i)
      is_same =
          (own.positions[i] - mesh.positions[i]).norm() <= slack + 1e-12 * mesh.positions[i].norm();
    if (!is_same)
      fail(name, "baked onto another surface, level " + std::to_string(k),
           "the levels of detail beside it");
  }
}

}  // namespace thigma
