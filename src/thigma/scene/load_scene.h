#pragma once
// From a scene to what a session needs: surfaces, levels of detail, textures, gains, device, start.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "thigma/core/log.h"
#include "thigma/device/haptic_device.h"
#include "thigma/scene/scene_description.h"
#include "thigma/scene/start_placement.h"
#include "thigma/session/session.h"

namespace thigma {

struct ClodAsset;
struct SimulatedStart;
class WebDeviceChannel;

/// Textures of one body by level of detail, null where a level has none; in places that do not
/// move.
using BodyTextures = std::vector<std::shared_ptr<const HapticTexture>>;

/// How a scene is loaded.
struct LoadOptions {
  bool repairs = false;      // meshes that need it are repaired, otherwise refused
  bool has_textures = true;  // false: coarse surfaces alone
  bool keeps_levels = true;  // levels of detail that were built, for the next time
  // levels that are not kept yet are left out: the scene is there in seconds, at full resolution,
  // and LevelBuild builds them beside the session
  bool defers_levels = false;
  // where; empty: the user's cache folder
  std::string cache_folder;
  Log log;  // lines for people; may be empty
  // what is being built, the share that is done, 0 to 1, and the triangles of the whole; may be
  // empty, may throw to give it up
  std::function<void(const std::string& what, double share, double triangles)> progress;
};

/// A scene with its surfaces loaded. Constant while a session runs, and outlives it. May be moved:
/// what `config` points to stays where it is.
struct Scene {
  SceneDescription description;
  std::shared_ptr<const ClodAsset> object;
  std::vector<std::shared_ptr<const ClodAsset>> statics;  // in the order of the description
  BodyTextures object_textures;               // empty where nothing of the scene is textured
  std::vector<BodyTextures> static_textures;  // as many as statics, or none
  SessionConfig config;                       // all that does not depend on the device
  bool lacks_levels = false;                  // some were left out (LoadOptions::defers_levels)
};

/// Loads a scene file (docs/formats.md) or a built-in scene.
///
/// path     a .toml file, or the name of a built-in scene when no file has that name
/// errors   InputError "FILE: what, expected ..." for a scene or mesh that cannot be used, IoError
/// Thread   [offline]; may take minutes where levels of detail have to be built
Scene load_scene(const std::string& path, const LoadOptions& options = {});

/// The same of a description: read_scene, scene_from_pair, or made in code.
Scene load_scene(SceneDescription description, const LoadOptions& options = {});

/// What of a session its user decides.
struct SessionOptions {
  std::string device{};   // address, "hand:"; empty: the scene's
  double duration = 0.0;  // [s]; 0: until told to stop or the device has finished
  std::uint64_t seed = 1;
  // haptic frames a second, instead of the scene's and of a replayed recording's [Hz]
  std::optional<double> rate{};
  std::optional<Pose> world_from_body{};    // of the centre of mass at the start; else the scene's
  WebDeviceChannel* web_channel = nullptr;  // of the page, for web:; outlives the session
  Log log{};                                // lines for people; may be empty
};

/// A scene in the hand: all that Session and run_lockstep need. `config` points into the scene.
struct SceneSession {
  std::string scene_file;  // name or path, for recordings
  std::string device_uri;
  std::uint64_t seed = 1;
  std::unique_ptr<HapticDevice> device;
  SessionConfig config;
  StartPlacement start;
  std::shared_ptr<const SimulatedStart> simulation;  // of a scene with [simulation], else null
};

/// Opens the device and places the object for it: a hand starts apart from the scene, others where
/// the scene says.
///
/// scene    outlives the session
/// errors   DeviceAddressError, DeviceUnavailable, InputError, IoError
/// Thread   [offline]
SceneSession open_session(const Scene& scene, const SessionOptions& options = {});

/// Refuses the page's device where there is no page, before anything takes long to load.
/// errors  DeviceUnavailable
void refuse_web_without_page(const std::string& device_uri, const WebDeviceChannel* channel);

/// Runs it on a virtual clock, as run_lockstep of session.h; a simulation as run_simulated.
/// Thread   [offline]
SessionSummary run_lockstep(SceneSession& session, const SessionSinks& sinks = {},
                            const std::atomic<bool>* stop = nullptr);

/// That the samples of a device which holds a person are older than a frame, for people; "" where
/// they are not.
///
/// uri     its address
/// rate    of the haptic frames [Hz]
/// Thread  [offline]
std::string delay_line(const HapticDevice& device, const std::string& uri, double rate);

}  // namespace thigma
