#pragma once
// Built-in scenes with textures, led by a script on a virtual clock.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/device/script.h"
#include "thigma/scene/scene_description.h"
#include "thigma/session/session.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::experiments {

/// A scene at full resolution with its textures. Not movable once `config` points into it.
struct TexturedSession {
  SceneDescription scene;
  struct Body {
    HapticTexture texture;  // of one texel for a plain body
    ClodHierarchy hierarchy;
  };
  std::unique_ptr<Body> object;
  std::vector<std::unique_ptr<Body>> statics;
  SessionConfig config;
};

/// As `thigma run scenes/NAME.toml`, the object where the scene has it.
///
/// is_textured  false: coarse surfaces alone
/// change       what to change of the scene first, may be empty
/// make         another surface for a textured object; empty: the scene's own
/// Thread       [offline].
std::unique_ptr<TexturedSession> textured_session(
    const std::string& scene, bool is_textured,
    const std::function<void(SceneDescription&)>& change = {},
    const std::function<HapticTexture(const SceneObject&)>& make = {});

/// What a script's frames gave.
struct ScriptRun {
  std::vector<HapticSample> frames;
  std::vector<ContactSample> contacts;
  SessionSummary summary;
};

/// Leads the object by its centre of mass along a motion: pose(t) moves it from where it starts
/// [world].
///
/// seconds  of the motion
/// Thread   [offline]; deterministic.
ScriptRun run_script(TexturedSession& session, double seconds,
                     const std::function<Pose(double)>& pose);

}  // namespace thigma::experiments
