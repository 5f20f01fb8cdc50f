#pragma once
// What stands below the nodes of a hierarchy: original triangles, and which finest patches.

#include <cstdint>
#include <vector>

#include "thigma/clod/hierarchy.h"

namespace thigma::experiments::level_choice {

/// By node. Finest patches are counted in the order of the tree, so that those below a node are
/// first .. last - 1.
struct TreeRanges {
  std::vector<std::int32_t> first, last;
  std::vector<double> triangles;  // of the original below the node
  std::vector<double> area;       // of the finest patch with this count [m^2]
};

TreeRanges tree_ranges(const ClodHierarchy& h);

}  // namespace thigma::experiments::level_choice
