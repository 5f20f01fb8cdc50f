#include "thigma/scene/detail/relief.h"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <utility>

#include "thigma/response/texture_contacts.h"
#include "thigma/texture/level_textures.h"

namespace thigma::detail {
namespace {

void log_relief(const Log& log, const std::string& name, const HapticTexture& texture) {
  if (!log) return;
  char line[256];
  std::snprintf(line, sizeof line, "%s: %d x %d texels of %.3g mm, relief +-%.3g mm", name.c_str(),
                texture.width, texture.height, 1e3 * texture.texel_size, 1e3 * texture.amplitude);
  log(line);
}

/// Of the radius: where a texture fits its level worse than this, contacts are refined to a finer
/// one.
constexpr double kWorstFit = 0.005;

/// The coarsest level up to which all textures fit.
std::int32_t coarsest_fitting(const LevelTextures& textures, double radius) {
  std::int32_t coarsest = -1;
  for (const auto& level : textures.levels) {
    if (level && level->figures.fit_error_max.value_or(0.0) > kWorstFit * radius) break;
    ++coarsest;
  }
  return std::max(coarsest, 0);
}

/// Logs a line once, though a session and what places its object both have something to say. Any
/// thread.
Log log_once(const Log& log) {
  struct Last {
    std::mutex mutex;
    std::string line;
  };
  if (!log) return {};
  return [log, last = std::make_shared<Last>()](const std::string& line) {
    const std::lock_guard<std::mutex> lock(last->mutex);
    if (std::exchange(last->line, line) != line) log(line);
  };
}

/// A body for the contact world; levels without relief get a texture of one texel.
TexturedBody textured_body(BodyTextures& textures, const ClodAsset& asset,
                           const std::string& name) {
  textures.resize(asset.meshes.size());
  std::vector<const HapticTexture*> all;
  for (std::size_t k = 0; k < textures.size(); ++k) {
    if (!textures[k])
      textures[k] =
          std::make_shared<const HapticTexture>(make_plain_texture(asset.meshes[k], name));
    all.push_back(textures[k].get());
  }
  return make_textured_levels(std::move(all), asset.hierarchy);
}

}  // namespace

BodyTextures load_relief(const SceneObject& object, const Log& log) {
  BodyTextures textures;
  textures.push_back(std::make_shared<const HapticTexture>(load_texture(object)));
  log_relief(log, object.name, *textures.back());
  return textures;
}

BodyTextures load_level_relief(const SceneObject& object, const ClodAsset& asset, const Log& log,
                               std::int32_t& coarsest) {
  LevelTextures file = read_level_textures(object.level_textures, object.unit_scale);
  check_level_textures(file, asset.meshes, object.level_textures);
  const std::int32_t own = coarsest_fitting(file, asset.hierarchy.radius);
  coarsest = std::min(coarsest, own);
  if (log && own + 1 < static_cast<std::int32_t>(file.levels.size()))
    log(object.name + ": textures of levels " + std::to_string(own + 1) +
        " and coarser fit worse than 0.5 % of the radius; contacts are of level " +
        std::to_string(own) + " or finer");
  BodyTextures textures;
  for (std::size_t k = 0; k < file.levels.size(); ++k) {
    textures.emplace_back();
    if (!file.levels[k]) continue;
    textures.back() = std::make_shared<const HapticTexture>(std::move(file.levels[k]->texture));
    log_relief(log, object.name + ", level " + std::to_string(k), *textures.back());
  }
  return textures;
}

void use_textures(const Log& log, Scene& scene) {
  const auto has_some = [](const BodyTextures& textures) { return !textures.empty(); };
  if (scene.object_textures.empty() &&
      std::none_of(scene.static_textures.begin(), scene.static_textures.end(), has_some)) {
    scene.static_textures.clear();
    return;
  }
  TexturedWorld& world = scene.config.contact.textures;
  world.warn = log_once(log);
  world.object = textured_body(scene.object_textures, *scene.object, scene.description.object.name);
  for (std::size_t i = 0; i < scene.statics.size(); ++i)
    world.scene.push_back(textured_body(scene.static_textures[i], *scene.statics[i],
                                        scene.description.statics[i].name));
}

}  // namespace thigma::detail
