#pragma once
// The vertex of a hull farthest along a direction. Double precision, no branch on the data.

#include <emmintrin.h>

#include "thigma/convex/hull_view.h"

namespace thigma {

/// Index of a vertex with the largest direction . p; among equal ones the result depends on their
/// order alone. Two vertices a step in SSE2, which every x86-64 has: the compare-and-branch of
/// scalar code mispredicts.
inline int support_vertex(const HullView& hull, const Vec3& direction) noexcept {
  const int n = hull.vertex_count;
  const double* p = hull.vertices->data();
  if (n < 2) return 0;
  const __m128d dx = _mm_set1_pd(direction.x()), dy = _mm_set1_pd(direction.y()),
                dz = _mm_set1_pd(direction.z());
  const auto heights = [&](const double* q) {  // of the two vertices from q on
    const __m128d xy = _mm_loadu_pd(q), zx = _mm_loadu_pd(q + 2), yz = _mm_loadu_pd(q + 4);
    const __m128d px = _mm_shuffle_pd(xy, zx, 2), py = _mm_shuffle_pd(xy, yz, 1),
                  pz = _mm_shuffle_pd(zx, yz, 2);
    return _mm_add_pd(_mm_add_pd(_mm_mul_pd(px, dx), _mm_mul_pd(py, dy)), _mm_mul_pd(pz, dz));
  };
  __m128d best = heights(p);
  __m128i step = _mm_setzero_si128();  // which pair of vertices each half of best comes from
  for (int i = 2; i < n; i += 2) {
    const int j = i + 2 <= n ? i : n - 2;  // an odd rest takes the last two, one of them again
    const __m128d h = heights(p + 3 * j);
    const __m128i larger = _mm_castpd_si128(_mm_cmpgt_pd(h, best));
    best = _mm_max_pd(best, h);
    step = _mm_or_si128(_mm_and_si128(larger, _mm_set1_epi64x(j)), _mm_andnot_si128(larger, step));
  }
  const __m128d swapped = _mm_unpackhi_pd(best, best);
  const int high = _mm_comigt_sd(swapped, best);
  return high ? _mm_cvtsi128_si32(_mm_unpackhi_epi64(step, step)) + 1 : _mm_cvtsi128_si32(step);
}

}  // namespace thigma
