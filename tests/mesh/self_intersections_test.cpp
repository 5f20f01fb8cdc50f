#include "thigma/mesh/self_intersections.h"

#include "support/mesh_samples.h"
#include <gtest/gtest.h>

#include "thigma/import/read_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/predicates.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

std::int64_t pairs_of(const TriangleMesh& mesh) {
  return find_self_intersections(merge_equal_positions(mesh).mesh).pairs;
}

// Two triangles as a mesh.
std::int64_t meet(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  return pairs_of({{a[0], a[1], a[2], b[0], b[1], b[2]}, {{0, 1, 2}, {3, 4, 5}}});
}

TEST(SelfIntersections, a_pair_counts_when_it_meets_beyond_what_it_shares) {
  const std::array<Vec3, 3> a{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  EXPECT_EQ(meet(a, {Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(9, 9, 1)}), 1);  // through
  EXPECT_EQ(meet(a, {Vec3(1, 1, 0), Vec3(1, 2, 1), Vec3(2, 1, 1)}), 1);   // a corner on it
  EXPECT_EQ(meet(a, {Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)}), 1);   // coplanar, inside
  EXPECT_EQ(meet(a, {Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(1, 2, 1)}), 0);   // above
  EXPECT_EQ(meet(a, a), 1);                                               // the same
  EXPECT_EQ(meet(a, {Vec3(0, 0, 0), Vec3(0, 4, 0), Vec3(4, 0, 0)}), 1);   // the same, turned
  // One edge in common.
  EXPECT_EQ(meet(a, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(0, -4, 0)}), 0);      // the flat neighbour
  EXPECT_EQ(meet(a, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 0)}), 1);       // folded flat
  EXPECT_EQ(meet(a, {Vec3(4, 0, 0), Vec3(0, 0, 0), Vec3(1, 1, 1e-300)}), 0);  // folded, not quite
  // One corner in common.
  EXPECT_EQ(meet(a, {Vec3(0, 0, 0), Vec3(-4, 0, 0), Vec3(0, -4, 0)}), 0);
  EXPECT_EQ(meet(a, {Vec3(0, 0, 0), Vec3(4, 0, 1), Vec3(0, 4, 1)}), 0);
  EXPECT_EQ(meet(a, {Vec3(0, 0, 0), Vec3(1, 1, -1), Vec3(1, 1, 1)}), 1);
  EXPECT_EQ(meet(a, {Vec3(0, 0, 0), Vec3(3, 1, 0), Vec3(1, 3, 0)}), 1);  // coplanar, overlapping
  EXPECT_EQ(meet(a, {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 2)}), 1);  // along half an edge
  // Zero area counts nowhere.
  EXPECT_EQ(meet(a, {Vec3(1, 1, -1), Vec3(1, 1, 0), Vec3(1, 1, 1)}), 0);
}

TEST(SelfIntersections, clean_shapes_have_none_and_overlapping_ones_some) {
  EXPECT_EQ(pairs_of(make_ball(1.0, 10)), 0);
  EXPECT_EQ(pairs_of(make_box({1, 1, 1}, {5, 6, 7})), 0);
  EXPECT_EQ(pairs_of(make_torus(1.0, 0.3, 40, 20)), 0);
  EXPECT_GT(pairs_of(joined(make_ball(1.0, 6), test::moved(make_ball(1.0, 6), {0.5, 0.1, 0.2}))),
            50);
}

// Against all pairs, one by one. Integer coordinates on a coarse grid give coplanar, touching and
// crossing pairs alike.
TEST(SelfIntersections, the_tree_finds_what_all_pairs_find) {
  Random random(21);
  for (int round = 0; round < 30; ++round) {
    TriangleMesh mesh;
    const int grid = 3 + round % 6;
    for (int i = 0; i < 60; ++i) {
      const std::int32_t base = static_cast<std::int32_t>(mesh.positions.size());
      const auto at = [&] {
        return static_cast<double>(random.below(static_cast<std::uint64_t>(grid)));
      };
      for (int k = 0; k < 3; ++k) {
        const double x = at(), y = at();
        mesh.positions.emplace_back(x, y, at());
      }
      mesh.triangles.push_back({base, base + 1, base + 2});
    }
    mesh = merge_equal_positions(mesh).mesh;
    const SelfIntersections found = find_self_intersections(mesh, true);
    std::vector<std::array<std::int32_t, 2>> want;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(mesh.triangles.size()); ++i) {
      for (std::int32_t j = i + 1; j < static_cast<std::int32_t>(mesh.triangles.size()); ++j) {
        const TriangleMesh two{mesh.positions,
                               {mesh.triangles[static_cast<std::size_t>(i)],
                                mesh.triangles[static_cast<std::size_t>(j)]}};
        if (find_self_intersections(two).pairs > 0) want.push_back({i, j});
      }
    }
    ASSERT_EQ(found.found, want) << round;
    ASSERT_EQ(found.pairs, static_cast<std::int64_t>(want.size()));
  }
}

// Independent of the predicates: small pieces of one triangle that cross the plane of the other
// inside its border.
TEST(SelfIntersections, general_pairs_agree_with_a_dense_sampling) {
  Random random(22);
  int met = 0;
  for (int i = 0; i < 400; ++i) {
    const std::array<Vec3, 3> a{random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    const std::array<Vec3, 3> b{random.in_cube(1), random.in_cube(1), random.in_cube(1)};
    // Points of a's surface: signed height over b's plane and inside b's prism.
    const Vec3 n = (b[1] - b[0]).cross(b[2] - b[0]);
    const auto inside_prism = [&](const Vec3& p) {
      for (std::size_t k = 0; k < 3; ++k) {
        if ((b[(k + 1) % 3] - b[k]).cross(p - b[k]).dot(n) < 0.0) return false;
      }
      return true;
    };
    constexpr int kSteps = 60;
    bool sampled = false;
    for (int u = 0; u < kSteps && !sampled; ++u) {
      for (int v = 0; u + v < kSteps && !sampled; ++v) {
        const auto at = [&](int s, int t) -> Vec3 {
          return a[0] + (a[1] - a[0]) * (static_cast<double>(s) / kSteps) +
                 (a[2] - a[0]) * (static_cast<double>(t) / kSteps);
        };
        const Vec3 p = at(u, v), q = at(u + 1, v), r = at(u, v + 1);
        const double hp = n.dot(p - b[0]), hq = n.dot(q - b[0]), hr = n.dot(r - b[0]);
        const bool crosses = (hp < 0) != (hq < 0) || (hp < 0) != (hr < 0);
        sampled = crosses && inside_prism(p) && inside_prism(q) && inside_prism(r);
      }
    }
    met += sampled;
    ASSERT_TRUE(!sampled || meet(a, b) == 1) << i;  // sampling cannot prove the opposite
  }
  EXPECT_GT(met, 20);
}

TEST(SelfIntersections, the_count_stops_on_a_heap_of_equal_triangles) {
  TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {}};
  mesh.triangles.assign(20000, {0, 1, 2});
  const SelfIntersections found = find_self_intersections(mesh);
  EXPECT_FALSE(found.complete);
  EXPECT_GT(found.pairs, 1000000);
}

}  // namespace
}  // namespace thigma
