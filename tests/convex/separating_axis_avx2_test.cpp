#include <limits>

#include "convex/pair_batch_support.h"
#include <gtest/gtest.h>

#include "thigma/convex/detail/axis_proof.h"

namespace thigma {
namespace {

// Gaps around what the axis can prove, where one bit of difference shows.
TEST(AxisSeparates, GivesTheSameAnswerInBothWidths) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  Random random(4);
  int proven = 0, refused = 0;
  for (const double scale : {1.0, 1e-9, 1e9}) {
    const test::BatchScene scene = test::batch_scene(300, scale, random);
    for (std::size_t i = 0; i < 300; ++i) {
      const HullView &a = scene.view_a[i], &b = scene.view_b[i];
      if (a.lanes == nullptr) continue;
      const RelativePose x = test::near_pose(scale, random);
      const double *r = x.rotation.data(), *t = x.translation.data();
      const Vec3 d = (x.rotation * b.center + x.translation - a.center).normalized();
      const float axis[3] = {static_cast<float>(d.x()), static_cast<float>(d.y()),
                             static_cast<float>(d.z())};
      // The largest gap the narrow width proves, to the last bit; there the wide one must turn too.
      double low = 0.0, high = 100.0 * scale;
      if (!detail::axis_separates_sse2(a, b, r, t, axis, low)) {
        EXPECT_FALSE(detail::axis_separates_avx2(a, b, r, t, axis, low));
        ++refused;
        continue;
      }
      for (double middle = 0.5 * (low + high); middle > low && middle < high;
           middle = 0.5 * (low + high))
        (detail::axis_separates_sse2(a, b, r, t, axis, middle) ? low : high) = middle;
      EXPECT_TRUE(detail::axis_separates_avx2(a, b, r, t, axis, low)) << i;
      EXPECT_FALSE(detail::axis_separates_avx2(a, b, r, t, axis, high)) << i;
      ++proven;
    }
  }
  EXPECT_GT(proven, 100);
  EXPECT_GT(refused, 10);
}

}  // namespace
}  // namespace thigma
