#pragma once
// From the options of `thigma run` to a session that can be started.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "run_options.h"
#include "scenes/scene_description.h"

#include "thigma/clod/hierarchy.h"
#include "thigma/device/haptic_device.h"
#include "thigma/runtime/placement.h"
#include "thigma/runtime/session.h"

namespace thigma::app {

/// Everything of a run. Not movable once `config` points into it.
struct Run {
  scenes::SceneDescription scene;
  double object_radius = 0.0;  // [m]
  ClodHierarchy object;
  std::vector<std::unique_ptr<ClodHierarchy>> statics;
  SessionConfig config;
  StartPlacement start;
  std::unique_ptr<HapticDevice> device;
  std::string device_uri;
};

/// Reads the scene, loads meshes, builds hierarchies, places the object, opens the device.
///
/// tell     called with a line of progress, may be empty
/// Thread   [offline]. InputError, IoError, DeviceAddressError, DeviceUnavailable,
/// std::invalid_argument.
std::unique_ptr<Run> prepare_run(const RunOptions& options, std::uint64_t seed,
                                 const std::function<void(const std::string&)>& tell);

}  // namespace thigma::app
