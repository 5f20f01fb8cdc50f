#include "experiments/common/assets.h"

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"

namespace thigma::experiments {
namespace {

const std::string kSmall = model_uri("ellipsoid", 500);

TEST(Assets, AskForWhatIsKeptOnce) {
  int asked = 0;
  Assets assets{.kept = [&](const std::string& uri) {
    ++asked;
    return build_exact_hierarchy(make_mesh(uri));
  }};
  const ClodHierarchy& levels = levels_of(assets, kSmall);
  EXPECT_EQ(&levels_of(assets, kSmall), &levels);
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(assets.seconds.empty());
}

TEST(Assets, AreBuiltAndTimedWhereNobodyKeepsThem) {
  Assets assets;
  const ClodHierarchy& levels = levels_of(assets, kSmall);
  EXPECT_GT(levels.levels.size(), 1u);
  EXPECT_GT(assets.seconds.at(kSmall), 0.0);
}

TEST(Assets, AreBuiltForTheirTimeThoughTheyAreKept) {
  int asked = 0;
  Assets assets{.kept = [&](const std::string& uri) {
    ++asked;
    return build_exact_hierarchy(make_mesh(uri));
  }};
  timed_levels_of(assets, kSmall);
  EXPECT_EQ(asked, 0);
  EXPECT_GT(assets.seconds.at(kSmall), 0.0);
}

}  // namespace
}  // namespace thigma::experiments
