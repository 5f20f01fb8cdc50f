// Height spans eight samples at a time, one load for two texels. Compiled with AVX2, called only
// where the processor has it; includes only what is safe to compile so.
#include <immintrin.h>

#include "thigma/depth/detail/height_span.h"

namespace thigma::detail {
namespace {

// A span with every number in all lanes, in registers: stores to the map could otherwise change it.
struct Lanes {
  __m256 x, by_x, high_x, y, by_y, high_y, h, by_h;
  __m256 m;  // HeightSpan::m and -0, twice
  __m256i texel_row;
  const float* texels;
  std::int64_t row;  // floats from one row of texels to the next
  float* out;
};

Lanes lanes_of(const HeightSpan& span) {
  const auto all = [](float value) { return _mm256_set1_ps(value); };
  // The fourth float of a texel is 0, and adding -0 to the sum over three changes no bit of it.
  const __m256 m = _mm256_setr_ps(span.m[0], span.m[1], span.m[2], -0.0f, span.m[0], span.m[1],
                                  span.m[2], -0.0f);
  return {all(span.x),
          all(span.by_x),
          all(span.high_x),
          all(span.y),
          all(span.by_y),
          all(span.high_y),
          all(span.h),
          all(span.by_h),
          m,
          _mm256_set1_epi32(static_cast<int>(span.texel_row)),
          span.texels,
          4 * span.texel_row,
          span.out};
}

// Weights and places of eight samples; bytes stay within 32 bits for as many texels as there may
// be.
struct Places {
  __m256 ax;
  alignas(32) float ay[8];
  alignas(32) std::int32_t bytes[8];
};

// Displacement times m, component by component, of samples i (lower half) and i + 4.
__m256 product(const Lanes& s, const Places& p, int i) {
  const auto column = [&](int k) {
    const float* const top =
        reinterpret_cast<const float*>(reinterpret_cast<const char*>(s.texels) + p.bytes[k]);
    const __m256 t = _mm256_loadu_ps(top), b = _mm256_loadu_ps(top + s.row);
    return _mm256_add_ps(t, _mm256_mul_ps(_mm256_broadcast_ss(p.ay + k), _mm256_sub_ps(b, t)));
  };
  const __m256 low = column(i), high = column(i + 4);
  const __m256 left = _mm256_permute2f128_ps(low, high, 0x20);
  const __m256 right = _mm256_permute2f128_ps(low, high, 0x31);
  const __m256i which = _mm256_setr_epi32(i, i, i, i, i + 4, i + 4, i + 4, i + 4);
  const __m256 ax = _mm256_permutevar8x32_ps(p.ax, which);
  const __m256 d = _mm256_add_ps(left, _mm256_mul_ps(ax, _mm256_sub_ps(right, left)));
  return _mm256_mul_ps(s.m, d);
}

// Heights of eight samples from k on.
__m256 heights(const Lanes& s, int k) {
  const __m256 steps =
      _mm256_add_ps(_mm256_set1_ps(static_cast<float>(k)),
                    _mm256_setr_ps(0.0f, 1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f));
  __m256 x = _mm256_add_ps(s.x, _mm256_mul_ps(steps, s.by_x));
  __m256 y = _mm256_add_ps(s.y, _mm256_mul_ps(steps, s.by_y));
  x = _mm256_min_ps(_mm256_max_ps(x, _mm256_setzero_ps()), s.high_x);
  y = _mm256_min_ps(_mm256_max_ps(y, _mm256_setzero_ps()), s.high_y);
  const __m256i column = _mm256_cvttps_epi32(x), row = _mm256_cvttps_epi32(y);
  Places p;
  p.ax = _mm256_sub_ps(x, _mm256_cvtepi32_ps(column));
  _mm256_store_ps(p.ay, _mm256_sub_ps(y, _mm256_cvtepi32_ps(row)));
  const __m256i texel = _mm256_add_epi32(_mm256_mullo_epi32(row, s.texel_row), column);
  _mm256_store_si256(reinterpret_cast<__m256i*>(p.bytes), _mm256_slli_epi32(texel, 4));
  // Sums of neighbours, then of these: (x + y) + z of each sample, in order in each half.
  const __m256 even = _mm256_hadd_ps(product(s, p, 0), product(s, p, 1));
  const __m256 odd = _mm256_hadd_ps(product(s, p, 2), product(s, p, 3));
  const __m256 coarse = _mm256_add_ps(s.h, _mm256_mul_ps(steps, s.by_h));
  return _mm256_add_ps(coarse, _mm256_hadd_ps(even, odd));
}

}  // namespace

void raise_span_avx2(const HeightSpan& span) noexcept {
  const int last = span.first + span.count;
  int k = span.first;
  if (span.count < 4) {  // masked stores take longer
    for (; k < last; ++k) raise_sample_sse2(span, {span.x, span.y, span.h, span.out}, k);
    return;
  }
  const Lanes lanes = lanes_of(span);
  for (; k + 8 <= last; k += 8) {
    float* const out = lanes.out + k;
    // The order of the operands is that of the scalar comparison.
    _mm256_storeu_ps(out, _mm256_max_ps(heights(lanes, k), _mm256_loadu_ps(out)));
  }
  if (k >= last) return;
  // Coordinates are held within the map, so lanes beyond the end read what is there; they are not
  // written.
  const __m256i is_within =
      _mm256_cmpgt_epi32(_mm256_set1_epi32(last - k), _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7));
  float* const out = lanes.out + k;
  const __m256 there = _mm256_maskload_ps(out, is_within);
  _mm256_maskstore_ps(out, is_within, _mm256_max_ps(heights(lanes, k), there));
}

}  // namespace thigma::detail
