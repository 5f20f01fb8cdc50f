#include "thigma/mesh/halfedge_flip.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "thigma/core/index.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

using Edges = std::set<std::pair<std::int32_t, std::int32_t>>;

Edges edges_of(const HalfedgeMesh& m) {
  Edges edges;
  for (const auto& t : m.triangles)
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  return edges;
}

double volume_of(const HalfedgeMesh& m) { return mass_properties(compact(m).mesh).volume; }

TEST(HalfedgeFlip, TurnsOneEdgeAndNothingElse) {
  for (const TriangleMesh& mesh :
       {make_ball(1.0, 3), make_dome(1.0, 12, 4), make_torus(1.0, 0.4, 9, 7)}) {
    HalfedgeMesh m = build_halfedge_mesh(mesh);
    Random random(5);
    int flipped = 0;
    for (int i = 0; i < 200; ++i) {
      const auto h = static_cast<std::int32_t>(random.below(m.twin.size()));
      if (!can_flip(m, h)) continue;
      ++flipped;
      const FlipQuad q = quad_of(m, h);
      Edges expected = edges_of(m);
      EXPECT_EQ(expected.erase(std::minmax(q.a, q.b)), 1u);
      EXPECT_TRUE(expected.insert(std::minmax(q.c, q.d)).second);
      const double before = volume_of(m);
      const auto& x = m.positions;
      const Vec3& a = x[idx(q.a)];
      const double gained = (x[idx(q.b)] - a).cross(x[idx(q.c)] - a).dot(x[idx(q.d)] - a) / 6.0;
      flip_edge(m, h);
      EXPECT_EQ(edges_of(m), expected);
      EXPECT_EQ(count_halfedge_faults(m), 0);
      EXPECT_EQ(tail_of(m, h), q.a);
      EXPECT_EQ(head_of(m, h), q.d);
      EXPECT_NEAR(volume_of(m) - before, gained, 1e-12) << "they are the faces of one tetrahedron";
    }
    EXPECT_GT(flipped, 50);
  }
}

TEST(HalfedgeFlip, FlipsBack) {
  HalfedgeMesh m = build_halfedge_mesh(make_ball(1.0, 3));
  const HalfedgeMesh before = m;
  flip_edge(m, 0);
  EXPECT_NE(edges_of(m), edges_of(before));
  ASSERT_TRUE(can_flip(m, 1));
  flip_edge(m, 1);
  EXPECT_EQ(edges_of(m), edges_of(before));
}

TEST(HalfedgeFlip, TriesCornersWithoutLinking) {
  HalfedgeMesh m = build_halfedge_mesh(make_ball(1.0, 3));
  const HalfedgeMesh before = m;
  const FlipQuad q = quad_of(m, 4);
  set_flipped_corners(m, 4, q, true);
  const auto tried = m.triangles;
  EXPECT_NE(tried, before.triangles);
  EXPECT_EQ(m.twin, before.twin);
  set_flipped_corners(m, 4, q, false);
  EXPECT_EQ(m.triangles, before.triangles);
  flip_edge(m, 4);
  EXPECT_EQ(m.triangles, tried);
}

TEST(HalfedgeFlip, RefusesWhatWouldChangeTheSurface) {
  const HalfedgeMesh tetrahedron = build_halfedge_mesh(make_tetrahedron(1.0));
  for (std::int32_t h = 0; h < 12; ++h) EXPECT_FALSE(can_flip(tetrahedron, h)) << "both diagonals";
  HalfedgeMesh sheet = build_halfedge_mesh(make_sheet(1, 1, 3, 3));
  int inner = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(sheet.twin.size()); ++h) {
    inner += can_flip(sheet, h);
    if (sheet.twin[idx(h)] < 0) {
      EXPECT_FALSE(can_flip(sheet, h)) << "a rim has one triangle";
    }
  }
  EXPECT_GT(inner, 0);
  std::fill(sheet.is_locked.begin(), sheet.is_locked.end(), 1);
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(sheet.twin.size()); ++h)
    EXPECT_FALSE(can_flip(sheet, h));
}

/// The value of every corner is the number of its vertex, and of its triangle's half where there is
/// a seam.
CornerAttributes numbered(const TriangleMesh& mesh, bool has_seam) {
  CornerAttributes values;
  values.width = 1;
  for (const auto& t : mesh.triangles) {
    const bool is_left = mesh.positions[idx(t[0])].x() + mesh.positions[idx(t[1])].x() +
                             mesh.positions[idx(t[2])].x() <
                         0.0;
    for (const std::int32_t v : t) {
      const auto n = static_cast<std::int32_t>(mesh.positions.size());
      values.of_corner.push_back(has_seam && is_left ? v + n : v);
    }
  }
  for (std::size_t i = 0; i < 2 * mesh.positions.size(); ++i)
    values.values.push_back(static_cast<double>(i));
  return values;
}

TEST(HalfedgeFlip, CornersKeepTheirValues) {
  const TriangleMesh mesh = make_ball(1.0, 3);
  HalfedgeMesh m = build_halfedge_mesh(mesh, numbered(mesh, false));
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const auto h = static_cast<std::int32_t>(random.below(m.twin.size()));
    if (can_flip(m, h)) flip_edge(m, h);
  }
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(m.attributes.of_corner[3 * t + k], m.triangles[t][k]);
}

TEST(HalfedgeFlip, LeavesSeamsAlone) {
  const TriangleMesh mesh = make_ball(1.0, 3);
  const HalfedgeMesh m = build_halfedge_mesh(mesh, numbered(mesh, true)),
                     plain = build_halfedge_mesh(mesh);
  const auto side = [&](std::int32_t h) {
    return m.attributes.of_corner[idx(h)] >= static_cast<std::int32_t>(mesh.positions.size());
  };
  int seams = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(m.twin.size()); ++h) {
    const bool is_seam = side(h) != side(m.twin[idx(h)]);
    seams += is_seam;
    EXPECT_EQ(can_flip(m, h), can_flip(plain, h) && !is_seam);
  }
  EXPECT_GT(seams, 4);
}

}  // namespace
}  // namespace thigma
