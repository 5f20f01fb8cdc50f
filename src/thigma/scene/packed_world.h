#pragma once
// A world with all its files in one, as packed_scene.h has it for scenes of one object.

#include <string>
#include <vector>

#include "thigma/recording/mcap_file.h"
#include "thigma/scene/world_scene.h"

namespace thigma {

/// The files of a world: scene.toml first, then each mesh once, under its own name. All that its
/// text says stays as it is, but for the names of meshes.
/// Thread  [offline]; InputError for a file that cannot be read
std::vector<McapAttachment> pack_world(const WorldSceneDescription& scene);

/// Writes a world alone. Thread [offline]; InputError as pack_world, IoError.
void write_packed_world(const std::string& path, const WorldSceneDescription& scene);

/// Whether a file is an MCAP file that carries a scene with [[body]]. False for what cannot be
/// read. Thread [offline].
bool has_packed_world(const std::string& path);

/// The world of a file, unpacked. It brings no device, as read_packed_scene.
///
/// folder  empty, there, the caller's; holds the files as long as the world is used
/// errors  as read_packed_scene
/// Thread  [offline]
WorldSceneDescription read_packed_world(const std::string& path, const std::string& folder);

}  // namespace thigma
