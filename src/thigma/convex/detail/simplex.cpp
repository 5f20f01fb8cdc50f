// Nearest point of a simplex to the origin by Voronoi regions (Ericson 2005, 5.1). In the interior
// of a triangle the point is taken along the normal, so its direction is exact even where its
// length is all cancellation.
#include "thigma/convex/detail/simplex.h"

#include <limits>

namespace thigma::detail {
namespace {

// Sine of the slope below which a tetrahedron counts as flat: far above rounding, far below any
// real patch.
constexpr double kFlat = 1e-11;

void keep(Simplex& s, int mask) noexcept {
  int k = 0;
  for (int i = 0; i < s.n; ++i) {
    if ((mask >> i & 1) == 0) continue;
    if (k != i) {
      s.w[k] = s.w[i];
      s.a[k] = s.a[i];
      s.b[k] = s.b[i];
      s.weight[k] = s.weight[i];
    }
    ++k;
  }
  s.n = k;
}

Vec3 reduce_tetrahedron(Simplex& s) noexcept {
  static constexpr int kFace[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 1, 3, 2}, {1, 2, 3, 0}};
  double least = std::numeric_limits<double>::infinity();
  Vec3 best = Vec3::Zero();
  int kept = 15;
  double weight[4] = {0.25, 0.25, 0.25, 0.25};
  for (const auto& f : kFace) {
    const Vec3 &a = s.w[f[0]], &b = s.w[f[1]], &c = s.w[f[2]], &d = s.w[f[3]];
    const Vec3 n = (b - a).cross(c - a);
    // The origin is beyond this face when it lies on the other side than the fourth point. A flat
    // tetrahedron has no other side (its sign is rounding): every face may hold the nearest point.
    const Vec3 ad = d - a;
    const double height = ad.dot(n);
    const bool is_flat = height * height <= kFlat * kFlat * n.squaredNorm() * ad.squaredNorm();
    if (!is_flat && a.dot(n) * height < 0.0) continue;
    int mask = 0;
    double w[3];
    const Vec3 q = nearest_on_triangle(a, b, c, mask, w);
    const double qq = q.squaredNorm();
    if (!(qq < least)) continue;
    least = qq;
    best = q;
    kept = 0;
    weight[0] = weight[1] = weight[2] = weight[3] = 0.0;
    for (int i = 0; i < 3; ++i) {
      if (mask >> i & 1) kept |= 1 << f[i];
      weight[f[i]] = w[i];
    }
  }
  for (int i = 0; i < 4; ++i) s.weight[i] = weight[i];
  keep(s, kept);
  return best;
}

}  // namespace

Vec3 nearest_on_edges(const Vec3& a, const Vec3& b, const Vec3& c, int& mask,
                      double weight[3]) noexcept {
  const Vec3* p[3] = {&a, &b, &c};
  Vec3 best = a;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    int m = 0;
    double w[2];
    const Vec3 q = nearest_on_segment(*p[i], *p[j], m, w);
    if (q.squaredNorm() < least) {
      least = q.squaredNorm();
      best = q;
      weight[0] = weight[1] = weight[2] = 0.0;
      weight[i] = w[0];
      weight[j] = w[1];
      mask = ((m & 1) << i) | ((m >> 1) << j);
    }
  }
  return best;
}

Vec3 reduce_to_nearest(Simplex& s) noexcept {
  int mask = 1;
  Vec3 v = s.w[0];
  if (s.n == 1) {
    s.weight[0] = 1.0;
    return v;
  }
  if (s.n == 4) return reduce_tetrahedron(s);
  v = s.n == 2 ? nearest_on_segment(s.w[0], s.w[1], mask, s.weight)
               : nearest_on_triangle(s.w[0], s.w[1], s.w[2], mask, s.weight);
  if (mask != (1 << s.n) - 1) keep(s, mask);
  return v;
}

}  // namespace thigma::detail
