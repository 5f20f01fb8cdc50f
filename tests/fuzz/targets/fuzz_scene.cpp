#include <cmath>

#include "fuzz/fuzz_target.h"

#include "thigma/loop/safety_fields.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/world_scene.h"

namespace thigma::fuzz {

namespace {

/// The same text as a scene of several moving bodies.
void read_world(Bytes bytes) {
  WorldSceneDescription world;
  if (!is_taken("scene", [&] { world = parse_world_scene(text_of(bytes), "scene", "/nowhere"); }))
    return;
  require(!world.bodies.empty() && world.bodies.size() <= 1000, "bodies are bounded");
  require(world.rate >= 50.0 && world.rate <= 20000.0, "the rate is in range");
  for (const WorldSceneBody& body : world.bodies) {
    const bool has_mass = body.kind == BodyKind::moving || body.kind == BodyKind::held;
    require(!has_mass || body.mass || body.density, "what moves has a mass");
    require(!body.object.name.empty(), "bodies have names");
  }
}

}  // namespace

void fuzz_scene(Bytes bytes) {
  read_world(bytes);
  SceneDescription scene;
  if (!is_taken("scene", [&] { scene = parse_scene(text_of(bytes), "scene", "/nowhere"); })) return;
  const SafetyLimits& s = scene.safety;
  visit_safety_limits(s, [](const char*, double limit) {
    require(limit > 0.0 && std::isfinite(limit), "limits are positive");
  });
  require(s.model_full_age < s.model_stale_age, "models have time to fade");
  require(s.rows_full_age < s.rows_stale_age, "rows have time to fade");
  require(scene.rate >= 50.0 && scene.rate <= 20000.0, "the rate is in range");
}

}  // namespace thigma::fuzz
