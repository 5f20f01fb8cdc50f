#pragma once
// A world that is quickly made and whose steps take little: what recordings of worlds are seeds of,
// and are replayed with.

#include <string>

#include "world_recorder.h"

#include "thigma/scene/world_scene.h"

namespace thigma::fuzz {

inline constexpr const char* kSmallWorld = R"(
[[static]]
name = "table"
mesh = "procedural:box?triangles=12"
unit_scale = 10.0
position = [0.0, 0.0, -0.2]

[[body]]
kind = "held"
name = "left"
mesh = "procedural:box?triangles=12"
unit_scale = 1.0
position = [0.0, 0.0, 0.05]
density = 1000.0

[[body]]
kind = "held"
name = "right"
mesh = "procedural:box?triangles=12"
unit_scale = 1.0
position = [0.1, 0.0, 0.05]
density = 1000.0

[[joint]]
kind = "slider"
name = "rail"
body = "right"
position = [0.1, 0.0, 0.05]
axis = [0.0, 0.0, 1.0]

[[device]]
holds = "left"
uri = "hand:?path=press"
clearance = 0.001
max_force = 5.0

[[device]]
holds = "right"
uri = "hand:"
max_force = 5.0
)";

inline LoadedWorld make_small_world(double rate, std::optional<double> friction) {
  WorldSceneDescription scene = parse_world_scene(kSmallWorld, "small", "/nowhere");
  scene.rate = rate;
  if (friction) app::use_friction(*friction, scene);
  return load_world(std::move(scene));
}

/// As most recordings have it, it is there already.
inline LoadedWorld small_world(double rate, std::optional<double> friction) {
  constexpr double kRate = 1000.0;  // [Hz]
  static const LoadedWorld usual = make_small_world(kRate, std::nullopt);
  return rate == kRate && !friction ? usual : make_small_world(rate, friction);
}

}  // namespace thigma::fuzz
