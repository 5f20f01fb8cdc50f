#pragma once
// Where on a grid the depth is near its maximum.

#include "thigma/depth/depth.h"

namespace thigma::detail {

/// Fills result.near: the maximum itself, and samples of the grid within `within` of it, every k-th
/// when there are more than fit.
///
/// object, scene  height maps over the grid
/// within         [m], > 0
/// result         depth[0] and at are set
/// Thread         [contact]; no failure.
void collect_near(const HeightMap& object, const HeightMap& scene, const MapGrid& grid,
                  double within, DepthSamples& result) noexcept;

}  // namespace thigma::detail
