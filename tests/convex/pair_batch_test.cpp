#include <cstring>
#include <limits>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::PointHull;
using test::random_hull;

void expect_same(const Separation& a, const Separation& b, const char* what, std::size_t i) {
  EXPECT_EQ(a.status, b.status) << what << i;
  EXPECT_EQ(std::memcmp(&a.distance, &b.distance, sizeof(double)), 0)
      << what << i << ' ' << a.distance - b.distance;
  EXPECT_EQ(std::memcmp(a.witness_a.data(), b.witness_a.data(), sizeof(Vec3)), 0) << what << i;
  EXPECT_EQ(std::memcmp(a.witness_b.data(), b.witness_b.data(), sizeof(Vec3)), 0) << what << i;
  EXPECT_EQ(a.feature_a, b.feature_a) << what << i;
  EXPECT_EQ(a.feature_b, b.feature_b) << what << i;
  EXPECT_EQ(a.iterations, b.iterations) << what << i;
}

// Coherent motion of pairs of every kind, any batch length: the batch gives the bits of the single
// function, the caches stay equal too.
TEST(ClosestPointsBatch, GivesTheBitsOfTheSingleFunction) {
  Random random(1);
  for (const double stop : {std::numeric_limits<double>::infinity(), 0.3, 0.0}) {
    for (const std::size_t count : {1u, 3u, 4u, 7u, 8u, 61u}) {
      std::vector<PointHull> a, b;
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 place = random.direction() * 10.0;
        const int kind = static_cast<int>(random.below(5));
        a.push_back(random_hull(kind, 1 + static_cast<int>(random.below(32)), place, 1.0, random));
        b.push_back(
            random_hull(static_cast<int>(random.below(5)), 1 + static_cast<int>(random.below(32)),
                        place + random.direction() * random.uniform(0.5, 3.0), 1.0, random));
      }
      std::vector<HullView> va, vb;
      for (std::size_t i = 0; i < count; ++i) va.push_back(a[i].view()), vb.push_back(b[i].view());
      std::vector<GjkCache> single(count), batch(count);
      std::vector<PairQuery> queries(count);
      for (std::size_t i = 0; i < count; ++i) queries[i] = {&va[i], &vb[i], &batch[i]};
      std::vector<Separation> out(count);
      RelativePose x;
      const Vec3 step = random.direction() * 0.01;
      for (int frame = 0; frame < 12; ++frame, x.translation += step) {
        closest_points_batch(queries, x, stop, out.data());
        for (std::size_t i = 0; i < count; ++i) {
          expect_same(out[i], closest_points(va[i], vb[i], x, stop, single[i]), "pair ", i);
          EXPECT_EQ(std::memcmp(&single[i], &batch[i], sizeof(GjkCache)), 0);
        }
      }
    }
  }
}

}  // namespace
}  // namespace thigma
