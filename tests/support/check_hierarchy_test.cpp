#include "support/check_hierarchy.h"

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

struct CheckHierarchy : ::testing::Test {
  TriangleMesh mesh = make_torus(1.0, 0.4, 24, 14);
  ClodHierarchy h = build_exact_hierarchy(mesh);
};

TEST_F(CheckHierarchy, FindsNothingWrongWithARightOne) {
  EXPECT_EQ(check_hierarchy(h, mesh).total(), 0);
}

TEST_F(CheckHierarchy, FindsADistanceThatIsTooSmall) {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < h.nodes.size(); ++i)
    if (h.nodes[i].hausdorff > h.nodes[worst].hausdorff) worst = i;
  h.nodes[worst].hausdorff *= 0.9;
  const HierarchyCheck check = check_hierarchy(h, mesh);
  EXPECT_EQ(check.uncovered_nodes, 1);
  EXPECT_GT(check.worst_uncovered, 0.0);
}

TEST_F(CheckHierarchy, FindsASphereThatIsTooSmall) {
  h.nodes[3].radius *= 0.999;
  EXPECT_EQ(check_hierarchy(h, mesh).uncovered_nodes, 1);
}

TEST_F(CheckHierarchy, FindsALostTriangleAndALostChild) {
  ClodHierarchy lost = h;
  lost.patches[2].triangle_count -= 1;
  EXPECT_EQ(check_hierarchy(lost, mesh).misplaced_triangles, 1);
  h.nodes[0].child_count = 1;
  EXPECT_GT(check_hierarchy(h, mesh).misplaced_nodes, 0);
}

TEST_F(CheckHierarchy, FindsAWrongCornerAndAWrongFace) {
  ClodHierarchy wrong = h;
  std::swap(wrong.hull_triangles[5].corner[0], wrong.hull_triangles[5].corner[1]);
  EXPECT_GT(check_hierarchy(wrong, mesh).wrong_corners, 0);
  h.faces[1].offset += 0.01;
  EXPECT_EQ(check_hierarchy(h, mesh).wrong_features, 1);
}

TEST_F(CheckHierarchy, FindsProtrusionAndReflexEdgesOfOtherTolerances) {
  const ClodHierarchy careless =
      build_exact_hierarchy(make_torus(1.0, 0.4, 24, 14), {.convexity_tolerance = 0.05});
  const HierarchyCheck check = check_hierarchy(careless, mesh);
  EXPECT_GT(check.reflex_edges, 0);
  EXPECT_GT(check.off_hull, 0);
  const TriangleMesh shell = make_l_shape(1.0, 0.001);
  const HierarchyCheck protruding = check_hierarchy(
      build_exact_hierarchy(shell, {.convexity_tolerance = 2.0, .protrusion_tolerance = 3.0}),
      shell);
  EXPECT_GT(protruding.protruding_patches + protruding.reflex_edges, 0);
}

}  // namespace
}  // namespace thigma
