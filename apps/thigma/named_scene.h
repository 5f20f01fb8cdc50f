#pragma once
// Scenes as people name them: a TOML file, a built-in one, or a file that carries a scene.

#include <string>

#include "thigma/scene/scene_description.h"
#include "thigma/scene/world_scene.h"

namespace thigma::app {

/// A scene by its name; what travels in one file (.mcap) is unpacked to a folder that goes with the
/// program.
/// Thread [offline]; InputError, IoError.
SceneDescription read_named_scene(const std::string& name);

/// Whether a scene of that name has [[body]], a recording's too. Thread [offline].
bool is_named_world(const std::string& name);

/// Such a scene, as read_named_scene. Thread [offline]; InputError, IoError.
WorldSceneDescription read_named_world(const std::string& name);

/// A new folder that goes with the program. Thread [offline]; IoError.
std::string scratch_folder();

/// The user's folder for what the program writes without being told where, of a kind,
/// "recordings" or "scenes": $XDG_DATA_HOME/thigma/KIND, or ~/.local/share/thigma/KIND; "" without
/// either. Made by whoever writes there. Thread [offline].
std::string user_folder(const std::string& kind);

}  // namespace thigma::app
