// closest_points_batch in four doubles a step. Compiled with AVX2, called only where the processor
// has it: includes nothing but intrinsics and headers that are safe to compile so (see
// detail/verify_cached_simplices.h).
#include <immintrin.h>

#include "thigma/convex/detail/gjk_batch.h"

namespace thigma::detail {
namespace {

struct Avx2Lanes {
  using Real = __m256d;
  using Small = __m128;
  static constexpr int kLanes = 4;
  static __m256d splat(double s) { return _mm256_set1_pd(s); }
  static __m256d pick(const double* const (&p)[4]) {
    const __m128d low = _mm_loadh_pd(_mm_load_sd(p[0]), p[1]);
    const __m128d high = _mm_loadh_pd(_mm_load_sd(p[2]), p[3]);
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(low), high, 1);
  }
  static void store(__m256d v, double* p) { _mm256_storeu_pd(p, v); }
  static __m256d magnitude(__m256d v) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), v); }
  static __m256d root(__m256d v) { return _mm256_sqrt_pd(v); }
  template <class Mask>
  static unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm256_movemask_pd((__m256d)mask));
  }
  static __m128 small(float s) { return _mm_set1_ps(s); }
  static __m128 narrow(__m256d v) { return _mm256_cvtpd_ps(v); }
  static __m128 magnitude(__m128 v) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }
  template <class Mask>
  static unsigned small_bits(Mask mask) {
    return static_cast<unsigned>(_mm_movemask_ps((__m128)mask));
  }
  static void store(__m128 v, float* p) { _mm_storeu_ps(p, v); }
  static __m256d both(const double* low, const double* high) {
    return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(low)), _mm_loadu_pd(high), 1);
  }
  static void gather(const double* const (&p)[4], __m256d& x, __m256d& y, __m256d& z) {
    const __m256d p02 = both(p[0], p[2]), p13 = both(p[1], p[3]);
    x = _mm256_unpacklo_pd(p02, p13);
    y = _mm256_unpackhi_pd(p02, p13);
    const __m128d z01 = _mm_loadh_pd(_mm_load_sd(p[0] + 2), p[1] + 2);
    const __m128d z23 = _mm_loadh_pd(_mm_load_sd(p[2] + 2), p[3] + 2);
    z = _mm256_insertf128_pd(_mm256_castpd128_pd256(z01), z23, 1);
  }
  static void scatter(__m256d x, __m256d y, __m256d z, double* const (&p)[4]) {
    const __m256d p02 = _mm256_unpacklo_pd(x, y), p13 = _mm256_unpackhi_pd(x, y);
    _mm_storeu_pd(p[0], _mm256_castpd256_pd128(p02));
    _mm_storeu_pd(p[1], _mm256_castpd256_pd128(p13));
    _mm_storeu_pd(p[2], _mm256_extractf128_pd(p02, 1));
    _mm_storeu_pd(p[3], _mm256_extractf128_pd(p13, 1));
    const __m128d z01 = _mm256_castpd256_pd128(z), z23 = _mm256_extractf128_pd(z, 1);
    _mm_storel_pd(p[0] + 2, z01);
    _mm_storeh_pd(p[1] + 2, z01);
    _mm_storel_pd(p[2] + 2, z23);
    _mm_storeh_pd(p[3] + 2, z23);
  }
  [[gnu::always_inline]] static std::uint32_t not_lower(const float* x, int n, float dx, float dy,
                                                        float dz, float limit) {
    const float *y = x + n, *z = y + n;
    const __m256 ax = _mm256_set1_ps(dx), ay = _mm256_set1_ps(dy), az = _mm256_set1_ps(dz);
    const __m256 least = _mm256_set1_ps(limit);
    std::uint32_t mask = 0;
    for (int i = 0; i < n; i += 8) {
      const __m256 h = _mm256_add_ps(_mm256_add_ps(_mm256_mul_ps(_mm256_load_ps(x + i), ax),
                                                   _mm256_mul_ps(_mm256_load_ps(y + i), ay)),
                                     _mm256_mul_ps(_mm256_load_ps(z + i), az));
      const int m = _mm256_movemask_ps(_mm256_cmp_ps(h, least, _CMP_GE_OQ));
      mask |= static_cast<std::uint32_t>(m) << i;
    }
    return mask;
  }
};

}  // namespace

void closest_points_batch_avx2(const GjkQuery* queries, std::size_t count, const RelativePose& x,
                               const PlainPose& plain, double stop, Separation* out) noexcept {
  run_batch<Avx2Lanes>(queries, count, x, plain, stop, out);
}

}  // namespace thigma::detail
