#include <limits>

#include "convex/pair_batch_support.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::batch_scene;
using test::BatchScene;
using test::expect_same_bits;

// Coherent motion of pairs of every kind, any batch length: the batch gives the bits of the single
// function, the caches stay equal too.
TEST(ClosestPointsBatch, GivesTheBitsOfTheSingleFunction) {
  Random random(1);
  for (const double stop : {std::numeric_limits<double>::infinity(), 0.3, 0.0}) {
    for (const std::size_t count : {0u, 1u, 3u, 4u, 7u, 8u, 61u, 64u, 65u, 130u}) {
      const BatchScene scene = batch_scene(count, 1.0, random);
      std::vector<GjkCache> single(count), batch(count);
      const std::vector<GjkQuery> queries = scene.queries(batch);
      std::vector<Separation> out(count);
      RelativePose x;
      const Vec3 step = random.direction() * 0.01;
      for (int frame = 0; frame < 12; ++frame, x.translation += step) {
        closest_points_batch(queries, x, stop, out.data());
        for (std::size_t i = 0; i < count; ++i) {
          expect_same_bits(out[i],
                           closest_points(scene.view_a[i], scene.view_b[i], x, stop, single[i]), i);
          EXPECT_EQ(std::memcmp(&single[i], &batch[i], sizeof(GjkCache)), 0);
        }
      }
    }
  }
}

// A cache may come from other hulls: any indices, existing or not, give the right distance.
TEST(ClosestPointsBatch, SurvivesAnyCache) {
  Random random(3);
  constexpr std::size_t kCount = 200;
  const BatchScene scene = batch_scene(kCount, 1.0, random);
  std::vector<GjkCache> garbage(kCount), single(kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    GjkCache& c = garbage[i];
    for (int k = 0; k < 4; ++k) {
      c.a[k] = static_cast<std::uint8_t>(random.below(i % 2 == 0 ? 256 : 32));
      c.b[k] = static_cast<std::uint8_t>(random.below(i % 2 == 0 ? 256 : 32));
    }
    c.count = static_cast<std::uint8_t>(random.below(5));
    c.provable = c.count == 1 ? 1 : 0;
  }
  single = garbage;
  std::vector<Separation> out(kCount);
  constexpr double kFar = std::numeric_limits<double>::infinity();
  closest_points_batch(scene.queries(garbage), RelativePose{}, kFar, out.data());
  for (std::size_t i = 0; i < kCount; ++i) {
    const HullView &a = scene.view_a[i], &b = scene.view_b[i];
    expect_same_bits(out[i], closest_points(a, b, RelativePose{}, kFar, single[i]), i);
    GjkCache fresh;
    const Separation cold = closest_points(a, b, RelativePose{}, kFar, fresh);
    EXPECT_EQ(out[i].status, cold.status) << i;
    EXPECT_NEAR(out[i].distance, cold.distance, 1e-11 * (a.radius + b.radius)) << i;
  }
}

}  // namespace
}  // namespace thigma
