#include "scene_of_meshes.h"

#include <memory>
#include <utility>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_asset.h"

namespace thigma::bindings {
namespace {

std::shared_ptr<const ClodAsset> exact_asset(const TriangleMesh& mesh) {
  ClodAsset asset;
  asset.hierarchy = build_exact_hierarchy(mesh);
  asset.mass.measure = mass_properties(mesh);
  asset.meshes.push_back(mesh);
  return std::make_shared<const ClodAsset>(std::move(asset));
}

SceneObject in_memory(const char* name) {
  SceneObject object;
  object.name = name;
  object.mesh = name;
  return object;
}

}  // namespace

Scene scene_of_meshes(const TriangleMesh& object, const TriangleMesh& against,
                      const Pose& world_from_mesh, std::optional<ResponseKind> response) {
  Scene scene;
  SceneDescription& description = scene.description;
  description.file = description.title = "meshes in memory";
  description.object = in_memory("object");
  description.object.world_from_mesh = world_from_mesh;
  description.statics.push_back(in_memory("against"));
  description.contact.response = response.value_or(ResponseKind::constrained);
  description.contact.resolution.is_exact = true;
  scene.object = exact_asset(object);
  scene.statics.push_back(exact_asset(against));
  const ClodHierarchy& hierarchy = scene.object->hierarchy;
  scene.config = make_session_config(
      description, {scene.object->mass.measure, {hierarchy.center, hierarchy.radius}}, hierarchy,
      {{&scene.statics[0]->hierarchy, Pose{}}});
  scene.config.contact.resolution.is_exact = true;
  return scene;
}

}  // namespace thigma::bindings
