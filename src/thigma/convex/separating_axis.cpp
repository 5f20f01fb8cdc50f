// The cached separating axis: one dot product a vertex in single precision, in SSE2, which every
// x86-64 has. Wider registers were not worth a second path: most patches have at most eight
// vertices, two registers each way.
#include <cmath>

#include <emmintrin.h>

#include "thigma/convex/pair.h"

namespace thigma {
namespace {

// A height is three products of rounded coordinates with a rounded axis, and two sums: at most 7
// roundings of 2^-24 of the sum of absolute products, which is at most sqrt(3) |axis| radius. 2^-19
// is more than twice that.
constexpr double kSlack = 0x1.0p-19;

inline __m128 height4(const float* x, const float* y, const float* z, const __m128 axis[3]) {
  return _mm_add_ps(
      _mm_add_ps(_mm_mul_ps(_mm_load_ps(x), axis[0]), _mm_mul_ps(_mm_load_ps(y), axis[1])),
      _mm_mul_ps(_mm_load_ps(z), axis[2]));
}

// Largest axis . p over the lanes.
inline float top(const HullView& h, float ax, float ay, float az) {
  const __m128 axis[3] = {_mm_set1_ps(ax), _mm_set1_ps(ay), _mm_set1_ps(az)};
  const float *x = h.lanes, *y = x + h.lane_count, *z = y + h.lane_count;
  __m128 best = _mm_max_ps(height4(x, y, z, axis), height4(x + 4, y + 4, z + 4, axis));
  for (int i = 8; i < h.lane_count; i += 8) {
    best = _mm_max_ps(best, height4(x + i, y + i, z + i, axis));
    best = _mm_max_ps(best, height4(x + i + 4, y + i + 4, z + i + 4, axis));
  }
  best = _mm_max_ps(best, _mm_movehl_ps(best, best));
  best = _mm_max_ss(best, _mm_shuffle_ps(best, best, 1));
  return _mm_cvtss_f32(best);
}

}  // namespace

bool axis_separates(const HullView& a, const HullView& b, const RelativePose& x,
                    const float axis[3], double gap) noexcept {
  const Vec3 n(axis[0], axis[1], axis[2]);
  const Vec3 n_b = x.rotation.transpose() * n;
  const double top_a = top(a, axis[0], axis[1], axis[2]);
  const double top_b = top(b, -static_cast<float>(n_b.x()), -static_cast<float>(n_b.y()),
                           -static_cast<float>(n_b.z()));
  const Vec3 offset = x.rotation * b.center + x.translation - a.center;
  const double nn = n.squaredNorm();
  const double between = n.dot(offset) - top_a - top_b;  // |n| times the gap along the axis
  const double far = a.center.lpNorm<1>() + b.center.lpNorm<1>() + x.translation.lpNorm<1>();
  const double need = gap + kSlack * (a.radius + b.radius) + 0x1.0p-48 * far;
  return between > 0.0 && between * between > need * need * nn * (1.0 + 0x1.0p-48);
}

}  // namespace thigma
