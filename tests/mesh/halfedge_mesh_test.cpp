#include "thigma/mesh/halfedge_mesh.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "thigma/import/inspect.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

std::int64_t euler(const TriangleMesh& mesh) {
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  std::set<std::int32_t> vertices;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      vertices.insert(t[k]);
      edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
  return static_cast<std::int64_t>(vertices.size() + mesh.triangles.size()) -
         static_cast<std::int64_t>(edges.size());
}

std::int64_t boundary_loops(const TriangleMesh& mesh) {
  std::map<std::int32_t, std::int32_t> next;
  std::set<std::pair<std::int32_t, std::int32_t>> directed;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) directed.insert({t[k], t[(k + 1) % 3]});
  for (const auto& [a, b] : directed)
    if (!directed.count({b, a})) next[b] = a;
  std::int64_t loops = 0;
  while (!next.empty()) {
    ++loops;
    std::int32_t v = next.begin()->first;
    while (next.count(v)) {
      const std::int32_t following = next[v];
      next.erase(v);
      v = following;
    }
  }
  return loops;
}

/// What a collapse has to make of a mesh, without any neighbourhood: rename, drop what repeats.
TriangleMesh renamed(const TriangleMesh& mesh, std::int32_t kept, std::int32_t gone) {
  TriangleMesh result;
  result.positions = mesh.positions;
  for (auto t : mesh.triangles) {
    for (auto& v : t)
      if (v == gone) v = kept;
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) result.triangles.push_back(t);
  }
  return result;
}

TriangleMesh alive(const HalfedgeMesh& m) {
  TriangleMesh result;
  result.positions = m.positions;
  for (const auto& t : m.triangles)
    if (t[0] >= 0) result.triangles.push_back(t);
  return result;
}

bool is_manifold(const TriangleMesh& mesh) {
  const MeshReport report = inspect_mesh(mesh, {.self_intersections = false});
  return report.manifold && report.oriented && report.duplicate_triangles == 0;
}

/// Collapses edges at random until none can be, against renaming.
void collapse_all(const TriangleMesh& mesh, std::uint64_t seed) {
  HalfedgeMesh m = build_halfedge_mesh(mesh);
  ASSERT_EQ(count_halfedge_faults(m), 0);
  const std::int64_t genus = euler(mesh), loops = boundary_loops(mesh);
  Random random(seed);
  TriangleMesh expected = mesh;
  int failures = 0, collapses = 0;
  while (failures < 400) {
    const auto h = static_cast<std::int32_t>(random.below(m.twin.size()));
    if (m.triangles[static_cast<std::size_t>(h / 3)][0] < 0 || !can_collapse(m, h)) {
      ++failures;
      continue;
    }
    failures = 0;
    ++collapses;
    const std::int32_t kept = tail_of(m, h), gone = head_of(m, h);
    EXPECT_EQ(find_halfedge(m, kept, gone), h);
    collapse_edge(m, h, m.positions[static_cast<std::size_t>(kept)]);
    expected = renamed(expected, kept, gone);
    ASSERT_EQ(count_halfedge_faults(m), 0);
    ASSERT_EQ(alive(m).triangles, expected.triangles);
  }
  EXPECT_GT(collapses, 0);
  const TriangleMesh left = alive(m);
  EXPECT_EQ(euler(left), genus);
  EXPECT_EQ(boundary_loops(left), loops);
  const CompactMesh small = compact(m);
  EXPECT_EQ(small.mesh.triangles.size(), left.triangles.size());
  for (std::size_t i = 0; i < small.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(small.mesh.positions[static_cast<std::size_t>(small.mesh.triangles[i][k])],
                left.positions[static_cast<std::size_t>(left.triangles[i][k])]);
}

TEST(HalfedgeMesh, CollapsesLikeRenaming) {
  collapse_all(make_ball(1.0, 3), 1);
  collapse_all(make_torus(3.0, 1.0, 12, 7), 2);
  collapse_all(make_sheet(1, 1, 7, 6), 3);
  collapse_all(make_dome(1.0, 9, 4), 4);
  collapse_all(joined(make_box({1, 1, 1}, {2, 2, 2}), make_sheet(1, 1, 3, 3)), 5);
  collapse_all(make_cylinder(1.0, 2.0, 10, 3), 6);
}

TEST(HalfedgeMesh, RefusesExactlyWhatChangesTheSurface) {
  // Against the definition: after renaming, is it a manifold of the same characteristic and rims?
  for (const TriangleMesh& mesh :
       {make_tetrahedron(1.0), make_box({1, 1, 1}), make_ball(1.0, 2), make_sheet(1, 1, 3, 3),
        make_torus(3.0, 1.0, 3, 3), make_dome(1.0, 4, 2), make_sheet(1, 1, 1, 1)}) {
    const HalfedgeMesh m = build_halfedge_mesh(mesh);
    for (std::int32_t h = 0; h < static_cast<std::int32_t>(m.twin.size()); ++h) {
      const TriangleMesh after = renamed(mesh, tail_of(m, h), head_of(m, h));
      const bool keeps = !after.triangles.empty() && is_manifold(after) &&
                         euler(after) == euler(mesh) &&
                         boundary_loops(after) == boundary_loops(mesh);
      // Cutting off an ear of an open surface keeps both counts, but not its rim.
      const bool cuts_across = m.twin[static_cast<std::size_t>(h)] >= 0 &&
                               is_boundary(m, tail_of(m, h)) && is_boundary(m, head_of(m, h));
      EXPECT_EQ(can_collapse(m, h), keeps && !cuts_across)
          << mesh.triangles.size() << " half-edge " << h;
    }
  }
}

TEST(HalfedgeMesh, LocksWhatIsNoManifold) {
  TriangleMesh fins;  // three triangles on the edge 0 1, and a fan that touches in vertex 5
  fins.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0},
                    {3, 0, 0}, {4, 0, 0}, {4, 1, 0}, {3, 0, 1}, {3, 1, 1}};
  fins.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {5, 6, 7}, {5, 8, 9}};
  const HalfedgeMesh m = build_halfedge_mesh(fins);
  EXPECT_EQ(m.is_locked, (std::vector<char>{1, 1, 0, 0, 0, 1, 0, 0, 0, 0}));
  for (std::int32_t h = 0; h < 15; ++h) EXPECT_FALSE(can_collapse(m, h));
  EXPECT_EQ(count_halfedge_faults(m), 0);
}

