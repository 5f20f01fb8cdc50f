#include "thigma/simplify/detail/deviation_guard.h"

#include "simplify/simplify_support.h"
#include <gtest/gtest.h>

#include "thigma/convex/quickhull.h"
#include "thigma/core/index.h"
#include "thigma/math/random.h"

namespace thigma::detail {
namespace {

double distance_by_loop(const TriangleMesh& mesh, const Vec3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles)
    least = std::min(
        least, point_triangle_distance(p, mesh.positions[idx(t[0])], mesh.positions[idx(t[1])],
                                       mesh.positions[idx(t[2])]));
  return least;
}

TEST(DeviationGuard, FindsATriangleWithinTheLimitWhereThereIsOne) {
  const TriangleMesh mesh = test::wavy_ball(6);
  Random random(3);
  int found = 0;
  for (const double limit : {0.01, 0.1, 0.4}) {
    const DeviationGuard guard = build_deviation_guard(mesh);
    DeviationSearch search{limit, {}};
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = random.in_cube(1.3);
      const std::int32_t t = find_within_limit(guard, search, p, {0, 1, 2});
      EXPECT_EQ(t >= 0, distance_by_loop(mesh, p) <= limit);
      if (t < 0) continue;
      ++found;
      const auto& v = mesh.triangles[idx(t)];
      EXPECT_LE(point_triangle_distance(p, mesh.positions[idx(v[0])], mesh.positions[idx(v[1])],
                                        mesh.positions[idx(v[2])]),
                limit);
    }
  }
  EXPECT_GT(found, 100);
}

/// The samples of a triangle but for its corners, by a loop over all triangles.
bool is_near_by_loop(const TriangleMesh& mesh, const std::array<Vec3, 3>& c, int n, double limit) {
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= n - i; ++j)
      if ((i > 0 || (j < n && j > 0)) &&
          distance_by_loop(mesh, (i * c[0] + j * c[1] + (n - i - j) * c[2]) / n) > limit)
        return false;
  return n != 2 || distance_by_loop(mesh, (c[0] + c[1] + c[2]) / 3.0) <= limit;
}

TEST(DeviationGuard, TestsEverySampleOfATriangle) {
  const TriangleMesh mesh = test::wavy_ball(6);
  Random random(5);
  int near = 0;
  for (const double limit : {0.05, 0.2}) {
    const DeviationGuard guard = build_deviation_guard(mesh);
    DeviationSearch search{limit, {}};
    for (int i = 0; i < 300; ++i) {
      const auto& v = mesh.triangles[idx(i)];
      std::array<Vec3, 3> c;
      for (std::size_t k = 0; k < 3; ++k)
        c[k] = mesh.positions[idx(v[k])] + random.uniform(0.0, 2.0 * limit) * random.in_cube(1.3);
      const int n = count_divisions(limit, c);
      const bool is_near = is_within_limit(guard, search, c, v, n);
      EXPECT_EQ(is_near, is_near_by_loop(mesh, c, n, limit));
      if (is_near) {
        EXPECT_TRUE(is_within_limit(guard, search, c, v, n, false));
      }
      near += is_near;
    }
  }
  EXPECT_GT(near, 50);
  EXPECT_LT(near, 550);
}

TEST(DeviationGuard, LeavesOutTheSamplesOfTheLastEdge) {
  const TriangleMesh sheet = make_sheet(2, 2, 4, 4);
  const DeviationGuard guard = build_deviation_guard(sheet);
  DeviationSearch search{0.01, {}};
  // Only the edge from the last corner to the first leaves the sheet.
  const Vec3 inside = 0.5 * sheet.positions[0] + 0.5 * sheet.positions[12];
  const std::array<Vec3, 3> c = {inside + Vec3(0, 0, 0.009), inside, inside + Vec3(0, 0, 0.009)};
  EXPECT_EQ(count_divisions(0.01, c), 2);
  EXPECT_TRUE(is_within_limit(guard, search, c, {0, 0, 0}, 2));
  const Vec3 apart = inside + Vec3(0, 0, 0.019);
  const std::array<Vec3, 3> far = {apart, inside, inside};
  EXPECT_TRUE(is_within_limit(guard, search, far, {0, 0, 0}, 2))
      << "the middle is within the limit";
  EXPECT_FALSE(is_within_limit(guard, search, {apart, inside, apart}, {0, 0, 0}, 2));
  EXPECT_TRUE(is_within_limit(guard, search, {apart, inside - Vec3(0, 0, 0.019), apart}, {0, 0, 0},
                              2, false));
}

}  // namespace
}  // namespace thigma::detail
