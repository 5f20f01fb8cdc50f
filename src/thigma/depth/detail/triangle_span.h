#pragma once
// What all rows of a triangle in a height map share.

#include "thigma/depth/detail/height_span.h"
#include "thigma/depth/projected_patch.h"

namespace thigma::detail {

/// Texels, steps and direction of the spans of a triangle. Coordinates are counted from a texel of
/// the triangle, so that single precision resolves its texels, not the map's.
///
/// spacing  from one sample of a row to the next [m]
/// origin   that texel's column and row
/// Thread   [contact]; no failure.
HeightSpan start_span(const ProjectedPatch& patch, const ProjectedTriangle& triangle,
                      double spacing, Vec2& origin) noexcept;

/// Cells by which a triangle reaches beyond its edges: enough that rounding opens no crack between
/// neighbours.
inline constexpr double kSpanOverlap = 1e-6;

}  // namespace thigma::detail
