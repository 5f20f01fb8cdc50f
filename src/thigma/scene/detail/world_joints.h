#pragma once
// [[joint]] of scenes of several moving bodies.

#include <vector>

#include "thigma/scene/detail/toml_table.h"
#include "thigma/scene/world_scene.h"

namespace thigma::detail {

/// Reads one table: a joint, or `copies` of it between numbered bodies.
/// Thread [offline]; throws InputError with the line.
void read_joint(TomlTable& table, std::vector<WorldSceneJoint>& joints);

/// The joints of a scene, placed where its bodies stand.
///
/// errors  InputError "joint 'NAME': no body 'B', ..." with the nearest name
/// Thread  [offline]
std::vector<WorldJoint> world_joints(const std::vector<WorldSceneJoint>& joints,
                                     const std::vector<WorldBody>& bodies);

}  // namespace thigma::detail
