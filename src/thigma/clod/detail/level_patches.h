#pragma once
// The patches of the simplified levels in a hierarchy, and what is measured of them (Sec. 3.3.5).

#include <cstdint>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/convex/decomposition.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/simplify/simplify_surface.h"

namespace thigma::detail {

/// Triangles and vertices of each patch of a level, ascending.
struct LevelPatches {
  std::vector<std::vector<std::int32_t>> triangles, vertices;
};

/// Of every level; those of level 0 stay empty, the decomposition has them.
std::vector<LevelPatches> list_level_patches(const Simplification& simplification);

/// Appends the contact patches of levels 1.. with hulls and features, and ties them to their nodes.
void append_contact_patches(const Simplification& simplification,
                            const std::vector<LevelPatches>& patches, ClodHierarchy& hierarchy);

/// Fills h of the contact patches: exact, over the hulls of all patches below their nodes.
void measure_hausdorff(int threads, ClodHierarchy& hierarchy);

/// Gives the nodes of simplified levels their contact patch as bounding hull, and free nodes h to
/// match: the form of the text.
void bound_by_contact_patches(ClodHierarchy& hierarchy);

/// Fills s of the contact patches. The result does not depend on the number of threads.
void measure_deviation(const TriangleMesh& mesh, const ConvexDecomposition& decomposition,
                       const Simplification& simplification, int threads, ClodHierarchy& hierarchy);

/// Fills D of the vertices of finest and contact patches.
void fill_support(const ConvexDecomposition& decomposition,
                  const std::vector<LevelPatches>& patches, const Simplification& simplification,
                  ClodHierarchy& hierarchy);

}  // namespace thigma::detail
