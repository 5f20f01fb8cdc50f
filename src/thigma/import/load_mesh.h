#pragma once
// A mesh file, ready to use: what every verb but inspect and repair calls.

#include <string>
#include <vector>

#include "thigma/import/inspect.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Multiplies all positions. scale > 0 [m per unit of the mesh].
/// Thread [offline]; throws InputError naming `name` when scale is not positive and finite or a
/// position leaves the range of read_mesh.
void scale_mesh(TriangleMesh& mesh, double scale, const std::string& name);

/// Reads, scales and checks a mesh.
///
/// scale     metres per unit of the file, > 0
/// repair    take a repairable mesh and repair it; otherwise it is refused with a message naming
///           --repair
/// report    null, or filled with the inspection of the mesh as returned (after scaling and
///           repair), self-intersections included
/// repairs   null, or filled with what was repaired
/// returns   a usable mesh [m]
/// Thread    [offline]; throws InputError with the first reason.
TriangleMesh load_usable_mesh(const std::string& path, double scale = 1.0, bool repair = false,
                              MeshReport* report = nullptr,
                              std::vector<std::string>* repairs = nullptr);

}  // namespace thigma
