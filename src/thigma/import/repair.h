#pragma once
// Repairs of what inspect_mesh calls repairable.

#include <string>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct RepairResult {
  TriangleMesh mesh;                 // usable
  std::vector<std::string> repairs;  // what was done, with counts; empty for a mesh that was usable
};

/// Makes a repairable mesh usable: welds near-equal vertices along cracks, drops duplicate faces,
/// takes apart edges with three or more faces and pinched vertices, orients each component
/// consistently and closed ones outwards.
///
/// Of equal triangles, whichever way round, one stays and fins go (find_fins). It turns as its
/// sheet does: as most of the triangles that the mesh has once, where there are none as most
/// copies, then as the first. A sheet of which every triangle has its reverse, on no other surface,
/// is closed without volume: rejected, as which of its sides it should be seen from cannot be told.
///
/// Vertices taken apart move by about 1e-6 of the radius into their own fan, since equal positions
/// would be merged again on reading.
/// name      of the file, for messages
/// Thread    [offline]; deterministic; throws InputError that says why when the mesh is rejected or
///           stays unusable.
RepairResult repair_mesh(const TriangleMesh& mesh, const std::string& name);

}  // namespace thigma
