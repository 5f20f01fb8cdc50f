#pragma once
// Scenes as TOML text: of scenes made on a page or a command line, and of those that are sent.

#include <string>

#include "thigma/scene/scene_description.h"

namespace thigma {

/// TOML of a scene: parse_scene gives the same scene from it, but for a rounding of quaternions
/// that were not read from TOML.
///
/// Objects, poses, materials, mass and title are those of the description. All other tables are
/// those of scene.text, where it was read from one; of a scene made in code they are written as far
/// as a pair of meshes has them: gravity, response, friction, device, safety, rate.
///
/// Thread  [offline]; InputError where scene.text is no TOML
std::string write_scene(const SceneDescription& scene);

/// The same with other names of the files: of an object's mesh or texture, as it is opened, the
/// name to write.
template <class Rename>
SceneDescription with_files(SceneDescription scene, const Rename& rename) {
  const auto rename_files = [&](SceneObject& object) {
    const bool is_file = !object.model && !object.textured_model;
    if (is_file) object.mesh = rename(object.mesh);
    if (!object.level_textures.empty()) object.level_textures = rename(object.level_textures);
  };
  rename_files(scene.object);
  for (SceneObject& body : scene.statics) rename_files(body);
  return scene;
}

}  // namespace thigma
