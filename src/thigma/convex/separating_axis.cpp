// The cached separating axis in four floats a step, and the choice of the width.
#include <emmintrin.h>

#include "thigma/convex/detail/axis_proof.h"
#include "thigma/convex/gjk.h"

namespace thigma {
namespace detail {
namespace {

struct Sse2Tops {
  static __m128 tops(const float* x, int n, float ax, float ay, float az) {
    const float *y = x + n, *z = y + n;
    const __m128 vx = _mm_set1_ps(ax), vy = _mm_set1_ps(ay), vz = _mm_set1_ps(az);
    const auto four = [&](int i) {
      return _mm_add_ps(
          _mm_add_ps(_mm_mul_ps(_mm_load_ps(x + i), vx), _mm_mul_ps(_mm_load_ps(y + i), vy)),
          _mm_mul_ps(_mm_load_ps(z + i), vz));
    };
    __m128 best = _mm_max_ps(four(0), four(4));
    for (int i = 8; i < n; i += 8) best = _mm_max_ps(best, _mm_max_ps(four(i), four(i + 4)));
    return best;
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

bool axis_separates_sse2(const HullView& a, const HullView& b, const double* r, const double* t,
                         const float* axis, double gap) noexcept {
  return axis_proves<Sse2Tops>(a, b, r, t, axis, gap);
}

}  // namespace detail

bool axis_separates(const HullView& a, const HullView& b, const RelativePose& x,
                    const float axis[3], double gap) noexcept {
  const double *r = x.rotation.data(), *t = x.translation.data();
  return __builtin_cpu_supports("avx2") ? detail::axis_separates_avx2(a, b, r, t, axis, gap)
                                        : detail::axis_separates_sse2(a, b, r, t, axis, gap);
}

}  // namespace thigma
