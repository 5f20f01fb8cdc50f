// Height spans with one load for two texels. Compiled with AVX2, called only where the processor has it; includes
// only what is safe to compile so.
#include <immintrin.h>

#include "thigma/texture/detail/height_span_lanes.h"

namespace thigma::detail {
namespace {

struct Avx2Blend {
  static __m128 blend(const float* top, const float* bottom, __m128 ax, __m128 ay) {
    const __m256 t = _mm256_loadu_ps(top);
    const __m256 both = _mm256_set_m128(ay, ay);
    const __m256 column =
        _mm256_add_ps(t, _mm256_mul_ps(both, _mm256_sub_ps(_mm256_loadu_ps(bottom), t)));
    const __m128 left = _mm256_castps256_ps128(column), right = _mm256_extractf128_ps(column, 1);
    return _mm_add_ps(left, _mm_mul_ps(ax, _mm_sub_ps(right, left)));
  }
};

}  // namespace

void raise_span_avx2(const HeightSpan& span) noexcept { raise_span<Avx2Blend>(span); }

}  // namespace thigma::detail
