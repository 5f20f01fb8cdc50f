#include "thigma/convex/hull.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#ifdef THIGMA_TEST_QHULL
extern "C" {
#include <libqhull_r/qhull_ra.h>
}
#endif

#include "thigma/core/error.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

double extent_of(const std::vector<Vec3>& points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// Highest point over any face whose plane is well defined, in units of the extent.
double worst_height(const ConvexHull& hull, const std::vector<Vec3>& points) {
  const double extent = extent_of(points);
  double worst = 0.0;
  for (const auto& t : hull.triangles) {
    const Vec3 a = hull.vertices[static_cast<std::size_t>(t[0])];
    const Vec3 ab = hull.vertices[static_cast<std::size_t>(t[1])] - a;
    const Vec3 ac = hull.vertices[static_cast<std::size_t>(t[2])] - a;
    const Vec3 cross = ab.cross(ac);
    if (cross.norm() < 1e-6 * extent * extent) continue;
    const Vec3 normal = cross.normalized();
    for (const Vec3& p : points) worst = std::max(worst, normal.dot(p - a) / extent);
  }
  return worst;
}

double volume_of(const ConvexHull& hull) {
  double sum = 0.0;
  for (const auto& t : hull.triangles) {
    const Vec3 o = hull.vertices[0];
    sum += (hull.vertices[static_cast<std::size_t>(t[0])] - o)
               .dot((hull.vertices[static_cast<std::size_t>(t[1])] - o)
                        .cross(hull.vertices[static_cast<std::size_t>(t[2])] - o));
  }
  return sum / 6.0;
}

bool is_closed(const ConvexHull& hull) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : hull.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  return std::all_of(sides.begin(), sides.end(), [&](const auto& side) {
    const auto other = sides.find({side.first.second, side.first.first});
    return other != sides.end() && side.second == other->second &&
           (hull.dimension == 2 || side.second == 1);
  });
}

std::vector<Vec3> cube(double half) {
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  return points;
}

#ifdef THIGMA_TEST_QHULL
struct QhullResult {
  std::vector<int> vertices;
  double volume = 0.0;
};

QhullResult qhull(const std::vector<Vec3>& points) {
  std::vector<double> flat;
  for (const Vec3& p : points) flat.insert(flat.end(), {p.x(), p.y(), p.z()});
  qhT state;
  qhT* qh = &state;
  qh_zero(qh, stderr);
  char options[] = "qhull Qt FA";
  QhullResult result;
  const int code = qh_new_qhull(qh, 3, static_cast<int>(points.size()), flat.data(), False, options,
                                nullptr, stderr);
  EXPECT_EQ(code, 0);
  if (code == 0) {
    qh_getarea(qh, qh->facet_list);
    result.volume = qh->totvol;
    vertexT* vertex = nullptr;
    FORALLvertices result.vertices.push_back(qh_pointid(qh, vertex->point));
  }
  qh_freeqhull(qh, !qh_ALL);
  int long_blocks = 0, long_bytes = 0;
  qh_memfreeshort(qh, &long_blocks, &long_bytes);
  std::sort(result.vertices.begin(), result.vertices.end());
  return result;
}

TEST(BuildHull, AgreesWithQhullOnRandomSets) {
  Random random(7);
  for (int round = 0; round < 400; ++round) {
    const auto count = static_cast<int>(5 + random.below(round < 380 ? 40 : 2000));
    std::vector<Vec3> points;
    for (int i = 0; i < count; ++i)
      points.push_back(round % 3 == 0 ? random.in_cube(1.0)
                       : round % 3 == 1
                           ? random.direction()
                           : Vec3(random.normal(), random.normal(), 0.01 * random.normal()));
    const ConvexHull hull = build_hull(points);
    const QhullResult expected = qhull(points);
    ASSERT_EQ(hull.dimension, 3);
    EXPECT_TRUE(is_closed(hull));
    EXPECT_LE(worst_height(hull, points), 1e-10);
    EXPECT_NEAR(volume_of(hull), expected.volume, 1e-9 * expected.volume);
    std::vector<int> found(hull.source.begin(), hull.source.end());
    EXPECT_EQ(found, expected.vertices);
  }
}

