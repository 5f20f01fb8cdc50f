#pragma once
// A built-in scene as `thigma run` has it, on a virtual clock: simulated hand, coupling, contact
// frames of a millisecond.

#include <string>

#include "experiments/common/assets.h"

#include "thigma/device/open_device.h"
#include "thigma/session/session.h"

namespace thigma::experiments {

/// A scene ready to run, with one static object.
struct SessionPair {
  std::string name;
  SessionConfig config;  // resolution as the scene has it
  DeviceContext hand;    // for the hand that comes to the object
};

/// As `thigma run scenes/NAME.toml` sets it up; references into assets stay.
/// triangles  0 as the scene says, otherwise of both objects
/// Thread     [offline].
SessionPair session_pair(Assets& assets, const std::string& scene, double seconds,
                         int triangles = 0);

/// The same of any scene with one static object.
SessionPair session_pair(Assets& assets, const SceneDescription& scene, double seconds,
                         int triangles = 0);

}  // namespace thigma::experiments