TEST(HalfedgeMesh, CountsFaults) {
  HalfedgeMesh m = build_halfedge_mesh(make_ball(1.0, 2));
  m.twin[5] = m.twin[6];
  EXPECT_GT(count_halfedge_faults(m), 0);
}

TEST(HalfedgeMesh, CarriesCornerValues) {
  // The value of every corner is its position: true for ever where collapses mix both alike.
  const TriangleMesh mesh = make_torus(3.0, 1.0, 12, 7);
  CornerAttributes values;
  values.width = 3;
  for (const Vec3& p : mesh.positions)
    values.values.insert(values.values.end(), p.data(), p.data() + 3);
  for (const auto& t : mesh.triangles)
    values.of_corner.insert(values.of_corner.end(), t.begin(), t.end());
  HalfedgeMesh m = build_halfedge_mesh(mesh, values);
  Random random(9);
  for (int i = 0; i < 2000; ++i) {
    const auto h = static_cast<std::int32_t>(random.below(m.twin.size()));
    if (m.triangles[static_cast<std::size_t>(h / 3)][0] < 0 || !can_collapse(m, h)) continue;
    const double share = random.uniform();
    const Vec3 a = m.positions[static_cast<std::size_t>(tail_of(m, h))];
    const Vec3 b = m.positions[static_cast<std::size_t>(head_of(m, h))];
    collapse_edge(m, h, a + share * (b - a), share);
  }
  const CompactMesh small = compact(m);
  EXPECT_LT(small.mesh.triangles.size(), mesh.triangles.size() / 2);
  for (std::size_t i = 0; i < small.mesh.triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = small.mesh.positions[static_cast<std::size_t>(small.mesh.triangles[i][k])];
      const auto value = static_cast<std::size_t>(small.attributes.of_corner[3 * i + k]);
      for (std::size_t x = 0; x < 3; ++x)
        EXPECT_NEAR(small.attributes.values[3 * value + x], p[static_cast<Eigen::Index>(x)], 1e-12);
    }
}

TEST(HalfedgeMesh, KeepsSeamsApart) {
  // A strip of 4 x 2 squares whose rows have charts of their own: 0 below the middle, 1 above.
  const TriangleMesh mesh = make_sheet(4, 2, 4, 2);
  CornerAttributes values;
  values.width = 1;
  const auto count = static_cast<std::int32_t>(mesh.positions.size());
  values.values.assign(static_cast<std::size_t>(2 * count), 0.0);
  std::fill(values.values.begin() + count, values.values.end(), 1.0);
  const auto chart = [&](const std::array<std::int32_t, 3>& t) {
    double y = 0.0;
    for (const auto v : t) y += mesh.positions[static_cast<std::size_t>(v)].y();
    return y > 0.0 ? 1 : 0;
  };
  for (const auto& t : mesh.triangles)
    for (const auto v : t) values.of_corner.push_back(v + chart(t) * count);
  HalfedgeMesh m = build_halfedge_mesh(mesh, values);
  int collapses = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(m.twin.size()); ++h) {
    if (m.triangles[static_cast<std::size_t>(h / 3)][0] < 0 || !can_collapse(m, h)) continue;
    const auto a = static_cast<std::size_t>(tail_of(m, h)),
               b = static_cast<std::size_t>(head_of(m, h));
    if (m.positions[a].y() != 0.0 || m.positions[b].y() != 0.0) continue;  // along the seam
    collapse_edge(m, h, m.positions[a], 0.3);
    ++collapses;
  }
  EXPECT_GT(collapses, 0);
  for (std::size_t t = 0; t < m.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3 && m.triangles[t][0] >= 0; ++k)
      EXPECT_EQ(m.attributes.values[static_cast<std::size_t>(m.attributes.of_corner[3 * t + k])],
                chart(mesh.triangles[t]));
}

}  // namespace
}  // namespace thigma
