#include "thigma/mesh/triangle_tree.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

/// Triangles whose boxes meet a box, found through the tree.
std::vector<std::int32_t> search(const TriangleTree& tree, const TreeBox& box) {
  std::vector<std::int32_t> found;
  std::vector<std::size_t> stack = {0};
  while (!stack.empty()) {
    const std::size_t i = stack.back();
    const TreeNode& node = tree.nodes[i];
    stack.pop_back();
    if (!node.box.overlaps(box)) continue;
    for (std::int32_t k = node.first; k < node.first + node.count; ++k) {
      const std::int32_t triangle = tree.order[static_cast<std::size_t>(k)];
      if (tree.boxes[static_cast<std::size_t>(triangle)].overlaps(box)) found.push_back(triangle);
    }
    if (node.count > 0) continue;
    stack.push_back(static_cast<std::size_t>(node.right));
    stack.push_back(i + 1);
  }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(TreeBox, KnowsTheDistanceOfAPoint) {
  const TreeBox box{{-1, -2, -3}, {1, 2, 3}};
  EXPECT_EQ(squared_distance(box, {0.5, -1.5, 3}), 0.0);
  EXPECT_EQ(squared_distance(box, {4, 0, 0}), 9.0);
  EXPECT_EQ(squared_distance(box, {4, -6, 15}), 9.0 + 16.0 + 144.0);
}

TEST(TriangleTree, FindsWhatALoopFinds) {
  const TriangleMesh mesh = make_ball(1.0, 6);
  std::vector<std::int32_t> every(mesh.triangles.size());
  std::iota(every.begin(), every.end(), 0);
  const TriangleTree tree = build_triangle_tree(mesh, every);
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const Vec3 low = random.in_cube(1.0);
    const TreeBox box{low, low + Vec3::Constant(random.uniform(0.0, 0.5))};
    std::vector<std::int32_t> expected;
    for (const std::int32_t t : every)
      if (tree.boxes[static_cast<std::size_t>(t)].overlaps(box)) expected.push_back(t);
    ASSERT_EQ(search(tree, box), expected);
  }
}

TEST(TriangleTree, HoldsOnlyTheTrianglesItWasGiven) {
  const TriangleMesh mesh = make_ball(1.0, 3);
  const TriangleTree tree = build_triangle_tree(mesh, {4, 2, 9});
  EXPECT_EQ(search(tree, {Vec3::Constant(-2.0), Vec3::Constant(2.0)}),
            (std::vector<std::int32_t>{2, 4, 9}));
}

}  // namespace
}  // namespace thigma
