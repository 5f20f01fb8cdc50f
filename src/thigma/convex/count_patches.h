#pragma once
// How convex a shape is.

#include <cstdint>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// The number of patches of a decomposition whose hulls could have any number of vertices, as the
/// text's can: a convex shape has one.
///
/// mesh      usable, of a few thousand triangles at most: patches are as large as they get
/// Thread    [offline]; throws InputError as decompose_surface.
/// Source    Sec. 3.3.1, Table 4.1.
std::int32_t count_convex_patches(const TriangleMesh& mesh);

}  // namespace thigma
