#include "thigma/depth/detail/height_span.h"

#include <emmintrin.h>

namespace thigma::detail {
namespace {

// Samples of `span` from first to last - 1, by the scalar definition.
void raise_samples(const HeightSpan& span, int first, int last) noexcept {
  for (int k = first; k < last; ++k) {
    const float step = static_cast<float>(k);
    float x = span.x + step * span.by_x;
    float y = span.y + step * span.by_y;
    x = x > 0.0f ? x : 0.0f;
    x = x < span.high_x ? x : span.high_x;
    y = y > 0.0f ? y : 0.0f;
    y = y < span.high_y ? y : span.high_y;
    const float column = static_cast<float>(static_cast<std::int32_t>(x));
    const float row = static_cast<float>(static_cast<std::int32_t>(y));
    const float ax = x - column, ay = y - row;
    const float* top = span.texels + 4 * (static_cast<std::int64_t>(row) * span.texel_row +
                                          static_cast<std::int64_t>(column));
    const float* bottom = top + 4 * span.texel_row;
    float d[3];
    for (int c = 0; c < 3; ++c) {
      const float left = top[c] + ay * (bottom[c] - top[c]);
      const float right = top[c + 4] + ay * (bottom[c + 4] - top[c + 4]);
      d[c] = left + ax * (right - left);
    }
    const float height =
        (span.h + step * span.by_h) + ((span.m[0] * d[0] + span.m[1] * d[1]) + span.m[2] * d[2]);
    span.out[k] = height > span.out[k] ? height : span.out[k];
  }
}

// Rows of two texels blended, each texel a load.
__m128 blend(const float* top, const float* bottom, __m128 ax, __m128 ay) noexcept {
  const __m128 a = _mm_load_ps(top), b = _mm_load_ps(top + 4);
  const __m128 left = _mm_add_ps(a, _mm_mul_ps(ay, _mm_sub_ps(_mm_load_ps(bottom), a)));
  const __m128 right = _mm_add_ps(b, _mm_mul_ps(ay, _mm_sub_ps(_mm_load_ps(bottom + 4), b)));
  return _mm_add_ps(left, _mm_mul_ps(ax, _mm_sub_ps(right, left)));
}

// A span with every number in all four lanes, in registers: stores to the map could otherwise
// change it.
struct SpanLanes {
  __m128 x, by_x, high_x, y, by_y, high_y, h, by_h, mx, my, mz;
  __m128i texel_row;
  const float* texels;
  std::int64_t row;  // floats from one row of texels to the next
  float* out;
};

SpanLanes lanes_of(const HeightSpan& span) noexcept {
  const auto all = [](float value) { return _mm_set1_ps(value); };
  return {all(span.x),    all(span.by_x),     all(span.high_x),
          all(span.y),    all(span.by_y),     all(span.high_y),
          all(span.h),    all(span.by_h),     all(span.m[0]),
          all(span.m[1]), all(span.m[2]),     _mm_set1_epi32(static_cast<int>(span.texel_row)),
          span.texels,    4 * span.texel_row, span.out};
}

// Four samples from k on.
void raise_four(const SpanLanes& s, int k) noexcept {
  const __m128 steps =
      _mm_add_ps(_mm_set1_ps(static_cast<float>(k)), _mm_setr_ps(0.0f, 1.0f, 2.0f, 3.0f));
  __m128 x = _mm_add_ps(s.x, _mm_mul_ps(steps, s.by_x));
  __m128 y = _mm_add_ps(s.y, _mm_mul_ps(steps, s.by_y));
  x = _mm_min_ps(_mm_max_ps(x, _mm_setzero_ps()), s.high_x);
  y = _mm_min_ps(_mm_max_ps(y, _mm_setzero_ps()), s.high_y);
  const __m128i column = _mm_cvttps_epi32(x), row = _mm_cvttps_epi32(y);
  const __m128 ax = _mm_sub_ps(x, _mm_cvtepi32_ps(column));
  const __m128 ay = _mm_sub_ps(y, _mm_cvtepi32_ps(row));
  // Texel indices row * texel_row + column as 64-bit numbers: of the even samples, then of the odd
  // ones.
  const __m128i low = _mm_set1_epi64x(0xffffffff);
  const __m128i even = _mm_add_epi64(_mm_mul_epu32(row, s.texel_row), _mm_and_si128(column, low));
  const __m128i odd = _mm_add_epi64(_mm_mul_epu32(_mm_srli_epi64(row, 32), s.texel_row),
                                    _mm_srli_epi64(column, 32));
  alignas(16) std::int64_t index[4];
  _mm_store_si128(reinterpret_cast<__m128i*>(index), _mm_slli_epi64(even, 2));
  _mm_store_si128(reinterpret_cast<__m128i*>(index + 2), _mm_slli_epi64(odd, 2));
  const auto lane = [&](int i, __m128 wx, __m128 wy) {
    const float* top = s.texels + index[i];
    return blend(top, top + s.row, wx, wy);
  };
  __m128 d0 = lane(0, _mm_shuffle_ps(ax, ax, 0x00), _mm_shuffle_ps(ay, ay, 0x00));
  __m128 d1 = lane(2, _mm_shuffle_ps(ax, ax, 0x55), _mm_shuffle_ps(ay, ay, 0x55));
  __m128 d2 = lane(1, _mm_shuffle_ps(ax, ax, 0xaa), _mm_shuffle_ps(ay, ay, 0xaa));
  __m128 d3 = lane(3, _mm_shuffle_ps(ax, ax, 0xff), _mm_shuffle_ps(ay, ay, 0xff));
  _MM_TRANSPOSE4_PS(d0, d1, d2, d3);  // now d0 holds the x of the four samples, d1 the y, d2 the z
  const __m128 along =
      _mm_add_ps(_mm_add_ps(_mm_mul_ps(s.mx, d0), _mm_mul_ps(s.my, d1)), _mm_mul_ps(s.mz, d2));
  const __m128 coarse = _mm_add_ps(s.h, _mm_mul_ps(steps, s.by_h));
  // The order of the operands is that of the scalar comparison.
  _mm_storeu_ps(s.out + k, _mm_max_ps(_mm_add_ps(coarse, along), _mm_loadu_ps(s.out + k)));
}

}  // namespace

void raise_sample_sse2(const HeightSpan& span, const RowStart& row, int k) noexcept {
  const auto held = [](float at, float high) {
    return _mm_cvtss_f32(
        _mm_min_ss(_mm_max_ss(_mm_set_ss(at), _mm_setzero_ps()), _mm_set_ss(high)));
  };
  const float step = static_cast<float>(k);
  const float x = held(row.x + step * span.by_x, span.high_x),
              y = held(row.y + step * span.by_y, span.high_y);
  const std::int32_t column = static_cast<std::int32_t>(x), line = static_cast<std::int32_t>(y);
  const float* const top = span.texels + 4 * (line * span.texel_row + column);
  const __m128 d = blend(top, top + 4 * span.texel_row, _mm_set1_ps(x - static_cast<float>(column)),
                         _mm_set1_ps(y - static_cast<float>(line)));
  const __m128 m = _mm_mul_ps(_mm_setr_ps(span.m[0], span.m[1], span.m[2], 0.0f), d);
  const __m128 along = _mm_add_ss(_mm_add_ss(m, _mm_shuffle_ps(m, m, 0x55)), _mm_movehl_ps(m, m));
  const float height = (row.h + step * span.by_h) + _mm_cvtss_f32(along);
  row.out[k] = height > row.out[k] ? height : row.out[k];
}

void raise_span_scalar(const HeightSpan& span) noexcept {
  raise_samples(span, span.first, span.first + span.count);
}

void raise_span_sse2(const HeightSpan& span) noexcept {
  const int last = span.first + span.count;
  if (span.count < 4) {
    for (int k = span.first; k < last; ++k)
      raise_sample_sse2(span, {span.x, span.y, span.h, span.out}, k);
    return;
  }
  const SpanLanes lanes = lanes_of(span);
  int k = span.first;
  for (; k + 4 <= last; k += 4) raise_four(lanes, k);
  // The rest once more with some of what was done: raising twice changes nothing.
  if (k < last) raise_four(lanes, last - 4);
}

}  // namespace thigma::detail
