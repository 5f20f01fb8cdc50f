#pragma once
// A shell brought from its offset to the surface it goes around.

#include <cstdint>
#include <functional>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma::detail {

/// Moves the vertices of a shell towards the nearest points of a surface, up to `rest` from it. A
/// vertex goes less far, in the end not at all, where triangles would meet, turn over or collapse.
///
/// shell     closed and without intersections, outside of the surface
/// returns   vertices that did not go all the way
/// Thread    [offline]; deterministic.
std::int64_t snap_shell(TriangleMesh& shell, const TriangleMesh& mesh, const TriangleTree& tree,
                        double rest, const std::function<void(double)>& progress);

}  // namespace thigma::detail
