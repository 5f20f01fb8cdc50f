#include "thigma/convex/gjk.h"

#include <bit>
#include <cmath>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

#include "thigma/convex/triangle_distance.h"
#include "thigma/math/infinity.h"

namespace thigma {
namespace {

using test::PointHull;
using test::random_hull;
using test::random_pose;

// Distance of two hulls as the least over all triangles (with repeated corners: segments and
// points) that their vertices span, or 0 when one contains the other: every face of the hull is
// among them.
double brute_distance(const HullView& a, const HullView& b, const RelativePose& x) {
  std::vector<Vec3> pb;
  for (int i = 0; i < b.vertex_count; ++i) pb.push_back(x.rotation * b.vertices[i] + x.translation);
  double least = kInfinity;
  const auto each = [](int n, auto f) {
    for (int i = 0; i < n; ++i)
      for (int j = std::min(i + 1, n - 1); j < n; ++j)
        for (int k = std::min(j + 1, n - 1); k < n; ++k) f(i, j, k);
  };
  each(a.vertex_count, [&](int i, int j, int k) {
    const Vec3 ta[3] = {a.vertices[i], a.vertices[j], a.vertices[k]};
    each(b.vertex_count, [&](int l, int m, int n) {
      const Vec3 tb[3] = {pb[static_cast<std::size_t>(l)], pb[static_cast<std::size_t>(m)],
                          pb[static_cast<std::size_t>(n)]};
      least = std::min(least, triangle_distance(ta, tb).distance);
    });
  });
  return least;
}

double scale_of(const HullView& a, const HullView& b) { return a.radius + b.radius; }

// What every answer must satisfy by itself: witnesses on the hulls' features, and a plane that
// proves the distance.
void expect_consistent(const Separation& s, const HullView& a, const HullView& b,
                       const RelativePose& x, double tolerance) {
  const Vec3 d = s.witness_b - s.witness_a;
  EXPECT_NEAR(d.norm(), s.distance, tolerance);
  const Vec3 n = d.normalized();
  double top = -kInfinity, bottom = kInfinity;
  for (int i = 0; i < a.vertex_count; ++i) top = std::max(top, n.dot(a.vertices[i] - s.witness_a));
  for (int i = 0; i < b.vertex_count; ++i)
    bottom = std::min(bottom, n.dot(x.rotation * b.vertices[i] + x.translation - s.witness_a));
  EXPECT_GE(bottom - top, s.distance - tolerance);
  EXPECT_LE(std::popcount(s.feature_a), 3);
  EXPECT_LE(std::popcount(s.feature_b), 3);
}

TEST(ClosestPoints, EqualsBruteForceOnHullsOfEveryKindAtEveryScale) {
  Random random(1);
  int separated = 0;
  for (const double scale : {1e-9, 1.0, 1e9}) {
    for (int trial = 0; trial < 150; ++trial) {
      const int kind_a = trial % 5, kind_b = trial / 5 % 5;
      const int na = 1 + static_cast<int>(random.below(5)),
                nb = 1 + static_cast<int>(random.below(5));
      const PointHull ha = random_hull(kind_a, na, Vec3::Zero(), scale, random);
      const PointHull hb =
          random_hull(kind_b, nb, Vec3(random.uniform(0.0, 2.5), 0, 0), scale, random);
      const RelativePose x = random_pose(0.3 * scale, random);
      const HullView a = ha.view(), b = hb.view();
      GjkCache cache;
      const Separation s = closest_points(a, b, x, kInfinity, cache);
      const double tolerance = 1e-12 * std::max(scale_of(a, b), s.distance) * 4.0 + 1e-15 * scale;
      const double expected = brute_distance(a, b, x);
      ASSERT_NE(s.status, GjkStatus::gave_up);
      if (s.status == GjkStatus::overlapping) {
        // Containment has no close features: then only the status speaks.
        EXPECT_EQ(s.distance, 0.0);
        if (na < 4 && nb < 4) {
          EXPECT_NEAR(expected, 0.0, tolerance);
        }
        continue;
      }
      ++separated;
      EXPECT_NEAR(s.distance, expected, tolerance) << "scale " << scale << " trial " << trial;
      expect_consistent(s, a, b, x, tolerance);
    }
  }
  EXPECT_GT(separated, 200);
}

TEST(ClosestPoints, LargeHullsProveTheirDistance) {
  Random random(2);
  for (int trial = 0; trial < 3000; ++trial) {
    const int kind_a = trial % 5, kind_b = trial / 5 % 5;
    const PointHull ha =
        random_hull(kind_a, 4 + static_cast<int>(random.below(29)), Vec3::Zero(), 1.0, random);
    const PointHull hb = random_hull(kind_b, 4 + static_cast<int>(random.below(29)),
                                     random.direction() * random.uniform(1.0, 4.0), 1.0, random);
    const RelativePose x = random_pose(0.2, random);
    GjkCache cache;
    const Separation s = closest_points(ha.view(), hb.view(), x, kInfinity, cache);
    ASSERT_NE(s.status, GjkStatus::gave_up) << trial;
    ASSERT_LT(s.iterations, 40);
    if (s.status == GjkStatus::separated && s.distance > 1e-6)
      expect_consistent(s, ha.view(), hb.view(), x, 2e-12);
  }
}

TEST(ClosestPoints, WarmEqualsColdAndForeignCachesDoNoHarm) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const PointHull ha = random_hull(trial % 5, 12, Vec3::Zero(), 1.0, random);
    const PointHull hb = random_hull(trial / 5 % 5, 9, Vec3(1.5, 0, 0), 1.0, random);
    RelativePose x = random_pose(0.2, random);
    GjkCache warm;
    warm.count = 4;
    for (int i = 0; i < 4; ++i)
      warm.a[i] = static_cast<std::uint8_t>(random.below(256)),
      warm.b[i] = static_cast<std::uint8_t>(random.below(12));
    const Vec3 step = random.direction() * 0.02;
    for (int frame = 0; frame < 20; ++frame, x.translation += step) {
      GjkCache cold;
      const Separation w = closest_points(ha.view(), hb.view(), x, kInfinity, warm);
      const Separation c = closest_points(ha.view(), hb.view(), x, kInfinity, cold);
      ASSERT_EQ(w.status == GjkStatus::overlapping, c.status == GjkStatus::overlapping);
      ASSERT_NEAR(w.distance, c.distance, 4e-12);
    }
  }
}

