#pragma once
// Scene files in TOML; every key is explained in scenes/jaws.toml.

#include <string>
#include <string_view>
#include <vector>

#include "thigma/scene/scene_description.h"

namespace thigma {

/// Reads a scene.
///
/// path    a file, or the name of a built-in scene when no file has that name
/// errors  InputError "FILE: what, line N, what was expected" for anything that is not a scene:
///         wrong keys (with the nearest right one), wrong types, values out of range, missing
///         meshes
/// Thread  [offline]
SceneDescription read_scene(const std::string& path);

/// The same from text.
///
/// file    name for messages
/// folder  what relative mesh paths are relative to, "" = the working directory
SceneDescription parse_scene(std::string_view text, const std::string& file,
                             const std::string& folder);

/// Names of the scenes every build has, in the order of listings: jaws first.
std::vector<std::string> builtin_scene_names();

/// TOML text of a built-in scene; throws InputError naming the nearest for an unknown name.
std::string_view builtin_scene(std::string_view name);

}  // namespace thigma
