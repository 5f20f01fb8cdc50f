#pragma once
// The regions of a surface that an exact query found in contact: finest patches that touch and hang
// together.

#include <cstdint>
#include <vector>

#include "experiments/level-choice/tree_ranges.h"

namespace thigma::experiments::level_choice {

/// Corners of the finest patches of one object; patches counted as in TreeRanges.
struct PatchCorners {
  std::vector<std::vector<std::int32_t>> corners;  // of a patch; one number for one place
  std::int32_t count = 0;
};
PatchCorners patch_corners(const ClodHierarchy& h, const TreeRanges& tree);

/// Area of the region each touched patch belongs to: of all touched patches that can be reached
/// from it over common corners [m^2].
///
/// touched  finest patches, with repetitions
/// returns  by entry of `touched`
std::vector<double> region_areas(const PatchCorners& surface, const TreeRanges& tree,
                                 const std::vector<std::int32_t>& touched);

}  // namespace thigma::experiments::level_choice
