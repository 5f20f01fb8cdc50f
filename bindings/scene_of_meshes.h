#pragma once
// Scenes of surfaces in memory: what a caller has that holds meshes of its own.

#include <optional>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/scene/load_scene.h"

namespace thigma::bindings {

/// Two surfaces, the second at the identity; gains by the size of the first, exact contacts.
///
/// object, against  usable, as usable_mesh has them [m]
/// world_from_mesh  of the object
/// response         none: the constraint
/// Thread           [offline]; throws InputError as make_session_config
Scene scene_of_meshes(const TriangleMesh& object, const TriangleMesh& against,
                      const Pose& world_from_mesh, std::optional<ResponseKind> response = {});

}  // namespace thigma::bindings
