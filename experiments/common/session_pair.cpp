#include "experiments/common/session_pair.h"

#include "thigma/mesh/measure.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/scene_description.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/start_placement.h"

namespace thigma::experiments {

SessionPair session_pair(Assets& assets, const std::string& scene, double seconds, int triangles) {
  SessionPair session =
      session_pair(assets, parse_scene(builtin_scene(scene), scene, ""), seconds, triangles);
  session.name = scene;
  return session;
}

SessionPair session_pair(Assets& assets, const SceneDescription& description, double seconds,
                         int triangles) {
  const Pair pair = scene_pair(assets, description, triangles);
  ObjectMeasure object;
  object.measure = description.object.model
                       ? mass_properties(models::make_model(*description.object.model))
                       : load_object(description.object).measure;
  object.ball = {pair.object->center, pair.object->radius};
  SessionPair session;
  session.name = description.title;
  session.config =
      make_session_config(description, object, *pair.object, {{pair.scene, pair.world_from_scene}});
  session.config.duration = seconds;
  const StartPlacement start = place_at_start(description.device.approach, session.config);
  session.hand = device_context(session.config, start, pair.object->radius);
  return session;
}

}  // namespace thigma::experiments
