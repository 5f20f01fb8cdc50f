#pragma once
// Sensation preserving simplification: the loop (Algorithm 3.3.1).

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/convex/decomposition.h"
#include "thigma/mesh/halfedge_mesh.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/simplify/edge_flip.h"
#include "thigma/simplify/filtered_edge_collapse.h"
#include "thigma/simplify/simplify_params.h"

namespace thigma {

/// One level of detail.
/// Invariant: patch p owns the triangles t with patch_of_triangle[t] == p.
struct SimplifiedLevel {
  TriangleMesh mesh;                            // [m; body frame]
  std::vector<std::int32_t> patch_of_triangle;  // -1: without area (m)
  std::int32_t patch_count = 0;
  std::vector<std::int32_t> parent;  // patch of the next level that took each patch; empty in the
                                     // last level. Vanished patches went to one beside them.
  double resolution = 0.0;           // of the coarsest edge collapsed so far (Eq. 3.1), infinite
                                     // before the first [1/m]
  std::vector<std::array<double, 2>> support;  // least of those that came together (n), or empty
  CornerAttributes attributes;                 // width 0: none
};

/// Levels from the original to the coarsest, and what happened on the way.
struct Simplification {
  std::vector<SimplifiedLevel> levels;
  std::array<std::int64_t, kCollapseOutcomes> outcomes{};  // of attempts, by CollapseOutcome
  std::array<std::int64_t, kFlipOutcomes> flips{};         // of attempts, by FlipOutcome
  std::int64_t merges = 0;                                 // patches absorbed by neighbours
  std::int64_t vanished = 0;                               // patches that lost all their triangles
  double convexity_tolerance = 0.0;                        // used from level 1 on [m]
  double protrusion_tolerance = 0.0;                       // [m]
};

/// Simplifies a decomposed surface: edges collapse in the order of their projected length, patches
/// merge when their union is convex, levels are kept so that the number of patches halves, or of
/// triangles (space_levels).
///
/// The last level of the fine stages is one of those kept, if it has at most half the original's
/// patches. Longer edges, and deviation beyond `deviation_limit` at them, come last.
///
/// decomposed  usable in the sense of import/inspect.h; its patches become level 0 [m]
/// support     of each vertex, two values that become the least where vertices come together, or
///             empty
/// attributes  of the corners, or width 0
/// returns     at least level 0; resolutions fall, patches or triangles at least halve but into the
///             last
/// Thread      [offline]; deterministic.
/// Source      Sec. 3.3.3, Algorithm 3.3.1. Stops and tolerances: docs/simplification.md.
Simplification simplify_surface(const DecomposedSurface& decomposed,
                                const SimplifyParams& params = {},
                                std::vector<std::array<double, 2>> support = {},
                                CornerAttributes attributes = {});

}  // namespace thigma
