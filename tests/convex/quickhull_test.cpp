#include "thigma/convex/quickhull.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/convex/gjk.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

/// Distance by GJK, which knows nothing of faces.
double gjk_distance(const std::vector<Vec3>& hull, const Vec3& p) {
  struct Lanes {
    alignas(32) float x[96];
  };
  const auto view = [](const std::vector<Vec3>& v, Lanes& lanes) {
    HullView h;
    h.vertices = v.data();
    h.vertex_count = static_cast<int>(v.size());
    h.center = v[0];
    h.lane_count = (h.vertex_count + 7) / 8 * 8;
    h.lanes = lanes.x;
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < h.lane_count; ++i)
        lanes.x[axis * h.lane_count + i] = static_cast<float>(
            v[static_cast<std::size_t>(std::min(i, h.vertex_count - 1))][axis] - v[0][axis]);
    return h;
  };
  const std::vector<Vec3> point(1, p);
  Lanes a, b;
  GjkCache cache;
  return closest_points(view(hull, a), view(point, b), RelativePose{},
                        std::numeric_limits<double>::infinity(), cache)
      .distance;
}

TEST(GrowHull, OutsideDistanceCoversEveryPointAndIsReached) {
  Random random(3);
  Quickhull hull;
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> points;
    const double thickness = std::array{1.0, 0.1, 1e-3, 0.0}[random.below(4)];
    for (int i = 0; i < 150; ++i) {
      Vec3 p = random.direction();
      p.z() *= thickness;
      points.push_back(p);
    }
    const int limit = 4 + static_cast<int>(random.below(13));
    start_hull(hull, points, 1e-8);
    grow_hull(hull, limit);
    EXPECT_LE(static_cast<int>(hull.vertices.size()), limit);
    std::vector<Vec3> chosen;
    for (const std::int32_t i : hull.vertices)
      chosen.push_back(points[static_cast<std::size_t>(i)]);
    const double h = outside_distance(hull);
    double worst = 0.0;
    for (const Vec3& p : points) worst = std::max(worst, gjk_distance(chosen, p));
    EXPECT_NEAR(h, worst, 2e-6);
  }
}

TEST(GrowHull, PointsNotListedAreInsideTheHull) {
  Random random(4);
  Quickhull hull;
  std::vector<std::int32_t> outside;
  for (int round = 0; round < 100; ++round) {
    std::vector<Vec3> points;
    for (int i = 0; i < 100; ++i) points.push_back(random.in_cube(1.0));
    start_hull(hull, points, 1e-8);
    grow_hull(hull, 12);
    list_outside(hull, outside);
    std::vector<Vec3> chosen;
    for (const std::int32_t i : hull.vertices)
      chosen.push_back(points[static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!std::binary_search(outside.begin(), outside.end(), static_cast<std::int32_t>(i))) {
        EXPECT_LE(gjk_distance(chosen, points[i]), 1e-6);
      }
  }
}

TEST(PointTriangleDistance, KnowsFaceEdgeCornerAndSliver) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_DOUBLE_EQ(point_triangle_distance({0.25, 0.25, 2}, a, b, c), 2.0);
  EXPECT_DOUBLE_EQ(point_triangle_distance({0.5, -3, 4}, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(point_triangle_distance({4, 0, 4}, a, b, c), 5.0);
  EXPECT_DOUBLE_EQ(point_triangle_distance({0.5, 3, 4}, a, b, {2, 0, 0}), 5.0);
}

}  // namespace
}  // namespace thigma
