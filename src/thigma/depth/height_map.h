#pragma once
// Height maps of projected patches on a grid, and the largest sum of two of them.

#include <cstdint>
#include <vector>

#include "thigma/depth/projected_patch.h"

namespace thigma {

/// Samples of the plane (u, v): the centres of columns x rows cells over a box.
struct MapGrid {
  PlaneBox box;
  int columns = 0, rows = 0;
  Vec2 spacing() const noexcept { return (box.high - box.low).cwiseQuotient(Vec2(columns, rows)); }
  Vec2 at(double column, double row) const noexcept {
    return box.low + spacing().cwiseProduct(Vec2(column + 0.5, row + 0.5));
  }
};

/// What a sample holds where the patch does not lie [m]. Finite, so that interpolating beside it
/// stays a number.
inline constexpr float kEmptySample = -1e30f;

/// Heights along the facing direction, row by row [m].
struct HeightMap {
  int columns = 0, rows = 0;
  std::vector<float> heights;
};

enum class SpanWidth : std::uint8_t {
  scalar,  // the reference: one sample at a time
  widest,  // four samples, eight and two texels a load where the processor has AVX2; the same bits
};

/// How a map is read of a texture.
struct MapReading {
  SpanWidth width = SpanWidth::widest;
  bool has_quads = true;  // heights in 16 bits; false: displacements, as a graphics processor does
};

/// Renders a patch: at every sample the height of its fine surface, the largest of several sheets.
///
/// map       overwritten; sized to the grid, memory is kept
/// Thread    [contact]; no failure; allocates for a grid larger than ever before. In single
///           precision about the frame's origin: 1e-7 of the patch's height range plus 1e-7 of its
///           texels' number times the relief's slope. Quads add 1/65,536 of the range of heights,
///           over the cosine between the triangle's normal and the facing direction.
/// Source    Sec. 4.4.2, Eq. 4.9.
void render_heights(const ProjectedPatch& patch, const MapGrid& grid, const MapReading& reading,
                    HeightMap& map) noexcept;

/// The largest sum of two maps and where it is; ties: the first in row order. column -1 where the
/// maps share nothing. With one map along n and the other against it, this is Eq. 4.10.
struct MapMaximum {
  float sum = 2.0f * kEmptySample;  // [m]
  int column = -1, row = -1;
};
MapMaximum largest_sum(const HeightMap& a, const HeightMap& b) noexcept;

/// A turn about the plane's normal, then a shift [rad, m].
struct PlaneMotion {
  Vec2 centre = Vec2::Zero();
  double turn = 0.0;
  Vec2 shift = Vec2::Zero();
};

/// The map of a patch after a motion within the plane, read off the map before it: heights at
/// samples between the old ones by bilinear interpolation, none where an old sample is missing or
/// was outside.
///
/// map       at least 2 x 2
/// moved     overwritten, sized like map; not the same object
/// Thread    [contact]; no failure. Shifts by whole cells are exact.
/// Source    Sec. 4.4.2: 6 height functions instead of 11.
void move_map(const HeightMap& map, const MapGrid& grid, const PlaneMotion& motion,
              HeightMap& moved) noexcept;

}  // namespace thigma
