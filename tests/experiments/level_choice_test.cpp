#include <cmath>

#include "experiments/level-choice/contact_area.h"
#include "experiments/level-choice/resample.h"
#include "experiments/level-choice/tables.h"
#include <gtest/gtest.h>

namespace thigma::experiments::level_choice {
namespace {

TEST(LevelChoice, RegionsAreTouchedPatchesThatHangTogether) {
  TreeRanges tree;
  tree.area = {1.0, 2.0, 4.0, 8.0};
  const PatchCorners row{{{0, 1}, {1, 2}, {2, 3}, {4, 5}}, 6};  // three in a row, one apart
  EXPECT_EQ(region_areas(row, tree, {0, 1, 3, 0}), (std::vector<double>{3.0, 3.0, 8.0, 3.0}));
  EXPECT_EQ(region_areas(row, tree, {0, 2}),
            (std::vector<double>{1.0, 4.0}));  // the middle one is missing
  EXPECT_EQ(region_areas(row, tree, {2, 0, 1}), (std::vector<double>{7.0, 7.0, 7.0}));
}

TEST(LevelChoice, GrowthHasAnIntervalAsWideAsPosesDiffer) {
  const PoseShare from{{1.0, 2.0, 3.0, 4.0}, {1.0, 1.0, 1.0, 1.0}};
  PoseShare to{{4.0, 8.0, 12.0, 16.0}, from.under};
  const Growth same = growth_between(from, to, true, 1);
  EXPECT_DOUBLE_EQ(same.value, 2.0);
  EXPECT_DOUBLE_EQ(same.low, 2.0);
  EXPECT_DOUBLE_EQ(same.high, 2.0);
  to.over = {0.1, 8.0, 1.0, 16.0};
  const Growth other = growth_between(from, to, false, 1),
               again = growth_between(from, to, false, 1);
  EXPECT_DOUBLE_EQ(other.value, 2.51);
  EXPECT_LT(other.low, 2.0);
  EXPECT_GT(other.high, 3.0);
  EXPECT_EQ(other.low, again.low);
  EXPECT_TRUE(std::isnan(growth_between({}, {}, false, 1).low));
}

TEST(LevelChoice, OnePoseUnlikeTheOthersIsNoSpread) {
  // Seven poses with one region of much the same size, one with hardly any.
  std::vector<std::vector<double>> areas(8, std::vector<double>{1.0, 1.1, 1.2, 1.3, 1.4});
  areas[3] = {0.01, 0.01, 0.01, 0.01, 0.01};
  const Growth one = spread_of(areas, 1);
  EXPECT_GT(one.value, 10.0);
  EXPECT_LT(one.low, 2.0);
  // Small and large in every pose.
  for (std::vector<double>& pose : areas) pose = {0.1, 0.1, 0.5, 1.0, 1.0};
  const Growth all = spread_of(areas, 1);
  EXPECT_DOUBLE_EQ(all.low, 10.0);
  EXPECT_DOUBLE_EQ(all.value, 10.0);
  EXPECT_TRUE(std::isnan(spread_of({}, 1).value));
}

/// Claims on area of a pair whose rank by region is 0.77.
std::vector<Claim> area_claims(const Growth& spread) {
  Studied pair;
  pair.name = "pair";
  for (const double s0 : {0.0, 0.01, 0.025, 0.05, kNoMetric}) {
    pair.settings.push_back(setting_at(s0));
    pair.study.choices.emplace_back();
  }
  pair.study.ranks.push_back({"level and region, region in place of D", 0.77, 800.0});
  pair.study.region_spread = spread;
  std::vector<Claim> claims;
  for (const Claim& claim : claims_of(pair))
    if (claim.id.rfind("area", 0) == 0) claims.push_back(claim);
  return claims;
}

TEST(LevelChoice, RankByRegionStaysListedWhereOnePoseMakesTheSpread) {
  const std::vector<Claim> one = area_claims({142.0, 1.1, 440.0});
  ASSERT_EQ(one.size(), 2u);
  EXPECT_EQ(one[1].id, "area-by-region-pair");
  EXPECT_EQ(one[1].kind, ClaimKind::not_reproduced);
  EXPECT_FALSE(is_broken(one[1]));
  EXPECT_NE(one[1].reason.find("142"), std::string::npos) << one[1].reason;
  EXPECT_TRUE(is_broken(with_value(one[1], 0.59)));
  const std::vector<Claim> all = area_claims({7.1, 6.4, 20.0});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(is_broken(all[1]));
  const std::vector<Claim> none = area_claims({1.5, 1.1, 2.2});
  ASSERT_EQ(none.size(), 1u);
  EXPECT_EQ(none[0].kind, ClaimKind::stated);
}

TEST(LevelChoice, SpreadThatIsNoNumberBreaks) {
  const double nan = std::nan("");
  for (const Growth& spread : {Growth{nan, nan, nan}, Growth{1.5, nan, nan}}) {
    const std::vector<Claim> claims = area_claims(spread);
    ASSERT_EQ(claims.size(), 1u);
    EXPECT_TRUE(is_broken(claims[0]));
  }
}

TEST(LevelChoice, RanksSeeTheWeightOfABlend) {
  // Two contacts and, of next to no weight, what a blend reports below the coarser one at the same
  // place.
  AreaSamples blended{.level = {1.0, 3.0, 0.0},
                      .weight = {1.0, 1.0, 1e-9},
                      .below = {1.0, 2.0, 3.0},
                      .region = {1.0, 2.0, 2.0},
                      .support = {1.0, 2.0, 2.0},
                      .region_by_pose = {}};
  AreaSamples single{.level = {1.0, 3.0},
                     .weight = {1.0, 1.0},
                     .below = {1.0, 2.0},
                     .region = {1.0, 2.0},
                     .support = {1.0, 2.0},
                     .region_by_pose = {}};
  for (const AreaRank& r : area_ranks({blended, single, single, single})) {
    if (r.what == "level and area below")
      EXPECT_LT(r.rank, 0.0);
    else
      EXPECT_NEAR(r.rank, 1.0, 1e-6) << r.what;
  }
  EXPECT_NEAR(commonest_level(blended), 0.5, 1e-6);
}

}  // namespace
}  // namespace thigma::experiments::level_choice
