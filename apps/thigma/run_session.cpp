#include "run_session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "clod_cache.h"
#include "progress.h"
#include "run_relief.h"
#include "scenes/scene_file.h"
#include "scenes/simulated_body.h"
#include "told_recording.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/device/replay.h"
#include "thigma/runtime/config_json.h"
#include "thigma/runtime/direct_session.h"
#include "thigma/runtime/passive_session.h"
#include "thigma/runtime/recording.h"

namespace thigma::app {
namespace {

// Of a mesh without a unit: what a hand holds is smaller, and in millimetres a thing of 1 mm is
// larger [m].
constexpr double kLargestRadius = 1.0;

/// The hierarchy of a mesh at full resolution, as an asset.
ClodAsset build_exact(const ClodSource& source, const Tell& tell) {
  ClodAsset asset;
  asset.meshes.push_back(load_surface(source, tell));
  asset.hierarchy = build_exact_hierarchy(asset.meshes[0]);
  asset.mass.measure = mass_properties(asset.meshes[0]);
  return asset;
}

/// Surface, hierarchy and mass of an object: levels of detail where the session asks for them.
ClodAsset load_asset(const scenes::SceneObject& object, const char* role, const RunOptions& options,
                     bool is_exact, const RunHooks& hooks) {
  const Tell& tell = hooks.tell;
  ClodSource source;
  source.name = object.mesh;
  source.role = role;
  source.scale = object.unit_scale;
  source.is_repair = options.is_repair;
  const bool is_kept = !object.model && is_clod_file(object.mesh);
  ClodAsset asset;
  if (is_exact && !is_kept) {
    asset = build_exact(source, tell);
  } else {
    const std::string what = "building levels of " + object.name;
    Progress bar(what, "triangles", static_cast<bool>(tell));
    source.progress = [&](double share, double amount) {
      bar.update(share, amount);
      if (hooks.progress) hooks.progress(what, share);
    };
    asset = load_clod_cached(source, {.is_enabled = !options.has_no_cache, .folder = {}}, tell);
  }
  const ClodHierarchy& h = asset.hierarchy;
  if (tell) {
    char line[256];
    std::snprintf(
        line, sizeof line, "%s: %d triangles, %zu convex patches, %zu levels, radius %.4g m",
        object.name.c_str(), h.triangle_count, h.patches.size(), h.levels.size(), h.radius);
    tell(line);
  }
  return asset;
}

/// What a session has to know of the grasped object.
scenes::LoadedObject measures_of(const ClodAsset& asset) {
  scenes::LoadedObject loaded;
  loaded.measure = asset.mass.measure;
  loaded.ball = {asset.hierarchy.center, asset.hierarchy.radius};
  return loaded;
}

template <class Is>
bool has_any(const scenes::SceneDescription& scene, Is is) {
  return is(scene.object) || std::any_of(scene.statics.begin(), scene.statics.end(), is);
}

void apply_options(const RunOptions& options, const scenes::SceneDescription& scene,
                   SessionConfig& config) {
  config.duration = options.duration.value_or(0.0);
  config.rate = options.rate.value_or(config.rate);
  if (options.spin) config.spin = 1e-6 * *options.spin;
  config.faults = parse_faults(options.fault_text);
  apply(options.resolution, config.contact.resolution);
  if (options.has_no_blend) config.contact.resolution.interpolates = false;
  const bool is_direct = options.response.empty() ? scene.contact.response == ResponseKind::direct
                                                  : options.response == "direct";
  config.haptic.response = is_direct ? ResponseKind::direct : ResponseKind::coupled;
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
void place(const Run& run, const Tell& tell, RunDevice& opened) {
  const Vec3* approach = run.scene.device.approach ? &*run.scene.device.approach : nullptr;
  const Vec3 out = approach != nullptr ? Vec3(-*approach) : Vec3::Zero();
  opened.start = find_start(opened.config.contact, opened.config.world_from_body, 0.0,
                            approach != nullptr ? &out : nullptr);
  opened.config.world_from_body = opened.start.world_from_body;
  if (tell) tell(placement_line(opened.start, approach != nullptr));
}

DeviceContext context_of(const Run& run, const RunDevice& opened, std::uint64_t seed) {
  const Workspace& workspace = opened.config.haptic.workspace;
  DeviceContext context;
  context.approach =
      workspace.world_from_device.orientation.conjugate()._transformVector(opened.start.approach);
  context.clearance = opened.start.clearance / workspace.motion_scale;
  context.object_radius = run.object_radius / workspace.motion_scale;
  context.seed = seed;
  return context;
}

/// The samples of a recording as a device. Forces come out as recorded only from where that session
/// started and at its rate, so both are taken over.
std::unique_ptr<HapticDevice> open_recorded(const std::string& path, const RunOptions& options,
                                            const Tell& tell, SessionConfig& session) {
  std::vector<DeviceState> samples;
  const RecordingInfo recording =
      stream_recording(path, {.frame = [&samples](const HapticSample& frame, const SamplePlace&) {
                         samples.push_back(frame.device);
                       }});
  if (tell) {
    for (const std::string& line : recording_warnings(path, recording)) tell(line);
  }
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

void refuse_web_without_page(const Run& run, const std::string& uri) {
  if (device_scheme(uri) == "web" && run.web_link == nullptr)
    throw DeviceUnavailable("web: needs the page, which --headless and --lockstep leave out");
}

/// The page's mouse, slower than what safety takes for a fault.
std::unique_ptr<HapticDevice> open_web(const Run& run) {
  refuse_web_without_page(run, "web:");
  WebMotionParams params;
  const SafetyLimits& safety = run.config.haptic.safety;
  params.max_speed = std::min(params.max_speed, 0.8 * safety.max_speed);
  params.max_angular_speed = std::min(params.max_angular_speed, 0.8 * safety.max_turn_speed);
  return make_web_device(*run.web_link, params);
}

/// Opens the device, and places the object before a hand comes to it. With the direct response the
/// device decides the contact tolerance, and that the place: a hand is opened once more for its
/// limits.
void open_at(const RunOptions& options, std::uint64_t seed, const Tell& tell, const Run& run,
             RunDevice& opened) {
  const std::string scheme = device_scheme(opened.uri);
  const bool is_direct = opened.config.haptic.response == ResponseKind::direct;
  if (scheme == "web") {
    place(run, tell, opened);
    opened.device = open_web(run);
    if (is_direct) use_direct_response(opened.device->limits(), opened.config);
    return;
  }
  if (scheme == "hand") {
    if (is_direct) use_direct_response(open_device(opened.uri, {})->limits(), opened.config);
    place(run, tell, opened);
  }
  opened.device = scheme == "replay" ? open_recorded(opened.uri.substr(scheme.size() + 1), options,
                                                     tell, opened.config)
                                     : open_device(opened.uri, context_of(run, opened, seed));
  if (is_direct) use_direct_response(opened.device->limits(), opened.config);
}

/// What moves by itself instead of in a hand.
void prepare_simulation(const scenes::SimulatedBody& body, std::uint64_t seed, Run& run) {
  if (device_scheme(run.device_uri) != "null")
    throw DeviceAddressError(
        run.scene.file + ": nobody holds the object of a [simulation], expected --device null:");
  if (run.config.haptic.response == ResponseKind::direct || !run.config.contact.textures.is_empty())
    throw InputError(
        run.scene.file +
        ": [simulation] knows neither --response direct nor textures, expected neither");
  ContactWorld& contact = run.config.contact;
  if (!body.has_tolerance) {
    double radius = contact.object->radius;
    for (const SceneBody& other : contact.scene) radius = std::min(radius, other.hierarchy->radius);
    contact.tolerance = contact.response.tolerance = 1e-3 * radius;
  }
  contact.resolution.interpolates = false;
  run.simulation.emplace();
  run.simulation->world = scenes::simulation_world(body, run.config);
  run.simulation->start = scenes::simulation_start(body, run.config, seed);
  run.config.world_from_body = {run.simulation->start.body.position,
                                run.simulation->start.body.orientation};
}

}  // namespace

scenes::SceneDescription read_run_scene(const RunOptions& options) {
  if (!options.scene.empty()) return scenes::read_scene(options.scene);
  return scenes::scene_from_pair(
      options.object, options.against, options.scale.value_or(1.0),
      options.pose_text.empty() ? Pose{} : *parse_pose(options.pose_text));
}

std::string check_meshes(const scenes::SceneDescription& scene, const RunOptions& options) {
  std::vector<const scenes::SceneObject*> objects(1, &scene.object);
  for (const scenes::SceneObject& other : scene.statics) objects.push_back(&other);
  double largest = 0.0;
  std::string name;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const scenes::SceneObject& object = *objects[i];
    if (object.is_textured || object.model) continue;
    const double radius = check_source({.name = object.mesh,
                                        .role = i == 0 ? "--object" : "--against",
                                        .scale = object.unit_scale,
                                        .is_repair = options.is_repair});
    if (radius > largest) name = object.mesh;
    largest = std::max(largest, radius);
  }
  if (options.object.empty() || options.scale || largest <= kLargestRadius) return "";
  double scale = 1e-3;
  while (largest * scale > kLargestRadius) scale *= 1e-3;
  char line[512];
  std::snprintf(line, sizeof line,
                "%.300s: a radius of %.3g m, which no hand feels; --scale %g where it is in %s, "
                "--scale 1 where it "
                "is meant",
                name.c_str(), largest, scale, scale == 1e-3 ? "mm" : "smaller units");
  return line;
}

SessionSummary simulate_run(Run& run, const SessionConfig& config, bool is_paced,
                            const SessionSinks& sinks, const std::atomic<bool>* stop) {
  SimulatedRun& simulated = *run.simulation;
  simulated.last = run_simulated(config, simulated.world, simulated.start, is_paced, sinks, stop);
  return simulated.last.session;
}

std::unique_ptr<Run> prepare_run(scenes::SceneDescription scene, const RunOptions& options,
                                 std::uint64_t seed, const RunHooks& hooks) {
  const Tell& tell = hooks.tell;
  auto run = std::make_unique<Run>();
  run->scene = std::move(scene);
  // What decides gains = "auto" has to be known before there is a configuration.
  if (!options.device.empty()) run->scene.device.uri = options.device;
  if (options.rate) run->scene.rate = *options.rate;
  run->device_uri = run->scene.device.uri;
  run->web_link = hooks.web_link;
  refuse_web_without_page(*run, run->device_uri);  // before anything takes long to load

  // Whether levels are wanted decides what is loaded, before there is a configuration.
  Resolution resolution = run->scene.contact.resolution;
  apply(options.resolution, resolution);
  if (options.texture == "on" &&
      !has_any(run->scene, [](const scenes::SceneObject& o) { return o.has_relief(); }))
    throw InputError(run->scene.file +
                     ": nothing in it has a texture, for --texture on, expected "
                     "an object or static body with one");
  // A texture instead of a mesh lies over patches of the original surface alone.
  if (has_any(run->scene, [](const scenes::SceneObject& o) { return o.is_textured; }))
    resolution.is_exact = true;
  std::int32_t coarsest = resolution.coarsest_level;
  const auto load = [&](const scenes::SceneObject& object, const char* role,
                        BodyTextures& textures) {
    if (object.is_textured) {
      textures = load_relief(object, tell);
      return coarse_asset(*textures[0]);
    }
    ClodAsset asset = load_asset(object, role, options,
                                 resolution.is_exact && object.level_textures.empty(), hooks);
    if (!object.level_textures.empty() && options.texture != "off")
      textures = load_level_relief(object, asset, tell, coarsest);
    return asset;
  };
  run->object = load(run->scene.object, "--object", run->object_textures);
  run->object_radius = run->object.hierarchy.radius;
  run->config = scenes::make_session_config(run->scene, measures_of(run->object));
  run->config.contact.object = &run->object.hierarchy;
  for (const scenes::SceneObject& other : run->scene.statics) {
    run->static_textures.emplace_back();
    run->statics.push_back(
        std::make_unique<ClodAsset>(load(other, "--against", run->static_textures.back())));
    run->config.contact.scene.push_back({&run->statics.back()->hierarchy, other.world_from_mesh});
  }
  apply_options(options, run->scene, run->config);
  run->config.contact.resolution.coarsest_level = coarsest;
  if (options.texture != "off") use_textures(*run, tell);
  use_run_device(
      open_run_device(options, seed, run->device_uri, run->config.world_from_body, *run, tell),
      *run);
  if (options.is_passive || run->scene.is_passive)
    use_passivity(run->device->limits(), run->config);
  if (!options.scene.empty()) {
    if (const auto body = scenes::read_simulated_body(options.scene))
      prepare_simulation(*body, seed, *run);
  }
  return run;
}

RunDevice open_run_device(const RunOptions& options, std::uint64_t seed, const std::string& uri,
                          const Pose& world_from_body, const Run& run, const Tell& tell) {
  RunDevice opened;
  opened.uri = uri;
  opened.config = run.config;
  opened.config.world_from_body = world_from_body;
  opened.start = run.start;
  open_at(options, seed, tell, run, opened);
  refuse_device_clock(*opened.device);
  // Faults that are asked for are to be seen as a device would have them.
  opened.config.haptic.safety.rides_out_gaps = !run.scene.is_strict && opened.config.faults.empty();
  use_device_limits(opened.device->limits(), opened.config.haptic);
  if (opened.config.haptic.passivity.is_on) use_passivity(opened.device->limits(), opened.config);
  return opened;
}

void use_run_device(RunDevice opened, Run& run) {
  run.device_uri = std::move(opened.uri);
  run.config = std::move(opened.config);
  run.start = opened.start;
  run.device = std::move(opened.device);
}

}  // namespace thigma::app
