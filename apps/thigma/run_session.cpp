#include "run_session.h"

#include <cstdio>

#include "scenes/scene_file.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/device/replay.h"
#include "thigma/runtime/config_json.h"
#include "thigma/runtime/recording.h"

namespace thigma::app {
namespace {

ClodHierarchy build(const scenes::SceneObject& object, const scenes::LoadedObject& loaded,
                    const std::function<void(const std::string&)>& tell) {
  BuildReport report;
  ClodHierarchy hierarchy = build_exact_hierarchy(loaded.mesh, {}, &report);
  if (tell) {
    char line[256];
    std::snprintf(line, sizeof line,
                  "%s: %d triangles, %d convex patches, radius %.4g m, built in %.1f s",
                  object.name.c_str(), report.triangles, report.patches, loaded.ball.radius,
                  report.decompose_seconds + report.hierarchy_seconds);
    tell(line);
  }
  return hierarchy;
}

void apply_options(const RunOptions& options, SessionConfig& config) {
  config.duration = options.duration;
  config.rate = options.rate.value_or(config.rate);
  config.faults = parse_faults(options.fault_text);
}

/// Only a hand comes to the object by itself; scripts and people start where the scene says.
void place(Run& run, const std::function<void(const std::string&)>& tell) {
  const Vec3* approach = run.scene.device.approach ? &*run.scene.device.approach : nullptr;
  const Vec3 out = approach != nullptr ? Vec3(-*approach) : Vec3::Zero();
  run.start = find_start(run.config.contact, run.config.world_from_body, 0.0,
                         approach != nullptr ? &out : nullptr);
  run.config.world_from_body = run.start.world_from_body;
  if (!tell) return;
  char line[200];
  std::snprintf(line, sizeof line, "%s; %.3g mm to the first touch",
                run.start.is_moved
                    ? "the objects touch or overlap as given: moved apart along the closest points"
                    : "the objects start where the scene puts them",
                1e3 * run.start.clearance);
  tell(run.start.has_scene ? line : "nothing to touch is near");
}

DeviceContext context_of(const Run& run, std::uint64_t seed) {
  const Workspace& workspace = run.config.haptic.workspace;
  DeviceContext context;
  context.approach =
      workspace.world_from_device.orientation.conjugate()._transformVector(run.start.approach);
  context.clearance = run.start.clearance / workspace.motion_scale;
  context.object_radius = run.object_radius / workspace.motion_scale;
  context.seed = seed;
  return context;
}

std::unique_ptr<HapticDevice> open_recorded(const std::string& path) {
  const Recording recording = read_recording(path);
  std::vector<DeviceState> samples;
  samples.reserve(recording.frames.size());
  for (const HapticSample& frame : recording.frames) samples.push_back(frame.device);
  try {
    return make_replay_device(std::move(samples), read_config(recording.config).params.device);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace

std::unique_ptr<Run> prepare_run(const RunOptions& options, std::uint64_t seed,
                                 const std::function<void(const std::string&)>& tell) {
  auto run = std::make_unique<Run>();
  run->scene = options.scene.empty()
                   ? scenes::scene_from_pair(
                         options.object, options.against, options.scale,
                         options.pose_text.empty() ? Pose{} : *parse_pose(options.pose_text))
                   : scenes::read_scene(options.scene);
  run->device_uri = options.device.empty() ? run->scene.device.uri : options.device;

  const scenes::LoadedObject object = scenes::load_object(run->scene.object, options.is_repair);
  run->object_radius = object.ball.radius;
  run->config = scenes::make_session_config(run->scene, object);
  run->object = build(run->scene.object, object, tell);
  run->config.contact.object = &run->object;
  for (const scenes::SceneObject& other : run->scene.statics) {
    const scenes::LoadedObject loaded = scenes::load_object(other, options.is_repair);
    run->statics.push_back(std::make_unique<ClodHierarchy>(build(other, loaded, tell)));
    run->config.contact.scene.push_back({run->statics.back().get(), other.world_from_mesh});
  }
  apply_options(options, run->config);

  const std::string scheme = device_scheme(run->device_uri);
  if (scheme == "hand") place(*run, tell);
  run->device = scheme == "replay" ? open_recorded(run->device_uri.substr(scheme.size() + 1))
                                   : open_device(run->device_uri, context_of(*run, seed));
  run->config.haptic.device = run->device->limits();
  return run;
}

}  // namespace thigma::app
