#pragma once
// From the options of `thigma run` to a session that can be started.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run_options.h"
#include "scenes/scene_description.h"

#include "thigma/clod/clod_asset.h"
#include "thigma/device/haptic_device.h"
#include "thigma/runtime/placement.h"
#include "thigma/runtime/session.h"
#include "thigma/runtime/simulated_session.h"
#include "thigma/runtime/web_device.h"

namespace thigma::app {

/// An object that no hand holds, and how its last session went.
struct SimulatedRun {
  SimulationWorld world;
  SimulationState start;
  SimulatedSummary last;
};

/// Textures of one body, by level of detail; in places that do not move.
using BodyTextures = std::vector<std::unique_ptr<HapticTexture>>;

/// Everything of a run. Not movable once `config` points into it.
struct Run {
  scenes::SceneDescription scene;
  double object_radius = 0.0;  // [m]
  ClodAsset object;
  std::vector<std::unique_ptr<ClodAsset>> statics;  // in the order of the scene
  BodyTextures object_textures;                     // none where nothing of the scene is textured
  std::vector<BodyTextures> static_textures;        // as many as statics, or none
  SessionConfig config;
  // of the machine just before a threaded session, where it was measured
  std::optional<EmptyLoop> floor;
  std::optional<SimulatedRun> simulation;  // of a scene with [simulation]
  StartPlacement start;
  WebLink* web_link = nullptr;  // of the page, where there is one; outlives the run
  std::unique_ptr<HapticDevice> device;
  std::string device_uri;
};

/// Who is told how a run is prepared, and what it shares with the page.
struct RunHooks {
  std::function<void(const std::string&)> tell;  // lines for people; may be empty
  // What is being built and the share that is done; may be empty, may throw to give it up.
  std::function<void(const std::string& what, double share)> progress;
  WebLink* web_link = nullptr;  // of the page; null without one
};

/// The scene that the options name.
/// Thread   [offline]. InputError.
scenes::SceneDescription read_run_scene(const RunOptions& options);

/// Looks at all meshes of a scene before anything is built, since that may take minutes.
///
/// returns  "", or a sentence on the use of --scale: a pair of meshes without it of which one is
///          larger than a hand could feel (exit code 2)
/// Thread   [offline]. InputError for the first that cannot be used.
std::string check_meshes(const scenes::SceneDescription& scene, const RunOptions& options);

/// Loads or builds levels of detail, places the object, opens the device.
///
/// Thread   [offline]. InputError, IoError, DeviceAddressError, DeviceUnavailable,
/// std::invalid_argument.
std::unique_ptr<Run> prepare_run(scenes::SceneDescription scene, const RunOptions& options,
                                 std::uint64_t seed, const RunHooks& hooks);

/// Runs the simulation of a scene that has one, as run_simulated; how it went stays in
/// run.simulation->last.
/// Thread   [offline]
SessionSummary simulate_run(Run& run, const SessionConfig& config, bool is_paced,
                            const SessionSinks& sinks, const std::atomic<bool>* stop);

/// What of a run its device decides.
struct RunDevice {
  std::string uri;
  std::unique_ptr<HapticDevice> device;
  SessionConfig config;
  StartPlacement start;
};

/// Opens a device anew, or another one, and places the object for it as prepare_run does. The run,
/// which a session may be using, stays as it is.
///
/// world_from_body  where the object starts unless it has to be placed elsewhere
/// Thread   [offline]; errors as prepare_run.
RunDevice open_run_device(const RunOptions& options, std::uint64_t seed, const std::string& uri,
                          const Pose& world_from_body, const Run& run,
                          const std::function<void(const std::string&)>& tell = {});

/// Gives the run its device, between two sessions.
void use_run_device(RunDevice opened, Run& run);

}  // namespace thigma::app
