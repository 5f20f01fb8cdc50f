#include "thigma/mesh/box_tree.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma::detail {
namespace {

TreeBox random_box(Random& random, double size) {
  const Vec3 at = random.in_cube(1.0);
  return {at, at + Vec3::Constant(size) + random.in_cube(0.5 * size)};
}

TEST(BoxTree, FindsWhatALoopFindsWhileBoxesChange) {
  Random random(31);
  std::vector<TreeBox> boxes;
  std::vector<bool> is_there(200, true);
  for (int i = 0; i < 200; ++i) boxes.push_back(random_box(random, 0.2));
  BoxTree tree;
  tree.build(boxes);
  for (int step = 0; step < 2000; ++step) {
    const auto leaf = static_cast<std::size_t>(random.below(boxes.size()));
    if (is_there[leaf]) {
      if (random.uniform() < 0.05) {
        tree.remove(static_cast<std::int32_t>(leaf));
        is_there[leaf] = false;
      } else {
        boxes[leaf] = random_box(random, random.uniform(0.01, 0.5));
        tree.update(static_cast<std::int32_t>(leaf), boxes[leaf]);
      }
    }
    const TreeBox asked = random_box(random, 0.3);
    std::vector<std::int32_t> found, expected;
    tree.visit(asked, [&](std::int32_t i) {
      EXPECT_TRUE(is_there[static_cast<std::size_t>(i)]);
      if (boxes[static_cast<std::size_t>(i)].overlaps(asked)) found.push_back(i);
    });
    std::sort(found.begin(), found.end());
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (is_there[i] && boxes[i].overlaps(asked)) expected.push_back(static_cast<std::int32_t>(i));
    ASSERT_EQ(found, expected);
  }
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (is_there[i]) tree.remove(static_cast<std::int32_t>(i));
  tree.visit({Vec3::Constant(-9), Vec3::Constant(9)}, [](std::int32_t) { FAIL(); });
}

}  // namespace
}  // namespace thigma::detail
