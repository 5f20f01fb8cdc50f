#pragma once
// A haptic texture: fine geometry as an image over the charts of a coarse surface.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

inline constexpr int kMaxTextureSide = 16384;                      // texels along one side
inline constexpr std::int64_t kMaxTexels = std::int64_t{1} << 26;  // of one texture: 1.5 GiB

/// Displacement from the coarse surface to the fine one [m; body frame]. 16 bytes, so that one load
/// fetches it whole.
struct alignas(16) Texel {
  float x = 0.0f, y = 0.0f, z = 0.0f, unused = 0.0f;
};

/// Componentwise bounds of texels [m; body frame].
struct TexelBounds {
  Texel low, high;
};

/// One level of the pyramid. Cell (i, j) of level k bounds the texels from (i, j) 2^k to (i + 1, j
/// + 1) 2^k, both ends included, so that it also bounds what is interpolated between them.
struct BoundsLevel {
  int columns = 0, rows = 0;
  std::vector<TexelBounds> cells;  // row by row
};

/// Heights over the coarse surface at the four texels around a cell of the map, (0, 0), (1, 0),
/// (0, 1), (1, 1), in steps above the lowest. 8 bytes, so that one load fetches them and a cache
/// line has eight.
struct alignas(8) HeightQuad {
  std::array<std::uint16_t, 4> steps = {};
};

inline constexpr std::uint16_t kMostSteps = 65534;
/// steps[0] of a cell whose texels are not to be told by one height each: triangles of different
/// normals lie over it.
inline constexpr std::uint16_t kMixedCell = 65535;

/// What height maps read of a texture: heights to 1/65,536 of their range, not displacements.
/// Depths and slopes themselves are those of the texels.
struct HeightQuads {
  double low = 0.0, step = 0.0;  // a height is low + steps x step [m]
  // unit: what all displacements lie along [body frame]; zero: heights are along the normal of the
  // coarse triangle over the cell
  Vec3 along = Vec3::Zero();
  std::vector<HeightQuad> cells;  // width x height, row by row: of the texel and the next ones
};

/// A coarse surface and what is added to it per texel: the fine point over texture coordinates t of
/// a triangle is P(t) + d(t), P affine on the triangle, d interpolated bilinearly.
///
/// Texture coordinates are in texels: the texel of column i and row j has its centre at (i, j).
/// What lies beyond the outermost centres takes their value.
/// Invariant: as make_texture leaves it. Thread: immutable while used.
struct HapticTexture {
  TriangleMesh coarse;  // [m; body frame]
  // texture coordinates of the triangles' corners [texels]
  std::vector<std::array<Vec2, 3>> corners;
  int width = 0, height = 0;  // texels
  // (height + 1) rows of width + 1: the last row and column are repeated
  std::vector<Texel> texels;
  std::vector<BoundsLevel> pyramid;  // levels 1, 2, .. up to a single cell
  // bounds of the texels that a triangle reads, and one more around; none: those of the whole map
  std::vector<TexelBounds> under;
  HeightQuads quads;
  double texel_size = 0.0;  // mean side of a texel on the coarse surface [m]
  double amplitude = 0.0;   // half the range of displacements along the coarse normals [m]
};

/// What a texture is made of.
struct TextureSource {
  TriangleMesh coarse;
  // [texels], within half a texel of the outermost centres
  std::vector<std::array<Vec2, 3>> corners;
  int width = 1, height = 1;
  std::vector<Texel> texels;  // width x height, row by row
};

/// Checks a source and builds the pyramid.
///
/// source    taken over
/// name      of the file, for messages
/// returns   the texture
/// Thread    [offline]; throws InputError: no texture coordinates, coordinates out of the map, a
///           triangle without area in the map, two triangles over one texel, sizes out of 1..16384
///           or above 2^26 texels, texels missing, not finite, or larger than the coarse surface
///           itself.
/// Source    Sec. 4.2.2, 4.4.2.
HapticTexture make_texture(TextureSource source, const std::string& name);

/// A surface without relief, for contacts of textured with plain objects: one texel of zero.
/// Thread    [offline]; throws InputError for a mesh without triangles.
HapticTexture make_plain_texture(TriangleMesh coarse, const std::string& name);

inline const Texel& texel_at(const HapticTexture& texture, int column, int row) noexcept {
  return texture
      .texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width + 1) +
              static_cast<std::size_t>(column)];
}

}  // namespace thigma
