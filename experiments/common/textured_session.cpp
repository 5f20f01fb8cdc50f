#include "experiments/common/textured_session.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/measure.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/scene/scene_file.h"

namespace thigma::experiments {
namespace {

std::unique_ptr<TexturedSession::Body> load_body(
    const SceneObject& object, const std::function<HapticTexture(const SceneObject&)>& make) {
  auto body = std::make_unique<TexturedSession::Body>();
  if (!object.is_textured)
    body->texture = make_plain_texture(load_object(object).mesh, object.name);
  else
    body->texture = make ? make(object) : load_texture(object);
  body->hierarchy = build_exact_hierarchy(body->texture.coarse);
  return body;
}

}  // namespace

std::unique_ptr<TexturedSession> textured_session(
    const std::string& scene, bool is_textured,
    const std::function<void(SceneDescription&)>& change,
    const std::function<HapticTexture(const SceneObject&)>& make) {
  auto session = std::make_unique<TexturedSession>();
  session->scene = parse_scene(builtin_scene(scene), scene, "");
  if (change) change(session->scene);
  session->object = load_body(session->scene.object, make);
  const TriangleMesh& mesh = session->object->texture.coarse;
  std::vector<SceneBody> bodies;
  for (const SceneObject& other : session->scene.statics) {
    session->statics.push_back(load_body(other, make));
    bodies.push_back({&session->statics.back()->hierarchy, other.world_from_mesh});
  }
  session->config =
      make_session_config(session->scene, {mass_properties(mesh), enclosing_ball(mesh.positions)},
                          session->object->hierarchy, std::move(bodies));
  ContactWorld& world = session->config.contact;
  const auto textured = [](const TexturedSession::Body& body) {
    return make_textured_body(body.texture, body.hierarchy);
  };
  if (!is_textured) return session;
  world.textures.object = textured(*session->object);
  for (const auto& other : session->statics) world.textures.scene.push_back(textured(*other));
  return session;
}

ScriptRun run_script(TexturedSession& session, double seconds,
                     const std::function<Pose(double)>& pose) {
  const Pose start = session.config.world_from_body;
  constexpr double kRow = 0.005;  // [s]: between rows the motion is smooth
  // of large and small objects not 1
  const double scale = session.config.haptic.workspace.motion_scale;
  std::vector<TimedPose> script;
  for (int i = 0; i <= static_cast<int>(seconds / kRow); ++i) {
    const Pose by = pose(kRow * i);
    TimedPose row;
    row.time = kRow * i;
    row.pose.position = by.position / scale;
    row.pose.orientation = by.orientation;
    script.push_back(row);
  }
  const std::unique_ptr<HapticDevice> device = make_script_device(std::move(script));
  SessionConfig config = session.config;
  config.world_from_body = start;
  config.duration = seconds;
  config.haptic.device = device->limits();
  ScriptRun run;
  run.summary = run_lockstep(config, *device,
                             {.haptic = [&](const HapticSample& s) { run.frames.push_back(s); },
                              .contact = [&](const ContactSample& s) { run.contacts.push_back(s); },
                              .event = {}});
  return run;
}

}  // namespace thigma::experiments
