#pragma once
// What collapses and flips ask of new triangles alike.

#include <array>
#include <cstdint>

#include "thigma/simplify/patched_surface.h"

namespace thigma::detail {

/// Neighbours whose normals enclose more than 168 degrees lie on each other.
inline constexpr double kFoldCosine = -0.98;

/// 4 sqrt(3) area / sum of squared edges: 1 when equilateral, 0 without an area.
double triangle_quality(const std::array<Vec3, 3>& corners);

/// How many triangles of the shell two triangles meet where they should not, not counting each
/// other.
int count_crossings(const PatchedSurface& surface, const std::array<std::int32_t, 2>& triangles);

}  // namespace thigma::detail
