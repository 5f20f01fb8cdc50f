#pragma once
// The coarse triangles of a patch, row by row of a height map.

#include <span>

#include "thigma/depth/detail/quad_rows.h"
#include "thigma/depth/height_map.h"

namespace thigma::detail {

/// Raises the samples of a map to the heights of a patch's triangles.
///
/// map     of the size of the grid
/// Thread  [contact]; no failure; does not allocate.
void raise_triangles(const ProjectedPatch& patch, const MapGrid& grid, const MapReading& reading,
                     HeightMap& map) noexcept;

/// Samples of one triangle along a line.
struct LineRow {
  QuadBatch batch;  // its one row
  bool has_quads = false;
};
inline constexpr int kMostOfLine = QuadBatch::kPart;

/// In two steps, so that what one line reads comes from memory while another is looked for.
///
/// from, step  of the first sample, and from one to the next [m; contact plane]
/// out         the samples, raised to the heights: at most kMostOfLine
/// Thread      [contact]; no failure; does not allocate. In single precision, as of render_heights.
void look_for_line(const ProjectedPatch& patch, const ProjectedTriangle& triangle, const Vec2& from,
                   const Vec2& step, const MapReading& reading, std::span<float> out,
                   LineRow& line) noexcept;
void raise_line(const MapReading& reading, const LineRow& line) noexcept;

}  // namespace thigma::detail
