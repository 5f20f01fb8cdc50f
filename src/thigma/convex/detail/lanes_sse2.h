#pragma once
// One and two doubles a step for verify_cached_simplices, on what every x86-64 has.

#include <cmath>
#include <cstdint>

#include <emmintrin.h>

namespace thigma::detail {

struct Sse2Heights {
  /// Mask of the lanes whose height along d is not below limit; n a multiple of 8.
  [[gnu::always_inline]] static std::uint32_t not_lower(const float* x, int n, float dx, float dy,
                                                        float dz, float limit) {
    const float *y = x + n, *z = y + n;
    const __m128 ax = _mm_set1_ps(dx), ay = _mm_set1_ps(dy), az = _mm_set1_ps(dz);
    const __m128 least = _mm_set1_ps(limit);
    const auto four = [&](int i) {
      const __m128 h = _mm_add_ps(
          _mm_add_ps(_mm_mul_ps(_mm_load_ps(x + i), ax), _mm_mul_ps(_mm_load_ps(y + i), ay)),
          _mm_mul_ps(_mm_load_ps(z + i), az));
      return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmpge_ps(h, least)));
    };
    std::uint32_t mask = 0;
    for (int i = 0; i < n; i += 8) mask |= (four(i) | four(i + 4) << 4) << i;
    return mask;
  }
};

/// One pair at a time.
struct ScalarLanes : Sse2Heights {
  using Real = double;
  using Small = float;
  static constexpr int kLanes = 1;
  static double splat(double s) { return s; }
  static double pick(const double* const (&p)[1]) { return *p[0]; }
  static void store(double v, double* p) { *p = v; }
  static double magnitude(double v) { return std::fabs(v); }
  // Without the library's branch on negative numbers.
  static double root(double v) { return _mm_cvtsd_f64(_mm_sqrt_sd(_mm_set_sd(v), _mm_set_sd(v))); }
  static unsigned bits(bool mask) { return mask; }
  static float small(float s) { return s; }
  static float narrow(double v) { return static_cast<float>(v); }
  static float magnitude(float v) { return std::fabs(v); }
  static unsigned small_bits(bool mask) { return mask; }
  static void store(float v, float* p) { *p = v; }
  static void gather(const double* const (&p)[1], double& x, double& y, double& z) {
    x = p[0][0];
    y = p[0][1];
    z = p[0][2];
  }
  static void scatter(double x, double y, double z, double* const (&p)[1]) {
    p[0][0] = x;
    p[0][1] = y;
    p[0][2] = z;
  }
};

/// Two pairs at a time.
struct Sse2Lanes : Sse2Heights {
  using Real = __m128d;
  using Small = __m128;  // the lower half counts
  static constexpr int kLanes = 2;
  static __m128d splat(double s) { return _mm_set1_pd(s); }
  static __m128d pick(const double* const (&p)[2]) { return _mm_loadh_pd(_mm_load_sd(p[0]), p[1]); }
  static void store(__m128d v, double* p) { _mm_storeu_pd(p, v); }
  static __m128d magnitude(__m128d v) { return _mm_andnot_pd(_mm_set1_pd(-0.0), v); }
  static __m128d root(__m128d v) { return _mm_sqrt_pd(v); }
  template <class Mask>
  static unsigned bits(Mask mask) {
    return static_cast<unsigned>(_mm_movemask_pd((__m128d)mask));
  }
  static __m128 small(float s) { return _mm_set1_ps(s); }
  static __m128 narrow(__m128d v) { return _mm_cvtpd_ps(v); }
  static __m128 magnitude(__m128 v) { return _mm_andnot_ps(_mm_set1_ps(-0.0f), v); }
  template <class Mask>
  static unsigned small_bits(Mask mask) {
    return static_cast<unsigned>(_mm_movemask_ps((__m128)mask)) & 3u;
  }
  static void store(__m128 v, float* p) { _mm_storel_pi(reinterpret_cast<__m64*>(p), v); }
  static void gather(const double* const (&p)[2], __m128d& x, __m128d& y, __m128d& z) {
    const __m128d p0 = _mm_loadu_pd(p[0]), p1 = _mm_loadu_pd(p[1]);
    x = _mm_unpacklo_pd(p0, p1);
    y = _mm_unpackhi_pd(p0, p1);
    z = _mm_loadh_pd(_mm_load_sd(p[0] + 2), p[1] + 2);
  }
  static void scatter(__m128d x, __m128d y, __m128d z, double* const (&p)[2]) {
    _mm_storeu_pd(p[0], _mm_unpacklo_pd(x, y));
    _mm_storeu_pd(p[1], _mm_unpackhi_pd(x, y));
    _mm_storel_pd(p[0] + 2, z);
    _mm_storeh_pd(p[1] + 2, z);
  }
};

}  // namespace thigma::detail
