#pragma once
// What all rows of a triangle in a height map share.

#include "thigma/depth/detail/quad_rows.h"
#include "thigma/depth/projected_patch.h"

namespace thigma::detail {

/// Texels, steps and direction of the spans of a triangle. Coordinates are counted from a texel of
/// the triangle, so that single precision resolves its texels, not the map's.
///
/// step    from one sample to the next [m; contact plane]
/// origin  that texel's column and row
/// Thread  [contact]; no failure.
HeightSpan start_span(const ProjectedPatch& patch, const ProjectedTriangle& triangle,
                      const Vec2& step, Vec2& origin) noexcept;

/// Adds the quads to the spans of a triangle, `texels`; false where its heights are not to be told
/// by them: `carried` is the normal over its cosine but for triangles steeper than 45 degrees, and
/// there displacements of several directions need all of it.
///
/// low     height of the quads' lowest step, which a row's h has and its h_texels has not [m]
/// Thread  [contact]; no failure.
bool add_quads(const ProjectedPatch& patch, const ProjectedTriangle& triangle, const Vec2& origin,
               QuadTriangle& to, double& low) noexcept;

/// Cells by which a triangle reaches beyond its edges: enough that rounding opens no crack between
/// neighbours.
inline constexpr double kSpanOverlap = 1e-6;

}  // namespace thigma::detail
