#pragma once
// The built-in jaws, small enough to be built in every test, at full resolution.

#include "thigma/scene/scene_description.h"
#include "thigma/scene/scene_file.h"

namespace thigma::test {

inline SceneDescription small_jaws() {
  SceneDescription scene = read_scene("jaws");
  scene.object.model->triangles = 4000;
  scene.object.mesh = "procedural:jaw_upper?triangles=4000";
  scene.statics[0].model->triangles = 4000;
  scene.statics[0].mesh = "procedural:jaw_lower?triangles=4000";
  scene.contact.resolution.is_exact = true;
  return scene;
}

}  // namespace thigma::test
