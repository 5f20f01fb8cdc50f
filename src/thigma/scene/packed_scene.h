#pragma once
// A scene with all its files in one: an MCAP file whose attachments are scene.toml and assets/NAME.
// Recordings carry their scene in the same way, so that either is whole wherever it is sent.

#include <string>
#include <vector>

#include "thigma/recording/mcap_file.h"
#include "thigma/scene/scene_description.h"

namespace thigma {

/// The files of a scene: scene.toml first, then each mesh and texture once, under its own name.
///
/// folder  of the assets beside scene.toml, one plain name
/// Thread  [offline]; InputError for a file that cannot be read
std::vector<McapAttachment> pack_scene(const SceneDescription& scene,
                                       const std::string& folder = "assets");

/// Writes a scene alone. Thread [offline]; InputError as pack_scene, IoError.
void write_packed_scene(const std::string& path, const SceneDescription& scene);

/// Writes a scene as TOML at `path` (NAME.toml), with its files in NAME beside it.
/// Thread [offline]; InputError as pack_scene, IoError.
void write_scene_folder(const std::string& path, const SceneDescription& scene);

/// Whether a file is an MCAP file that carries a scene. False for what cannot be read.
/// Thread [offline].
bool has_packed_scene(const std::string& path);

/// Whether it carries a scene and nothing else. False for what cannot be read. Thread [offline].
bool is_packed_scene(const std::string& path);

/// The scene of a file, unpacked. It brings no device: who opens it decides what moves; its meshes
/// are repaired where they need it.
///
/// folder  empty, there, the caller's; holds the files as long as the scene is used
/// errors  InputError "FILE: what, expected ..." for no scene in it, names that lead out of the
///         folder, files that the scene names and the file lacks; IoError
/// Thread  [offline]
SceneDescription read_packed_scene(const std::string& path, const std::string& folder);

}  // namespace thigma