TEST(ClosestPoints, EarlyStopIsAValidBoundAtEveryStop) {
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const PointHull ha = random_hull(trial % 5, 10, Vec3::Zero(), 1.0, random);
    const PointHull hb = random_hull(0, 10, Vec3(2.5, 0, 0), 1.0, random);
    const RelativePose x = random_pose(0.3, random);
    GjkCache exact_cache;
    const double exact = closest_points(ha.view(), hb.view(), x, kInfinity, exact_cache).distance;
    for (const double part : {0.0, 0.1, 0.5, 0.9, 0.999, 1.0, 1.001, 2.0}) {
      GjkCache cache;
      const double stop = part * exact;
      const Separation s = closest_points(ha.view(), hb.view(), x, stop, cache);
      EXPECT_LE(s.distance, exact * (1.0 + 1e-11));
      EXPECT_GE(s.distance, std::min(stop, exact) * (1.0 - 1e-11));
    }
  }
}

TEST(ClosestPoints, KeepsDigitsWhenTheGapIsMillionthsOfTheHulls) {
  // A corner over a face and two crossed edges, gap 1e-9 of the size, away from the axes.
  Random random(5);
  const PointHull slab({{-1, -1, 0}, {1, -1, 0}, {0, 1.5, 0}, {0, 0, -1}});
  const PointHull spike({{0.1, 0.05, 0}, {0.5, 0.3, 1}, {-0.4, 0.2, 1}, {0.1, -0.6, 1}});
  for (int trial = 0; trial < 50; ++trial) {
    RelativePose x;
    x.translation = Vec3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 1e-9);
    GjkCache cache;
    const Separation s = closest_points(slab.view(), spike.view(), x, kInfinity, cache);
    EXPECT_EQ(s.status, GjkStatus::separated);
    EXPECT_NEAR(s.distance, 1e-9, 2e-12);
  }
}

TEST(RelativePose, PlacesBInTheFrameOfA) {
  Random random(6);
  const Pose a{random.in_cube(2.0), random.orientation()},
      b{random.in_cube(2.0), random.orientation()};
  const RelativePose x = relative_pose(a, b);
  const Vec3 p = random.in_cube(1.0);
  EXPECT_NEAR((transform_point(a, x.rotation * p + x.translation) - transform_point(b, p)).norm(),
              0.0, 1e-14);
}

}  // namespace
}  // namespace thigma
