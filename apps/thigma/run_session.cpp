#include "run_session.h"

#include <cmath>
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
  config.duration = options.duration.value_or(0.0);
  config.rate = options.rate.value_or(config.rate);
  config.faults = parse_faults(options.fault_text);
}

/// What find_start did, for people.
std::string placement_line(const StartPlacement& start, bool has_approach) {
  if (!start.has_scene) return "nothing to touch is near";
  char line[240];
  const char* way = has_approach ? "against its approach" : "along the closest points";
  const double gap = 1e3 * start.given_gap, clearance = 1e3 * start.clearance;
  if (!start.is_moved) {
    std::snprintf(line, sizeof line,
                  "the objects start as given, %.3g mm apart; %.3g mm to the first touch", gap,
                  clearance);
  } else if (gap < 0.0) {
    std::snprintf(line, sizeof line,
                  "the objects overlap as given: moved apart %s; %.3g mm to the first touch", way,
                  clearance);
  } else {
    std::snprintf(line, sizeof line,
                  "the objects touch as given (%.3g mm apart, within twice the tolerance): moved "
                  "apart %s; %.3g mm to the first touch",
                  std::abs(gap), way, clearance);
  }
  return line;
}

/// Only a hand comes to the object by itself; scripts and people start where the scene says.
void place(Run& run, const std::function<void(const std::string&)>& tell) {
  const Vec3* approach = run.scene.device.approach ? &*run.scene.device.approach : nullptr;
  const Vec3 out = approach != nullptr ? Vec3(-*approach) : Vec3::Zero();
  run.start = find_start(run.config.contact, run.config.world_from_body, 0.0,
                         approach != nullptr ? &out : nullptr);
  run.config.world_from_body = run.start.world_from_body;
  if (tell) tell(placement_line(run.start, approach != nullptr));
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

/// The samples of a recording as a device. Forces come out as recorded only from where that session
/// started and at its rate, so both are taken over.
std::unique_ptr<HapticDevice> open_recorded(const std::string& path, const RunOptions& options,
                                            SessionConfig& session) {
  const Recording recording = read_recording(path);
  std::vector<DeviceState> samples;
  samples.reserve(recording.frames.size());
  for (const HapticSample& frame : recording.frames) samples.push_back(frame.device);
  try {
    const RecordedConfig recorded = read_config(recording.config);
    session.world_from_body = recorded.world_from_body;
    if (!options.rate) session.rate = recorded.rate_hz;
    return make_replay_device(std::move(samples), recorded.params.device);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// Sessions step on the engine's clock; a device that wants to set the pace would be read out of
/// step with its own servo loop.
void refuse_device_clock(const HapticDevice& device) {
  if (device.limits().clock != DeviceClock::device) return;
  throw DeviceUnavailable(
      device.name() + ": wants to set the pace by its own clock, which this build cannot follow");
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
  run->device = scheme == "replay"
                    ? open_recorded(run->device_uri.substr(scheme.size() + 1), options, run->config)
                    : open_device(run->device_uri, context_of(*run, seed));
  refuse_device_clock(*run->device);
  run->config.haptic.device = run->device->limits();
  return run;
}

}  // namespace thigma::app
