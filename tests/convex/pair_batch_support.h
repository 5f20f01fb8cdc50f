#pragma once
// Pairs for the batch tests.

#include <cstring>
#include <vector>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

namespace thigma::test {

inline void expect_same_bits(const Separation& a, const Separation& b, std::size_t i) {
  EXPECT_EQ(a.status, b.status) << "pair " << i;
  EXPECT_EQ(std::memcmp(&a.distance, &b.distance, sizeof(double)), 0)
      << "pair " << i << ' ' << a.distance - b.distance;
  EXPECT_EQ(std::memcmp(a.witness_a.data(), b.witness_a.data(), sizeof(Vec3)), 0) << "pair " << i;
  EXPECT_EQ(std::memcmp(a.witness_b.data(), b.witness_b.data(), sizeof(Vec3)), 0) << "pair " << i;
  EXPECT_EQ(a.feature_a, b.feature_a) << "pair " << i;
  EXPECT_EQ(a.feature_b, b.feature_b) << "pair " << i;
  EXPECT_EQ(a.iterations, b.iterations) << "pair " << i;
}

/// A pose that leaves the pairs of a scene near each other.
inline RelativePose near_pose(double scale, Random& random) {
  const Vec3 turn = random.in_cube(0.01);
  return {Quat(1.0, turn.x(), turn.y(), turn.z()).normalized().toRotationMatrix(),
          random.in_cube(0.05 * scale)};
}

/// Pairs of hulls of every kind and size, apart and overlapping. Views point into a and b.
struct BatchScene {
  std::vector<PointHull> a, b;
  std::vector<HullView> view_a, view_b;

  std::vector<GjkQuery> queries(std::vector<GjkCache>& caches) const {
    std::vector<GjkQuery> q(caches.size());
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = {&view_a[i], &view_b[i], &caches[i]};
    return q;
  }
};

inline BatchScene batch_scene(std::size_t count, double scale, Random& random) {
  BatchScene s;
  const auto hull = [&](const Vec3& place) {
    const int kind = static_cast<int>(random.below(5));
    return random_hull(kind, 1 + static_cast<int>(random.below(32)), place, scale, random);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 place = random.direction() * 10.0;
    s.a.push_back(hull(place));
    s.b.push_back(hull(place + random.direction() * random.uniform(0.5, 3.0)));
  }
  for (std::size_t i = 0; i < count; ++i) {
    s.view_a.push_back(s.a[i].view());
    s.view_b.push_back(s.b[i].view());
  }
  if (count > 4) s.view_a[3].lanes = nullptr;  // allowed: no proof in single precision then
  return s;
}

}  // namespace thigma::test
