#include <limits>

#include "convex/pair_batch_support.h"
#include <gtest/gtest.h>

#include "thigma/convex/detail/gjk_batch.h"

namespace thigma {
namespace {

// Both widths on the same pairs and the same motion, whatever the processor's own choice is.
TEST(ClosestPointsBatch, GivesTheSameBitsInBothWidths) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  Random random(2);
  for (const double scale : {1.0, 1e-9, 1e9}) {
    for (const double stop : {std::numeric_limits<double>::infinity(), 0.3 * scale}) {
      for (const std::size_t count : {1u, 2u, 5u, 64u, 65u, 150u}) {
        const test::BatchScene scene = test::batch_scene(count, scale, random);
        std::vector<GjkCache> narrow(count), wide(count);
        const std::vector<GjkQuery> narrow_queries = scene.queries(narrow);
        const std::vector<GjkQuery> wide_queries = scene.queries(wide);
        std::vector<Separation> narrow_out(count), wide_out(count);
        RelativePose x = test::near_pose(scale, random);
        const Vec3 step = random.direction() * 0.01 * scale;
        for (int frame = 0; frame < 8; ++frame, x.translation += step) {
          const detail::PlainPose plain{x.rotation.data(), x.translation.data(),
                                        x.translation.lpNorm<1>()};
          detail::closest_points_batch_sse2(narrow_queries.data(), count, x, plain, stop,
                                            narrow_out.data());
          detail::closest_points_batch_avx2(wide_queries.data(), count, x, plain, stop,
                                            wide_out.data());
          for (std::size_t i = 0; i < count; ++i) {
            test::expect_same_bits(narrow_out[i], wide_out[i], i);
            EXPECT_EQ(std::memcmp(&narrow[i], &wide[i], sizeof(GjkCache)), 0);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace thigma
