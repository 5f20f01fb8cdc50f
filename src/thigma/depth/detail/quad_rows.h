#pragma once
// Rows of a height map over one coarse triangle, read from the texture's quads: heights in 16 bits,
// four of a cell in one place. Plain types only: this header is also compiled with wider
// instruction sets than the rest.

#include <cstdint>

#include "thigma/depth/detail/height_span.h"

namespace thigma::detail {

/// First of a quad whose cell is read from the texels: haptic_texture.h's kMixedCell.
inline constexpr std::int32_t kMixedQuad = 65535;

/// What all rows of a triangle share. Sample k of a row lies at texture coordinates (x + k by_x,
/// y + k by_y) about `quads`; its height is h + k by_h + steps x by_step, with the steps between
/// the four of its cell.
struct QuadTriangle {
  const std::uint16_t* quads = nullptr;  // four each; the cell the coordinates are counted from
  std::int32_t quad_row = 0;             // cells from one row to the next
  float high_x = 0.0f, high_y = 0.0f;    // the last column and row; coordinates are held in 0..high
  float by_x = 0.0f, by_y = 0.0f;
  float by_h = 0.0f, by_step = 0.0f;  // [m]
  HeightSpan texels;                  // the same by displacements, for samples over mixed cells
  const float* end = nullptr;         // of the samples of all rows: wide steps stay before it
};

/// A row's part of it.
struct QuadRow {
  float x = 0.0f, y = 0.0f;
  float h = 0.0f;            // coarse, with the lowest step [m]
  float h_texels = 0.0f;     // coarse [m]
  int first = 0, count = 0;  // samples first .. first + count - 1
  float* out = nullptr;      // indexed like the samples [m]
};

/// Rows that are looked up together, and where their samples lie.
struct QuadBatch {
  static constexpr int kRows = 8;
  static constexpr int kPart = 64;  // samples of a row, at most
  static constexpr int kFull = 96;  // samples: with as many, no further row is added
  static constexpr int kSamples = kFull + kPart + 8;  // and what the last step may write beyond
  QuadTriangle triangle;
  QuadRow rows[kRows];
  int row_count = 0, sample_count = 0;           // samples of all rows, one after the other below
  alignas(32) float ax[kSamples], ay[kSamples];  // within their cells
  alignas(32) std::int32_t cell[kSamples];       // from QuadTriangle::quads
};

/// In two steps with other work between them: find the cells of a batch, which are then on their
/// way to the processor, and raise its samples. Three ways to the same bits: operations and their
/// order are those of the scalar one, without fused multiply-add.
void locate_scalar(QuadBatch& batch) noexcept;
void locate_sse2(QuadBatch& batch) noexcept;
void locate_avx2(QuadBatch& batch) noexcept;  // only where the processor has AVX2
void raise_scalar(const QuadBatch& batch) noexcept;
void raise_sse2(const QuadBatch& batch) noexcept;
void raise_avx2(const QuadBatch& batch) noexcept;

/// Raises sample k of a row by its texels: what stands for a mixed cell. By the scalar definition,
/// and to the same bits a texel a load.
void raise_mixed(const QuadTriangle& triangle, const QuadRow& row, int k) noexcept;
void raise_mixed_sse2(const QuadTriangle& triangle, const QuadRow& row, int k) noexcept;

}  // namespace thigma::detail
