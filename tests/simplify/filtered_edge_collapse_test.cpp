#include "thigma/simplify/filtered_edge_collapse.h"

#include "simplify/simplify_support.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

struct CollapseBench : test::SurfaceBench {
  using SurfaceBench::SurfaceBench;
  CollapseOutcome collapse(std::int32_t h) {
    return filtered_edge_collapse(surface, context, h, successor);
  }
};

TEST(FilteredEdgeCollapse, ChangesNothingWhenItRefuses) {
  CollapseBench bench(test::wavy_ball(5));
  int refused = 0, collapsed = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(bench.surface.mesh.twin.size()); ++h) {
    if (bench.surface.mesh.triangles[static_cast<std::size_t>(h / 3)][0] < 0) continue;
    const PatchedSurface before = bench.surface;
    const CollapseOutcome outcome = bench.collapse(h);
    if (outcome == CollapseOutcome::collapsed) {
      ++collapsed;
      EXPECT_EQ(bench.surface.mesh.triangle_count, before.mesh.triangle_count - 2);
      EXPECT_EQ(count_halfedge_faults(bench.surface.mesh), 0);
    } else {
      ++refused;
      EXPECT_TRUE(test::same(before, bench.surface));
    }
  }
  EXPECT_GT(refused, 10);
  EXPECT_GT(collapsed, 10);
}

TEST(FilteredEdgeCollapse, KeepsPatchesConvexAndTheirListsRight) {
  CollapseBench bench(test::wavy_ball(6));
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(bench.surface.mesh.twin.size()); ++h)
    if (bench.surface.mesh.triangles[static_cast<std::size_t>(h / 3)][0] >= 0) bench.collapse(h);
  const PatchedSurface& s = bench.surface;
  std::int32_t alive = 0;
  for (std::size_t i = 0; i < s.patches.size(); ++i) {
    const SurfacePatch& patch = s.patches[i];
    alive += !patch.triangles.empty();
    if (patch.triangles.empty()) {
      EXPECT_NE(bench.successor[i], static_cast<std::int32_t>(i)) << "adopted";
    }
    std::vector<std::int32_t> used;
    for (const std::int32_t t : patch.triangles) {
      EXPECT_EQ(s.patch_of[static_cast<std::size_t>(t)], static_cast<std::int32_t>(i));
      const auto& v = s.mesh.triangles[static_cast<std::size_t>(t)];
      used.insert(used.end(), v.begin(), v.end());
      for (const std::int32_t w : patch.vertices)
        EXPECT_LE(height_over(s, t, s.mesh.positions[static_cast<std::size_t>(w)]), s.flat);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::vector<std::int32_t> listed = patch.vertices;
    std::sort(listed.begin(), listed.end());
    EXPECT_EQ(used, listed);
  }
  EXPECT_EQ(alive, s.patch_count);
}

TEST(FilteredEdgeCollapse, NamesItsReasons) {
  CollapseBench tetrahedron(make_tetrahedron(1.0));
  EXPECT_EQ(tetrahedron.collapse(0), CollapseOutcome::topology);
  // A box edge cannot go without leaving the surface or its convexity.
  CollapseBench box(make_box({1, 1, 1}, {1, 1, 1}), 1e-4);
  for (std::int32_t h = 0; h < 36; ++h) EXPECT_NE(box.collapse(h), CollapseOutcome::collapsed);
  CollapseBench ball(make_ball(1.0, 4), 1e-9);
  int deviating = 0;
  for (std::int32_t h = 0; h < 60; ++h) deviating += ball.collapse(h) == CollapseOutcome::deviation;
  EXPECT_GT(deviating, 10) << "no coarser ball within a billionth of the radius";
}

TEST(FilteredEdgeCollapse, KeepsBoundaryVerticesOnTheBoundary) {
  CollapseBench sheet(make_dome(1.0, 16, 6), 0.1);
  int collapsed = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(sheet.surface.mesh.twin.size()); ++h) {
    const auto& m = sheet.surface.mesh;
    if (m.triangles[static_cast<std::size_t>(h / 3)][0] < 0) continue;
    const std::int32_t tail = tail_of(m, h), head = head_of(m, h);
    const bool on_rim = is_boundary(m, tail) || is_boundary(m, head);
    const Vec3 a = m.positions[static_cast<std::size_t>(tail)],
               b = m.positions[static_cast<std::size_t>(head)];
    if (sheet.collapse(h) != CollapseOutcome::collapsed || !on_rim) continue;
    ++collapsed;
    const Vec3& p = m.positions[static_cast<std::size_t>(tail)];
    EXPECT_TRUE(p == a || p == b);
    EXPECT_EQ(p.z(), 0.0) << "the rim of the dome";
  }
  EXPECT_GT(collapsed, 3);
}

TEST(FilteredEdgeCollapse, TakesSpikesOfNoiseDown) {
  TriangleMesh mesh = make_sheet(1, 1, 8, 8);
  std::size_t spike = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (mesh.positions[v].norm() < 1e-9) spike = v;
  mesh.positions[spike].z() = 0.01;
  CollapseBench relaxed(mesh);
  const std::int32_t h = relaxed.surface.mesh.outgoing[spike];
  ASSERT_EQ(relaxed.collapse(h), CollapseOutcome::collapsed);
  EXPECT_LT(std::fabs(relaxed.surface.mesh.positions[spike].z()), 0.008);
}

}  // namespace
}  // namespace thigma
