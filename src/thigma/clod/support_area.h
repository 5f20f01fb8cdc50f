#pragma once
// How large a contact a vertex can carry: support areas D (Sec. 3.3.5).

#include <array>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/mesh/surface_topology.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct SupportParams {
  double tolerance = 0.0;    // along the normal of the vertex: that of the contact query [m]
  double cone_cosine = 0.5;  // of the largest angle between the normals of a face and the vertex
  int most_faces = 4096;     // of a flood; a larger one stops there, so D is a lower bound
};

/// Areas of the faces at each vertex, projected onto its tangent plane, by SupportReading: the
/// one-ring alone, and the flood over edges from it. A face counts when all its corners lie within
/// the tolerance of the tangent plane and its normal lies in the cone; of a face of the one-ring
/// that leaves the tolerance the part within it counts, so that the vertex of a sharp edge or of a
/// coarse mesh has an area, a small one. 0 only where no face around the vertex is in the cone.
///
/// The one-ring is the text to the letter, where tolerance and cone are almost idle and D shrinks
/// with the tessellation; the flood is what they are for (docs/deviations.md).
///
/// mesh     positions finite, indices in range [m]
/// returns  one pair a vertex [m^2]; 0 for a vertex without faces
/// Thread   [offline]; the same with any number of threads.
std::vector<std::array<double, 2>> support_areas(const TriangleMesh& mesh,
                                                 const SurfaceTopology& topology,
                                                 const SupportParams& params, int threads = 1);

}  // namespace thigma
