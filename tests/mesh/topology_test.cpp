#include "thigma/mesh/topology.h"

#include <set>

#include "support/mesh_samples.h"
#include <gtest/gtest.h>

#include "thigma/import/read_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TEST(Topology, every_edge_of_a_closed_mesh_has_two_uses_of_opposite_direction) {
  const TriangleMesh ball = make_ball(1.0, 6);
  const EdgeTable table = build_edge_table(ball);
  EXPECT_EQ(table.edges.size(), ball.triangles.size() * 3 / 2);
  for (const MeshEdge& e : table.edges) {
    ASSERT_EQ(e.use_count, 2);
    ASSERT_NE(table.uses_of(e)[0].is_forward, table.uses_of(e)[1].is_forward);
    for (const EdgeUse& u : table.uses_of(e)) {
      const auto& t = ball.triangles[static_cast<std::size_t>(u.triangle)];
      const std::int32_t from = t[static_cast<std::size_t>(u.corner)];
      const std::int32_t to = t[static_cast<std::size_t>((u.corner + 1) % 3)];
      ASSERT_EQ(from, u.is_forward ? e.a : e.b);
      ASSERT_EQ(to, u.is_forward ? e.b : e.a);
    }
  }
}

TEST(Topology, components_are_numbered_in_the_order_of_their_triangles) {
  const TriangleMesh two = joined(make_ball(1.0, 2), test::moved(make_box({1, 1, 1}), {5, 0, 0}));
  const Components c = connect_over_edges(two, build_edge_table(two));
  EXPECT_EQ(c.count, 2);
  EXPECT_EQ(c.of_triangle.front(), 0);
  EXPECT_EQ(c.of_triangle.back(), 1);
}

TEST(Topology, orientation_finds_exactly_the_triangles_that_were_turned) {
  TriangleMesh ball = make_ball(1.0, 5);
  Random random(3);
  std::vector<bool> turned(ball.triangles.size(), false);
  for (std::size_t t = 0; t < turned.size(); ++t) {
    if (random.below(3) != 0) continue;
    turned[t] = true;
    std::swap(ball.triangles[t][0], ball.triangles[t][1]);
  }
  const Orientation o = orient_sheets(ball, build_edge_table(ball));
  EXPECT_EQ(o.sheets, 1);
  EXPECT_TRUE(o.is_orientable[0]);
  EXPECT_EQ(o.is_flipped, turned);
}

TEST(Topology, a_moebius_strip_cannot_be_oriented) {
  const TriangleMesh strip = make_moebius(1.0, 0.2, 20);
  EXPECT_FALSE(orient_sheets(strip, build_edge_table(strip)).is_orientable[0]);
  const TriangleMesh torus = make_torus(1.0, 0.3, 12, 8);
  EXPECT_TRUE(orient_sheets(torus, build_edge_table(torus)).is_orientable[0]);
}

TEST(Topology, a_vertex_where_two_solids_touch_has_two_fans) {
  TriangleMesh two = joined(make_box({1, 1, 1}), test::moved(make_box({1, 1, 1}), {1, 1, 1}));
  two = merge_equal_positions(two).mesh;
  EXPECT_EQ(two.positions.size(), 15u);
  const Fans fans = build_fans(two, build_edge_table(two));
  EXPECT_EQ(fans.count, 16);
}

TEST(Topology, duplicates_are_found_either_way_round) {
  const TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
                          {{0, 1, 2}, {0, 1, 3}, {2, 0, 1}, {1, 0, 2}}};
  EXPECT_EQ(find_duplicates(mesh), (std::vector<std::int32_t>{-1, -1, 0, 0}));
}

TEST(Topology, a_point_is_inside_by_parity) {
  TriangleMesh mesh = joined(make_box({4, 4, 4}), make_ball(1.0, 4));
  const Components c = connect_over_edges(mesh, build_edge_table(mesh));
  const InsideTest test(mesh, c);
  EXPECT_EQ(*test.components_around({0, 0, 0}), (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(*test.components_around({0, 0, 0}, 0), (std::vector<std::int32_t>{1}));
  EXPECT_EQ(*test.components_around({1.5, 1.5, 1.5}), (std::vector<std::int32_t>{0}));
  EXPECT_TRUE(test.components_around({3, 0, 0})->empty());
  EXPECT_FALSE(test.components_around({2, 0.3, 0.1}).has_value());  // on a face
  EXPECT_TRUE(test.components_around({2, 0.3, 0.1}, 0)->empty());
  Random random(9);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.in_cube(3.0);
    const bool in_box = p.cwiseAbs().maxCoeff() < 2.0;
    const std::vector<std::int32_t> around = *test.components_around(p);
    ASSERT_EQ(in_box, !around.empty() && around[0] == 0);
    ASSERT_TRUE(p.norm() <= 1.0 || around.size() <= 1);
    ASSERT_TRUE(p.norm() >= 0.9 || around.size() == 2);
  }
}

}  // namespace
}  // namespace thigma
