#pragma once
// The coarse triangles of a patch, row by row of a height map.

#include "thigma/depth/height_map.h"

namespace thigma::detail {

/// Raises the samples of a map to the heights of a patch's triangles.
///
/// map     of the size of the grid
/// Thread  [contact]; no failure; does not allocate.
void raise_triangles(const ProjectedPatch& patch, const MapGrid& grid, const MapReading& reading,
                     HeightMap& map) noexcept;

}  // namespace thigma::detail
