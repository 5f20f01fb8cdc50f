#include "experiments/common/session_pair.h"

#include "scenes/scene_description.h"
#include "scenes/scene_file.h"

#include "thigma/mesh/measure.h"
#include "thigma/runtime/placement.h"

namespace thigma::experiments {

SessionPair session_pair(Assets& assets, const std::string& scene, double seconds, int triangles) {
  SessionPair session = session_pair(
      assets, scenes::parse_scene(scenes::builtin_scene(scene), scene, ""), seconds, triangles);
  session.name = scene;
  return session;
}

SessionPair session_pair(Assets& assets, const scenes::SceneDescription& description,
                         double seconds, int triangles) {
  const Pair pair = scene_pair(assets, description, triangles);
  scenes::LoadedObject object;
  object.measure = description.object.model
                       ? mass_properties(scenes::make_model(*description.object.model))
                       : scenes::load_object(description.object).measure;
  object.ball = {pair.object->center, pair.object->radius};
  SessionPair session;
  session.name = description.title;
  session.config = scenes::make_session_config(description, object);
  session.config.duration = seconds;
  session.config.contact.object = pair.object;
  session.config.contact.scene = {SceneBody{pair.scene, pair.world_from_scene}};
  const std::optional<Vec3>& approach = description.device.approach;
  const Vec3 out = approach ? Vec3(-*approach) : Vec3::Zero();
  const StartPlacement start = find_start(session.config.contact, session.config.world_from_body,
                                          0.0, approach ? &out : nullptr);
  session.config.world_from_body = start.world_from_body;
  const Workspace& workspace = session.config.haptic.workspace;
  session.hand.approach =
      workspace.world_from_device.orientation.conjugate()._transformVector(start.approach);
  session.hand.clearance = start.clearance / workspace.motion_scale;
  session.hand.object_radius = pair.object->radius / workspace.motion_scale;
  return session;
}

}  // namespace thigma::experiments
