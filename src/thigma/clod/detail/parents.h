#pragma once
// Which coarser patch a node belongs under.

#include <cstdint>
#include <vector>

#include "thigma/clod/detail/draft_tree.h"
#include "thigma/clod/detail/level_patches.h"

namespace thigma::detail {

/// For each patch of a level that has a node: the patch of the next level from which the points of
/// the node's hull are least far, the farthest of them counting; the first of equals.
///
/// The patch that took it over while simplifying is where the search starts: edges that collapse
/// slide patches along the surface, so it is often not the nearest (docs/deviations.md).
///
/// draft_of_patch  nodes of the patches, -1 for those without (those get -1)
/// successor       of each patch, in the next level
std::vector<std::int32_t> nearest_parents(const DraftTree& tree,
                                          const std::vector<std::int32_t>& draft_of_patch,
                                          const std::vector<std::int32_t>& successor,
                                          const TriangleMesh& level, const LevelPatches& patches,
                                          int threads);

}  // namespace thigma::detail
