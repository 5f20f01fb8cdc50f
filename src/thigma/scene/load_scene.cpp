#include "thigma/scene/load_scene.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <future>
#include <thread>
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

bool is_kept_file(const SceneObject& object) { return !object.model && is_clod_file(object.mesh); }

/// Whether levels that are not kept are left out. Textures of levels lie on them.
bool may_wait(const SceneObject& object, const LoadOptions& options) {
  return options.defers_levels && !is_kept_file(object) && object.level_textures.empty();
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
  const bool is_kept = is_kept_file(object);
  const AssetCache cache{options.keeps_levels, options.cache_folder};
  ClodAsset asset;
  if (is_exact && !is_kept) {
    asset = exact_asset(load_surface(source, options.log));
  } else if (may_wait(object, options)) {
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
    std::snprintf(line, sizeof line,
                  "%s: %d triangles, %zu convex patches, hierarchy of %zu levels, radius %.4g m",
                  object.name.c_str(), h.triangle_count, h.patches.size(), h.levels.size(),
                  h.radius);
    options.log(line);
  }
  return asset;
}

/// What loading an object gives.
struct LoadedSurface {
  std::shared_ptr<const ClodAsset> asset;
  BodyTextures textures;
  bool lacks_levels = false;
  std::int32_t coarsest = 0;      // of the levels a contact may be at
  std::vector<std::string> said;  // where it was not said at once
  std::exception_ptr failed;
};

/// An object, and what it is of.
struct ObjectToLoad {
  const SceneObject* object = nullptr;
  const char* role = "";
  bool is_exact = false;  // levels of detail are not asked for
};

LoadedSurface load_object(const ObjectToLoad& given, const LoadOptions& options,
                          std::int32_t coarsest) {
  const SceneObject& object = *given.object;
  LoadedSurface loaded;
  loaded.coarsest = coarsest;
  if (object.is_textured) {
    loaded.textures = detail::load_relief(object, options.log);
    loaded.asset = std::make_shared<const ClodAsset>(exact_asset(loaded.textures[0]->coarse));
    return loaded;
  }
  loaded.asset = std::make_shared<const ClodAsset>(
      load_asset(object, given.role, given.is_exact, options, loaded.lacks_levels));
  if (!object.level_textures.empty() && options.has_textures)
    loaded.textures =
        detail::load_level_relief(object, *loaded.asset, options.log, loaded.coarsest);
  return loaded;
}

/// Whether loading it may take minutes, with progress, and write a file.
bool builds_levels(const ObjectToLoad& given, const LoadOptions& options) {
  const SceneObject& object = *given.object;
  return !object.is_textured && !given.is_exact && !is_kept_file(object) &&
         !may_wait(object, options);
}

/// Objects of which none builds levels, side by side; what they say in their order afterwards.
std::vector<LoadedSurface> load_side_by_side(const std::vector<ObjectToLoad>& given,
                                             const LoadOptions& options, std::int32_t coarsest) {
  std::vector<LoadedSurface> loaded(given.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < given.size(); i = next++) {
      std::vector<std::string> said;
      LoadOptions quiet = options;
      if (options.log) quiet.log = [&said](const std::string& line) { said.push_back(line); };
      try {
        loaded[i] = load_object(given[i], quiet, coarsest);
      } catch (...) {
        loaded[i].failed = std::current_exception();
      }
      loaded[i].said = std::move(said);
    }
  };
  std::vector<std::future<void>> others;
  const std::size_t threads =
      std::min<std::size_t>(given.size(), std::max(1u, std::thread::hardware_concurrency()));
  for (std::size_t i = 1; i < threads; ++i) others.push_back(std::async(std::launch::async, work));
  work();
  for (std::future<void>& other : others) other.get();
  for (const LoadedSurface& one : loaded) {
    for (const std::string& line : one.said) options.log(line);
    if (one.failed) std::rethrow_exception(one.failed);
  }
  return loaded;
}

/// The object of a scene first, then what stands around it.
std::vector<LoadedSurface> load_objects(const std::vector<ObjectToLoad>& given,
                                        const LoadOptions& options, std::int32_t coarsest) {
  const bool is_quick = std::none_of(given.begin(), given.end(), [&](const ObjectToLoad& one) {
    return builds_levels(one, options);
  });
  if (is_quick) return load_side_by_side(given, options, coarsest);
  std::vector<LoadedSurface> loaded;
  for (const ObjectToLoad& one : given) loaded.push_back(load_object(one, options, coarsest));
  return loaded;
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
  LoadOptions used = options;
  used.repairs = given.repairs || options.repairs;
  std::vector<ObjectToLoad> wanted;
  const auto want = [&](const SceneObject& object, const char* role) {
    wanted.push_back({&object, role, resolution.is_exact && object.level_textures.empty()});
  };
  want(given.object, "--object");
  for (const SceneObject& other : given.statics) want(other, "--against");
  std::vector<LoadedSurface> loaded = load_objects(wanted, used, resolution.coarsest_level);
  std::int32_t coarsest = resolution.coarsest_level;
  for (const LoadedSurface& one : loaded) {
    scene.lacks_levels = scene.lacks_levels || one.lacks_levels;
    coarsest = std::min(coarsest, one.coarsest);
  }
  scene.object = loaded[0].asset;
  scene.object_textures = std::move(loaded[0].textures);
  std::vector<SceneBody> bodies;
  for (std::size_t i = 1; i < loaded.size(); ++i) {
    scene.static_textures.push_back(std::move(loaded[i].textures));
    scene.statics.push_back(loaded[i].asset);
    bodies.push_back({&scene.statics.back()->hierarchy, given.statics[i - 1].world_from_mesh});
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
