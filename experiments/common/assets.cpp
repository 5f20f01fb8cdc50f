#include "experiments/common/assets.h"

#include <algorithm>

#include "thigma/clod/build_clod.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/start_placement.h"

namespace thigma::experiments {
namespace {

std::string with_count(const SceneObject& object, int triangles) {
  return model_uri(object.model->name, triangles > 0 ? triangles : object.model->triangles);
}

const ClodHierarchy& levels_of_file(Assets& assets, const SceneObject& object) {
  const std::string key = object.mesh + " at " + std::to_string(object.unit_scale);
  const auto known = assets.levels.find(key);
  if (known != assets.levels.end()) return known->second;
  ClodParams params;
  params.threads = 2;
  return assets.levels.emplace(key, build_clod(load_object(object).mesh, params)).first->second;
}

}  // namespace

std::string model_uri(const std::string& name, int triangles) {
  return "procedural:" + name + (triangles > 0 ? "?triangles=" + std::to_string(triangles) : "");
}

TriangleMesh make_mesh(const std::string& uri) {
  return models::make_model(models::parse_model_uri(uri, "experiment"));
}

const ClodHierarchy& levels_of(Assets& assets, const std::string& uri) {
  if (!assets.kept) return timed_levels_of(assets, uri);
  const auto known = assets.levels.find(uri);
  if (known != assets.levels.end()) return known->second;
  return assets.levels.emplace(uri, assets.kept(uri)).first->second;
}

const ClodHierarchy& timed_levels_of(Assets& assets, const std::string& uri) {
  if (assets.seconds.contains(uri)) return assets.levels.at(uri);
  const TriangleMesh mesh = make_mesh(uri);
  ClodParams params;
  params.threads = 2;
  const double start = process_cpu_seconds();
  ClodHierarchy levels = build_clod(mesh, params);
  assets.seconds[uri] = process_cpu_seconds() - start;
  // What was kept is the same; references to it stay.
  return assets.levels.emplace(uri, std::move(levels)).first->second;
}

void place_apart(Pair& pair, const Vec3& approach) {
  ContactWorld world;
  world.object = pair.object;
  world.scene = {SceneBody{pair.scene, pair.world_from_scene}};
  world.tolerance = 1e-4 * pair.radius;
  const Vec3 out = -approach;
  const StartPlacement placed = find_start(world, pair.start, 0.05 * pair.radius, &out);
  pair.start = placed.world_from_body;
  pair.approach = placed.approach;
  pair.clearance = placed.clearance;
}

Pair scene_pair(Assets& assets, const std::string& scene, int triangles, bool is_timed) {
  Pair pair = scene_pair(assets, parse_scene(builtin_scene(scene), scene, ""), triangles, is_timed);
  pair.name = scene;
  return pair;
}

Pair scene_pair(Assets& assets, const SceneDescription& description, int triangles, bool is_timed) {
  const SceneObject& body = description.statics.at(0);
  Pair pair;
  pair.name = description.title;
  const auto levels = [&](const SceneObject& object) {
    if (!object.model) return &levels_of_file(assets, object);
    return &(is_timed ? timed_levels_of : levels_of)(assets, with_count(object, triangles));
  };
  pair.object = levels(description.object);
  pair.scene = levels(body);
  pair.radius = std::min(pair.object->radius, pair.scene->radius);
  pair.start = description.object.world_from_mesh;
  pair.world_from_scene = body.world_from_mesh;
  place_apart(pair, description.device.approach.value_or(-Vec3::UnitZ()));
  return pair;
}

}  // namespace thigma::experiments
