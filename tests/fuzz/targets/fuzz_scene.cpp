#include <cmath>

#include "fuzz/fuzz_target.h"

#include "thigma/loop/safety_fields.h"
#include "thigma/scene/scene_file.h"

namespace thigma::fuzz {

void fuzz_scene(Bytes bytes) {
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