#endif

TEST(BuildHull, KeepsItsPromisesOnDegenerateAndScaledSets) {
  Random random(8);
  for (int round = 0; round < 600; ++round) {
    const double scale = std::array{1.0, 1e-9, 1e9, 1e-3}[random.below(4)];
    const Vec3 offset = random.below(2) ? Vec3(1e4, -2e4, 3e4) : Vec3(0, 0, 0);
    const double thickness = std::array{1.0, 1e-3, 1e-8, 1e-12}[random.below(4)];
    const Quat turn = random.orientation();
    std::vector<Vec3> points;
    const auto count = static_cast<int>(1 + random.below(60));
    for (int i = 0; i < count; ++i) {
      Vec3 p = random.in_cube(1.0);
      if (random.below(2))
        p = Vec3(std::round(2 * p.x()), std::round(2 * p.y()), std::round(p.z()));
      p.z() *= thickness;
      points.push_back(scale * (turn * p + offset));
      if (random.below(4) == 0) points.push_back(points[random.below(points.size())]);
    }
    const ConvexHull hull = build_hull(points, 1e-10);
    ASSERT_FALSE(hull.vertices.empty());
    EXPECT_TRUE(std::is_sorted(hull.source.begin(), hull.source.end()));
    for (std::size_t i = 0; i < hull.source.size(); ++i)
      EXPECT_EQ(hull.vertices[i], points[static_cast<std::size_t>(hull.source[i])]);
    if (hull.dimension >= 2) {
      EXPECT_TRUE(is_closed(hull));
      // Coordinates far from the origin were rounded before the hull saw them, and so were the
      // heights here.
      EXPECT_LE(worst_height(hull, points), 3e-10);
    }
    const ConvexHull again = build_hull(points, 1e-10);
    EXPECT_EQ(hull.source, again.source);
    EXPECT_EQ(hull.triangles, again.triangles);
  }
}

TEST(BuildHull, FindsTheDimension) {
  EXPECT_EQ(build_hull(std::vector<Vec3>{{1, 2, 3}}).dimension, 0);
  EXPECT_EQ(build_hull(std::vector<Vec3>(5, Vec3(1, 2, 3))).vertices.size(), 1u);
  const ConvexHull line = build_hull(std::vector<Vec3>{{1, 1, 1}, {0, 0, 0}, {3, 3, 3}, {2, 2, 2}});
  EXPECT_EQ(line.dimension, 1);
  EXPECT_EQ(line.source, (std::vector<std::int32_t>{1, 2}));
  EXPECT_TRUE(line.triangles.empty());
  const ConvexHull square = build_hull(
      std::vector<Vec3>{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}, {0.5, 0.5, 5}, {0.5, 0, 5}});
  EXPECT_EQ(square.dimension, 2);
  EXPECT_EQ(square.source, (std::vector<std::int32_t>{0, 1, 2, 3}));
  EXPECT_EQ(square.triangles.size(), 4u);
}

TEST(BuildHull, CubeAtEveryScaleHasEightCornersAndItsVolume) {
  for (const double half : {1e-9, 1.0, 1e9}) {
    std::vector<Vec3> points = cube(half);
    points.push_back(Vec3::Zero());
    points.push_back(Vec3(half, 0, 0));
    points.push_back(Vec3(half, half, 0));
    const ConvexHull hull = build_hull(points);
    EXPECT_EQ(hull.dimension, 3);
    EXPECT_EQ(hull.vertices.size(), 8u);
    EXPECT_EQ(hull.triangles.size(), 12u);
    EXPECT_NEAR(volume_of(hull), 8 * half * half * half, 1e-12 * half * half * half);
  }
}

TEST(BuildHull, RefusesNothingAndNotANumber) {
  EXPECT_THROW(build_hull(std::vector<Vec3>{}), InputError);
  EXPECT_THROW(build_hull(std::vector<Vec3>{{0, 0, 0}, {0, std::nan(""), 0}}), InputError);
}

}  // namespace
}  // namespace thigma
