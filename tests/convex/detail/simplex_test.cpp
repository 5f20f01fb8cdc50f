#include "thigma/convex/detail/simplex.h"

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma::detail {
namespace {

// The answer must be a convex combination of the kept points, and no point of the simplex may be
// nearer: for a convex set that is  w . v >= v . v  for every corner w.
void expect_nearest(const Vec3* corners, int n, Simplex s, const Vec3& v, double size) {
  Vec3 sum = Vec3::Zero();
  double total = 0.0;
  for (int i = 0; i < s.n; ++i) {
    EXPECT_GE(s.weight[i], -1e-14);
    sum += s.weight[i] * s.w[i];
    total += s.weight[i];
  }
  EXPECT_NEAR(total, 1.0, 1e-14);
  if (s.n < 4) {
    EXPECT_NEAR((sum - v).norm(), 0.0, 1e-9 * size);
  }
  for (int i = 0; i < n; ++i) EXPECT_GE(corners[i].dot(v), v.squaredNorm() - 1e-12 * size * size);
}

TEST(ReduceToNearest, SatisfiesTheVariationalInequality) {
  Random random(1);
  int inside = 0;
  for (const double scale : {1e-9, 1.0, 1e9}) {
    for (int trial = 0; trial < 20000; ++trial) {
      const int n = 1 + trial % 4, kind = trial / 4 % 4;
      const Vec3 shift = random.in_cube(1.0);
      Vec3 corners[4];
      Simplex s;
      for (int i = 0; i < n; ++i) {
        Vec3 p = random.in_cube(1.0);
        if (kind == 1) p.z() = 0.0;                              // flat
        if (kind == 2) p = Vec3(p.x(), 2.0 * p.x(), p.x());      // on a line
        if (kind == 3 && i > 0) p = corners[0] / scale - shift;  // equal points
        corners[i] = s.w[i] = scale * (p + shift);
        s.a[i] = s.b[i] = static_cast<std::uint8_t>(i);
      }
      s.n = n;
      const Vec3 v = reduce_to_nearest(s);
      inside += s.n == 4;
      SCOPED_TRACE(kind);
      expect_nearest(corners, n, s, v, 4.0 * scale);
    }
  }
  EXPECT_GT(inside, 20);
}

}  // namespace
}  // namespace thigma::detail
