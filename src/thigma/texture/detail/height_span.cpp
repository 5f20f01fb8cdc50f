#include "thigma/texture/detail/height_span.h"

#include <emmintrin.h>

#include "thigma/texture/detail/height_span_lanes.h"

namespace thigma::detail {
namespace {

// Rows of texels as two loads each.
struct Sse2Blend {
  static __m128 blend(const float* top, const float* bottom, __m128 ax, __m128 ay) {
    const __m128 a = _mm_load_ps(top), b = _mm_load_ps(top + 4);
    const __m128 left = _mm_add_ps(a, _mm_mul_ps(ay, _mm_sub_ps(_mm_load_ps(bottom), a)));
    const __m128 right = _mm_add_ps(b, _mm_mul_ps(ay, _mm_sub_ps(_mm_load_ps(bottom + 4), b)));
    return _mm_add_ps(left, _mm_mul_ps(ax, _mm_sub_ps(right, left)));
  }
};

}  // namespace

void raise_span_scalar(const HeightSpan& span) noexcept {
  raise_samples(span, span.first, span.first + span.count);
}

void raise_span_sse2(const HeightSpan& span) noexcept { raise_span<Sse2Blend>(span); }

}  // namespace thigma::detail
