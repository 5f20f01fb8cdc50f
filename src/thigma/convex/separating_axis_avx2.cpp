// The cached separating axis in eight floats a step. Compiled with AVX2, called only where the
// processor has it; includes only what is safe to compile so.
#include <immintrin.h>

#include "thigma/convex/detail/axis_proof.h"

namespace thigma::detail {
namespace {

struct Avx2Tops {
  static __m128 tops(const float* x, int n, float ax, float ay, float az) {
    const float *y = x + n, *z = y + n;
    const __m256 vx = _mm256_set1_ps(ax), vy = _mm256_set1_ps(ay), vz = _mm256_set1_ps(az);
    const auto eight = [&](int i) {
      return _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(_mm256_load_ps(x + i), vx),
                                         _mm256_mul_ps(_mm256_load_ps(y + i), vy)),
                           _mm256_mul_ps(_mm256_load_ps(z + i), vz));
    };
    __m256 best = eight(0);
    for (int i = 8; i < n; i += 8) best = _mm256_max_ps(best, eight(i));
    return _mm_max_ps(_mm256_castps256_ps128(best), _mm256_extractf128_ps(best, 1));
  }
  // Both maxima at once: a0 b0 a1 b1, then a b in the lower half.
  static double sum_of_largest(__m128 a, __m128 b) {
    __m128 top = _mm_max_ps(_mm_unpacklo_ps(a, b), _mm_unpackhi_ps(a, b));
    top = _mm_max_ps(top, _mm_movehl_ps(top, top));
    return static_cast<double>(_mm_cvtss_f32(top)) +
           static_cast<double>(_mm_cvtss_f32(_mm_shuffle_ps(top, top, 1)));
  }
};

}  // namespace

bool axis_separates_avx2(const HullView& a, const HullView& b, const double* r, const double* t,
                         const float* axis, double gap) noexcept {
  return axis_proves<Avx2Tops>(a, b, r, t, axis, gap);
}

}  // namespace thigma::detail
