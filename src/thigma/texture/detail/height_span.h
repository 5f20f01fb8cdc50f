#pragma once
// One row of a height map: the fine surface of one coarse triangle at equally spaced samples, in single precision.
// Plain types only: this header is also compiled with wider instruction sets than the rest.

#include <cstdint>

namespace thigma::detail {

/// Sample k lies at texture coordinates (x + k by_x, y + k by_y) about `texels`, its coarse height is h + k by_h; its
/// fine height adds the displacement along m. out[k] becomes the larger of itself and that height.
struct HeightSpan {
  const float* texels = nullptr;  // four floats each; the texel the coordinates are counted from
  std::int64_t texel_row = 0;     // texels from one row to the next
  float high_x = 0.0f, high_y = 0.0f;  // the last column and row; coordinates are held in 0..high
  float x = 0.0f, by_x = 0.0f, y = 0.0f, by_y = 0.0f;
  float h = 0.0f, by_h = 0.0f;      // [m]
  float m[3] = {0.0f, 0.0f, 0.0f};  // facing direction [body frame]
  int first = 0, count = 0;         // samples first .. first + count - 1
  float* out = nullptr;             // indexed like the samples [m]
};

/// Three ways to the same bits: operations and their order are those of the scalar one, without fused multiply-add.
void raise_span_scalar(const HeightSpan& span) noexcept;
void raise_span_sse2(const HeightSpan& span) noexcept;
void raise_span_avx2(const HeightSpan& span) noexcept;  // only where the processor has AVX2

/// Samples of `span` from first to last - 1, by the scalar definition: for what does not fill a vector. Static, so that
/// the copy compiled for wider vectors stays in its own object.
static inline void raise_samples(const HeightSpan& s, int first, int last) noexcept {
  for (int k = first; k < last; ++k) {
    const float step = static_cast<float>(k);
    float x = s.x + step * s.by_x;
    float y = s.y + step * s.by_y;
    x = x > 0.0f ? x : 0.0f;
    x = x < s.high_x ? x : s.high_x;
    y = y > 0.0f ? y : 0.0f;
    y = y < s.high_y ? y : s.high_y;
    const float column = static_cast<float>(static_cast<std::int32_t>(x));
    const float row = static_cast<float>(static_cast<std::int32_t>(y));
    const float ax = x - column, ay = y - row;
    const float* top = s.texels + 4 * (static_cast<std::int64_t>(row) * s.texel_row +
                                       static_cast<std::int64_t>(column));
    const float* bottom = top + 4 * s.texel_row;
    float d[3];
    for (int c = 0; c < 3; ++c) {
      const float left = top[c] + ay * (bottom[c] - top[c]);
      const float right = top[c + 4] + ay * (bottom[c + 4] - top[c + 4]);
      d[c] = left + ax * (right - left);
    }
    const float height = (s.h + step * s.by_h) + ((s.m[0] * d[0] + s.m[1] * d[1]) + s.m[2] * d[2]);
    s.out[k] = height > s.out[k] ? height : s.out[k];
  }
}

}  // namespace thigma::detail
