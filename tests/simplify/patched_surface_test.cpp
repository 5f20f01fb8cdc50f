#include "thigma/simplify/patched_surface.h"

#include <algorithm>

#include "simplify/simplify_support.h"
#include <gtest/gtest.h>

#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

PatchedSurface patched(const TriangleMesh& mesh, int max_vertices = 32) {
  DecompositionParams params;
  params.max_vertices = max_vertices;
  return build_patched_surface({mesh, compute_topology(mesh), decompose_surface(mesh, params)},
                               1e-6, 1e-5);
}

TEST(PatchedSurface, StartsAsTheDecomposition) {
  const TriangleMesh mesh = test::wavy_ball(6);
  const ConvexDecomposition decomposition = decompose_surface(mesh);
  const PatchedSurface s = patched(mesh);
  EXPECT_EQ(s.patch_of, decomposition.patch_of_triangle);
  EXPECT_EQ(s.patch_count, static_cast<std::int32_t>(decomposition.patches.size()));
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangles.size()); ++t) {
    EXPECT_NEAR(s.normal[static_cast<std::size_t>(t)].norm(), 1.0, 1e-14);
    for (const Vec3& corner : corners_of(s, t))
      EXPECT_LT(std::fabs(height_over(s, t, corner)), 1e-15);
  }
  for (const SurfacePatch& patch : s.patches)
    for (const std::int32_t v : patch.vertices)
      for (const HalfSpace& h : patch.half_spaces)
        EXPECT_LE(h.normal.dot(s.mesh.positions[static_cast<std::size_t>(v)]),
                  h.offset + s.inset + 1e-14);
}

TEST(PatchedSurface, FindsAHomeForTrianglesWithoutArea) {
  // A square whose diagonal carries a triangle without area.
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 4}, {4, 2, 3}, {0, 4, 3}};
  const PatchedSurface s = patched(mesh);
  EXPECT_EQ(s.height[1], 0.0);
  for (const std::int32_t patch : s.patch_of) {
    ASSERT_GE(patch, 0);
    EXPECT_FALSE(s.patches[static_cast<std::size_t>(patch)].triangles.empty());
  }
}

TEST(PatchedSurface, MergesWhatIsConvexTogether) {
  // Patches of at most 6 vertices, then allowed 32: a ball may become few, a cap decides how few.
  const TriangleMesh mesh = make_ball(1.0, 2);  // 42 vertices
  PatchedSurface s = patched(mesh, 6);
  const std::int32_t before = s.patch_count;
  s.max_vertices = 32;
  Quickhull hull;
  std::vector<std::int32_t> successor(s.patches.size(), -1);
  int merged = 0;
  for (std::size_t i = 0; i < s.patches.size(); ++i)
    if (!s.patches[i].triangles.empty())
      merged += merge_patch(s, static_cast<std::int32_t>(i), hull, successor);
  EXPECT_GT(merged, 0);
  EXPECT_EQ(s.patch_count, before - merged);
  EXPECT_EQ(
      std::count_if(successor.begin(), successor.end(), [](std::int32_t p) { return p >= 0; }),
      merged);
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < s.patches.size(); ++i) {
    triangles += s.patches[i].triangles.size();
    EXPECT_LE(s.patches[i].vertices.size(), 32u);
    for (const std::int32_t t : s.patches[i].triangles)
      EXPECT_EQ(s.patch_of[static_cast<std::size_t>(t)], static_cast<std::int32_t>(i));
  }
  EXPECT_EQ(triangles, mesh.triangles.size());
}

TEST(PatchedSurface, DoesNotMergeOverAReflexEdgeOrIntoTheSurface) {
  PatchedSurface s = patched(flipped(make_ball(1.0, 2)));  // reflex everywhere
  Quickhull hull;
  std::vector<std::int32_t> successor(s.patches.size(), -1);
  for (std::size_t i = 0; i < s.patches.size(); ++i)
    EXPECT_EQ(merge_patch(s, static_cast<std::int32_t>(i), hull, successor), 0);
  EXPECT_EQ(s.patch_count, static_cast<std::int32_t>(s.patches.size()));
}

}  // namespace
}  // namespace thigma
