#include "thigma/scene/load_scene.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/scene/asset_cache.h"
#include "thigma/scene/detail/relief.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

/// The hierarchy of a mesh at full resolution, as an asset.
ClodAsset exact_asset(TriangleMesh mesh) {
  ClodAsset asset;
  asset.hierarchy = build_exact_hierarchy(mesh);
  asset.mass.measure = mass_properties(mesh);
  asset.meshes.push_back(std::move(mesh));
  return asset;
}

/// Surface, hierarchy and mass of an object: levels of detail where the session asks for them.
/// lacks_levels  set where they were left out
ClodAsset load_asset(const SceneObject& object, const char* role, bool is_exact,
                     const LoadOptions& options, bool& lacks_levels) {
  ClodSource source;
  source.name = object.mesh;
  source.role = role;
  source.scale = object.unit_scale;
  source.is_repair = options.repairs && !object.model;  // part of the key of kept levels
  const bool is_kept = !object.model && is_clod_file(object.mesh);
  const AssetCache cache{options.keeps_levels, options.cache_folder};
  // Textures of levels lie on them.
  const bool may_wait = options.defers_levels && !is_kept && object.level_textures.empty();
  ClodAsset asset;
  if (is_exact && !is_kept) {
    asset = exact_asset(load_surface(source, options.log));
  } else if (may_wait) {
    std::optional<ClodAsset> kept = find_clod_cached(source, cache, options.log);
    lacks_levels = lacks_levels || !kept;
    asset = kept ? std::move(*kept) : exact_asset(load_surface(source, options.log));
  } else {
    if (options.progress) {
      const std::string what = "building levels of " + object.name;
      source.progress = [&options, what](double share, double triangles) {
        options.progress(what, share, triangles);
      };
    }
    asset = load_clod_cached(source, cache, options.log);
  }
  const ClodHierarchy& h = asset.hierarchy;
  if (options.log) {
    char line[256];
    std::snprintf(
        line, sizeof line, "%s: %d triangles, %zu convex patches, %zu levels, radius %.4g m",
        object.name.c_str(), h.triangle_count, h.patches.size(), h.levels.size(), h.radius);
    options.log(line);
  }
  return asset;
}

}  // namespace

Scene load_scene(const std::string& path, const LoadOptions& options) {
  return load_scene(read_scene(path), options);
}

Scene load_scene(SceneDescription description, const LoadOptions& options) {
  Scene scene;
  scene.description = std::move(description);
  if (!scene.description.contact.response)
    scene.description.contact.response = default_response(scene.description, options.has_textures);
  const SceneDescription& given = scene.description;
  Resolution resolution = given.contact.resolution;
  // Rows and areas are of the finest surfaces: levels are built only where rows ask for them.
  const bool has_rows_alone =
      given.contact.response == ResponseKind::constrained && !given.contact.has_levels_far;
  const bool is_finest = has_rows_alone || given.contact.response == ResponseKind::potential;
  if (is_finest) resolution.is_exact = true;
  // A texture instead of a mesh lies over patches of the original surface alone.
  const auto replaces_mesh = [](const SceneObject& o) { return o.is_textured; };
  if (replaces_mesh(given.object) ||
      std::any_of(given.statics.begin(), given.statics.end(), replaces_mesh))
    resolution.is_exact = true;
  std::int32_t coarsest = resolution.coarsest_level;
  LoadOptions used = options;
  used.repairs = given.repairs || options.repairs;
  const auto load = [&](const SceneObject& object, const char* role, BodyTextures& textures) {
    if (object.is_textured) {
      textures = detail::load_relief(object, options.log);
      return std::make_shared<const ClodAsset>(exact_asset(textures[0]->coarse));
    }
    auto asset = std::make_shared<const ClodAsset>(
        load_asset(object, role, resolution.is_exact && object.level_textures.empty(), used,
                   scene.lacks_levels));
    if (!object.level_textures.empty() && options.has_textures)
      textures = detail::load_level_relief(object, *asset, options.log, coarsest);
    return asset;
  };
  scene.object = load(given.object, "--object", scene.object_textures);
  std::vector<SceneBody> bodies;
  for (const SceneObject& other : given.statics) {
    scene.static_textures.emplace_back();
    scene.statics.push_back(load(other, "--against", scene.static_textures.back()));
    bodies.push_back({&scene.statics.back()->hierarchy, other.world_from_mesh});
  }
  const ClodHierarchy& hierarchy = scene.object->hierarchy;
  scene.config =
      make_session_config(given, {scene.object->mass.measure, {hierarchy.center, hierarchy.radius}},
                          hierarchy, std::move(bodies));
  scene.config.contact.resolution.coarsest_level = coarsest;
  if (is_finest) scene.config.contact.resolution.is_exact = true;
  if (options.has_textures) detail::use_textures(options.log, scene);
  return scene;
}

}  // namespace thigma
