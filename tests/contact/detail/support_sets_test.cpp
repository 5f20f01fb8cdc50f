#include "thigma/contact/detail/support_sets.h"

#include <bit>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

#include "thigma/math/infinity.h"

namespace thigma::detail {
namespace {

// Cubes have faces of four vertices, balls of three; both far from the origin of their bodies.
test::PointHull hull_of(int trial, Random& random) {
  const Vec3 center(100.0, -50.0, 20.0);
  if (trial % 2 == 0) return test::random_hull(0, 6 + trial % 20, center, 1.0, random);
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(center + Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return test::PointHull(std::move(corners));
}

TEST(SupportSets, GiveTheDistanceOfHullsInTheSameBitsFromAnyMemory) {
  Random random(11);
  int found = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const test::PointHull a = hull_of(trial, random), b = hull_of(trial / 2, random);
    const HullView va = a.view(), vb = b.view();
    RelativePose x{random.orientation().toRotationMatrix(), Vec3::Zero()};
    x.translation =
        va.center + random.uniform(2.0, 5.0) * random.direction() - x.rotation * vb.center;
    GjkCache fresh, memory;
    const Separation s = closest_points(va, vb, x, kInfinity, fresh);
    if (s.status != GjkStatus::separated || s.distance < 1e-3) continue;
    const Placement place(va, vb, x);
    SupportedDistance out, again;
    if (!closest_by_support(place,
                            support_sets(place, s.witness_a - va.center, s.witness_b - va.center),
                            Features::any, out))
      continue;
    ++found;
    EXPECT_NEAR(out.distance, s.distance, 1e-11) << trial;
    EXPECT_NEAR((out.p + va.center - s.witness_a).norm(), 0.0, 1e-8);
    // A search that comes from elsewhere.
    RelativePose before = x;
    before.translation += 0.1 * random.direction();
    before.rotation =
        before.rotation * Eigen::AngleAxisd(0.1, random.direction()).toRotationMatrix();
    closest_points(va, vb, before, kInfinity, memory);
    const Separation warm = closest_points(va, vb, x, kInfinity, memory);
    ASSERT_TRUE(closest_by_support(
        place, support_sets(place, warm.witness_a - va.center, warm.witness_b - va.center),
        Features::any, again));
    EXPECT_EQ(out.distance, again.distance);
    EXPECT_EQ(out.p, again.p);
    EXPECT_EQ(out.q, again.q);
    // Hulls without triangles have no real edge or face.
    SupportSets sets = support_sets(place, out.p, out.q);
    if (std::popcount(sets.a) + std::popcount(sets.b) > 2) {
      EXPECT_FALSE(closest_by_support(place, sets, Features::real, again));
    }
    sets.a ^= 1u << 3;
    EXPECT_FALSE(closest_by_support(place, sets, Features::any, again)) << "not the support set";
  }
  EXPECT_GT(found, 250);
}

}  // namespace
}  // namespace thigma::detail
