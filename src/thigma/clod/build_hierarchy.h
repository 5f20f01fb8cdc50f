#pragma once
// From a mesh to the hierarchy the contact query descends.

#include "thigma/clod/hierarchy.h"
#include "thigma/convex/decomposition.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// What building a hierarchy did, for reports.
struct BuildReport {
  std::int32_t triangles = 0;
  std::int32_t patches = 0;
  std::int32_t cut_by_self_intersection = 0, cut_by_protrusion = 0, cut_by_size = 0;
  double decompose_seconds = 0.0, hierarchy_seconds = 0.0;  // CPU time
};

/// Full-resolution hierarchy of a usable mesh: convex surface patches under free levels.
///
/// mesh      usable in the sense of import/inspect.h [m]
/// report    null, or filled
/// returns   the hierarchy; deterministic
/// Thread    [offline]; throws InputError when no triangle has an area.
/// Source    Sec. 3.3.1, 3.3.3 (free levels); h over all descendants (see Eq. 3.5 in
///           docs/deviations.md).
ClodHierarchy build_exact_hierarchy(const TriangleMesh& mesh,
                                    const DecompositionParams& params = {},
                                    BuildReport* report = nullptr);

}  // namespace thigma
