#pragma once
// One row of a height map: the fine surface of one coarse triangle at equally spaced samples, in
// single precision. Plain types only: this header is also compiled with wider instruction sets than
// the rest.

#include <cstdint>

namespace thigma::detail {

/// Sample k lies at texture coordinates (x + k by_x, y + k by_y) about `texels`, its coarse height
/// is h + k by_h; its fine height adds the displacement times m. out[k] becomes the larger of
/// itself and that height.
struct HeightSpan {
  const float* texels = nullptr;  // four floats each; the texel the coordinates are counted from
  std::int64_t texel_row = 0;     // texels from one row to the next
  float high_x = 0.0f, high_y = 0.0f;  // the last column and row; coordinates are held in 0..high
  float x = 0.0f, by_x = 0.0f, y = 0.0f, by_y = 0.0f;
  float h = 0.0f, by_h = 0.0f;      // [m]
  float m[3] = {0.0f, 0.0f, 0.0f};  // ProjectedTriangle::carried [body frame]
  int first = 0, count = 0;         // samples first .. first + count - 1
  float* out = nullptr;             // indexed like the samples [m]
};

/// Three ways to the same bits: operations and their order are those of the scalar one, without
/// fused multiply-add.
void raise_span_scalar(const HeightSpan& span) noexcept;
void raise_span_sse2(const HeightSpan& span) noexcept;
void raise_span_avx2(const HeightSpan& span) noexcept;  // only where the processor has AVX2

/// Where a row's samples start and go: what HeightSpan has of the same names.
struct RowStart {
  float x = 0.0f, y = 0.0f, h = 0.0f;
  float* out = nullptr;
};

/// Raises sample k of a row, a texel a load; x, y, h and out are the row's. The same bits.
void raise_sample_sse2(const HeightSpan& span, const RowStart& row, int k) noexcept;

}  // namespace thigma::detail
