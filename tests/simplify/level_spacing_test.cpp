#include "thigma/simplify/level_spacing.h"

#include <vector>

#include <gtest/gtest.h>

#include "thigma/simplify/simplify_surface.h"

namespace thigma {
namespace {

/// Levels of these numbers of patches; parent of a patch is its number times the ratio, so that
/// ancestors are known.
std::vector<SimplifiedLevel> make_levels(const std::vector<int>& counts) {
  std::vector<SimplifiedLevel> levels(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    levels[i].patch_count = counts[i];
    levels[i].resolution = 100.0 - static_cast<double>(i);
    if (i + 1 < counts.size())
      for (int p = 0; p < counts[i]; ++p) levels[i].parent.push_back(p * counts[i + 1] / counts[i]);
  }
  return levels;
}

std::vector<int> drafts(int first, int last) {
  std::vector<int> counts{first};
  while (counts.back() * 84 / 100 > last) counts.push_back(counts.back() * 84 / 100);
  counts.push_back(last);
  return counts;
}

TEST(LevelSpacing, HalvesEvenlyDownToTheLast) {
  for (const int last : {500, 313, 37, 20}) {
    std::vector<SimplifiedLevel> levels = make_levels(drafts(1000, last));
    space_levels(levels);
    ASSERT_GE(levels.size(), 2u);
    EXPECT_EQ(levels.front().patch_count, 1000);
    EXPECT_EQ(levels.back().patch_count, last);
    for (std::size_t i = 1; i < levels.size(); ++i) {
      EXPECT_LE(2 * levels[i].patch_count, levels[i - 1].patch_count);
      EXPECT_GE(4 * levels[i].patch_count, levels[i - 1].patch_count) << "room for one more";
    }
  }
}

TEST(LevelSpacing, KeepsLevelsBetweenWhereTrianglesFallFast) {
  // Triangles fall by a third from draft to draft, patches by a sixth.
  std::vector<SimplifiedLevel> levels = make_levels(drafts(1000, 100));
  double triangles = 100'000.0;
  for (SimplifiedLevel& level : levels) {
    level.mesh.triangles.resize(static_cast<std::size_t>(triangles));
    triangles *= 0.67;
  }
  const auto count = [](const SimplifiedLevel& level) { return level.mesh.triangles.size(); };
  space_levels(levels);
  ASSERT_GE(levels.size(), 6u);
  int kept_for_triangles = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    kept_for_triangles += 2 * levels[i].patch_count > levels[i - 1].patch_count;
    EXPECT_TRUE(2 * levels[i].patch_count <= levels[i - 1].patch_count ||
                2 * count(levels[i]) <= count(levels[i - 1]))
        << i;
    EXPECT_LT(count(levels[i - 1]), 5 * count(levels[i])) << i;
    for (const std::int32_t parent : levels[i - 1].parent) EXPECT_LT(parent, levels[i].patch_count);
  }
  EXPECT_GT(kept_for_triangles, 0);
}

TEST(LevelSpacing, LeadsParentsPastWhatIsDropped) {
  const std::vector<SimplifiedLevel> all = make_levels(drafts(1000, 30));
  std::vector<SimplifiedLevel> levels = all;
  space_levels(levels);
  ASSERT_LT(levels.size(), all.size());
  for (std::int32_t p = 0; p < 1000; ++p) {
    std::int32_t by_all = p, by_kept = p;
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
      by_all = all[i].parent[static_cast<std::size_t>(by_all)];
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
      by_kept = levels[i].parent[static_cast<std::size_t>(by_kept)];
    ASSERT_EQ(by_all, by_kept);
  }
}

TEST(LevelSpacing, KeepsNoLevelThatDidNotHalve) {
  std::vector<SimplifiedLevel> levels = make_levels({100, 80, 60});
  space_levels(levels);
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_TRUE(levels[0].parent.empty());
}

TEST(LevelSpacing, KeepsNoLevelAsCoarseAsTheNext) {
  std::vector<SimplifiedLevel> levels = make_levels({100, 50, 40, 20});
  levels[1].resolution = levels[2].resolution = levels[3].resolution = 50.0;
  space_levels(levels);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[1].patch_count, 20);
}

TEST(LevelSpacing, KeepsTheCoarsestOfEqualResolutions) {
  std::vector<SimplifiedLevel> levels = make_levels({100, 50, 20, 10});
  levels[2].resolution = levels[3].resolution = levels[1].resolution;
  drop_equal_resolutions(levels);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[1].patch_count, 10);
  for (const std::int32_t parent : levels[0].parent) EXPECT_LT(parent, 10);
}

}  // namespace
}  // namespace thigma
