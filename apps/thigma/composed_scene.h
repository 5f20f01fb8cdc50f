#pragma once
// Scenes that are made on the page: objects of the scene that runs and of files dropped on it, with
// poses, materials and mass.

#include <string>
#include <vector>

#include "live_models.h"

#include "thigma/scene/scene_description.h"

namespace thigma::app {

/// The scene that a page has put together.
///
/// objects  JSON array, the first in the hand (docs/protocol.md, `compose`)
/// now      the scene that "scene:K" is of; where its object stays in the hand, so do all its
///          gains, else they follow from the size of the new one. Device, rate and safety limits
///          stay.
/// errors   InputError, a sentence for people
/// Thread   [offline]
SceneDescription composed_scene(const std::string& title, const std::string& objects,
                                const SceneDescription& now, const DroppedMesh& dropped);

/// What its objects are of, in their order. Thread [offline].
std::vector<std::string> sources_of(const std::string& objects);

/// Saves a scene in the user's folder for scenes, as NAME.toml with its files in NAME beside it, or
/// all in one file, NAME.mcap; "NAME 2" and so on where something has that name already.
///
/// name     letters, digits, spaces, '-', '_' and '.', not first; at most 80
/// returns  its path
/// errors   InputError for another name, IoError
/// Thread   [offline]
std::string save_scene(const SceneDescription& scene, const std::string& name, bool is_one_file);

}  // namespace thigma::app
