#pragma once
// Two castings that are put together: pipe flanges, one with a spigot, one with the socket for it.

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

/// Three-lobed flange of 60 mm, 9 mm thick, with a hub above and a chamfered spigot of 28 mm, 12 mm
/// long, below. Its face is the plane z = 0 [m].
TriangleMesh make_flange_spigot(int triangles);

/// The same flange on a closed body of 40 mm, 26 mm high; its socket of 28.6 mm, 14 mm deep, opens
/// at the face z = 0, with a chamfer [m].
TriangleMesh make_flange_socket(int triangles);

}  // namespace thigma::models
