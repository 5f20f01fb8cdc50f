#include "support/check_levels.h"

#include "simplify/simplify_support.h"
#include <gtest/gtest.h>

#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

TEST(CheckLevels, SeesWhatIsBroken) {
  const TriangleMesh mesh = test::wavy_ball(8);
  const ConvexDecomposition decomposition = decompose_surface(mesh);
  const Simplification right =
      simplify_surface({mesh, compute_topology(mesh), decomposition}, test::generous());
  ASSERT_GE(right.levels.size(), 4u);
  ASSERT_EQ(check_levels(right, decomposition).total(), 0);
  const auto broken = [&](auto change) {
    Simplification wrong = right;
    change(wrong.levels);
    return check_levels(wrong, decomposition);
  };
  using Levels = std::vector<SimplifiedLevel>;
  EXPECT_EQ(broken([](Levels& l) { l[2].patch_of_triangle[5] = -1; }).misplaced_triangles, 1);
  EXPECT_GT(broken([](Levels& l) { l[1].patch_count += 1; }).empty_patches, 0);
  EXPECT_GT(broken([](Levels& l) { l[1].parent[3] = -1; }).wrong_parents, 0);
  EXPECT_GT(broken([](Levels& l) { l[1].mesh.triangles.pop_back(); }).changed_surfaces, 0);
  EXPECT_GT(broken([](Levels& l) { l[2].resolution *= 1e3; }).rising_resolutions, 0);
  EXPECT_GT(broken([](Levels& l) {
              l.erase(l.begin() + 1, l.end() - 1), l.push_back(l.back());
            }).unhalved_levels,
            0);
  // All of a level in one patch: reflex inside, off its hull, which the rest reaches into.
  const LevelCheck one = broken([](Levels& l) {
    auto& p = l[1].patch_of_triangle;
    for (std::size_t t = 0; t < p.size(); ++t) p[t] = t < p.size() / 2 ? 0 : p[t];
  });
  EXPECT_GT(one.reflex_edges, 0);
  EXPECT_GT(one.off_hull, 0);
  EXPECT_GT(one.oversized_patches, 0);
  EXPECT_GT(one.protruding_patches, 0);
}

}  // namespace
}  // namespace thigma
