// The experiments of Chapter 5 and of the stability laboratory, --quick: claims that are expected to hold do.

#include "experiments/common/all_experiments.h"
#include <gtest/gtest.h>

namespace thigma::experiments {
namespace {

class FeelExperiment : public testing::TestWithParam<const char*> {};

TEST_P(FeelExperiment, holds_what_it_claims) {
  const auto& all = all_experiments();
  const auto found = std::find_if(all.begin(), all.end(), [](const Experiment& e) {
    return std::string_view(e.name) == GetParam();
  });
  ASSERT_NE(found, all.end());
  Assets assets;
  const Outcome outcome = found->run({.quick = true, .assets = &assets});
  ASSERT_FALSE(outcome.tables.empty());
  EXPECT_FALSE(outcome.tables[0].rows.empty());
  EXPECT_FALSE(outcome.claims.empty());
  for (const Claim& claim : outcome.claims) {
    EXPECT_FALSE(is_broken(claim))
        << claim.id << ": " << claim.text << ", " << claim.value.value_or(0.0) << " against "
        << claim.bound.value_or(0.0);
    EXPECT_TRUE(claim.expected || !claim.reason.empty()) << claim.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Quick, FeelExperiment,
                         testing::Values("fig-5-4", "fig-5-6", "fig-5-8", "fig-5-10",
                                         "e2-force-quality", "e3-z-width", "e4-passivity",
                                         "e5-free-space", "e6-impact", "e13-real-time",
                                         "force-steps", "gains"),
                         [](const testing::TestParamInfo<const char*>& each) {
                           std::string name = each.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace thigma::experiments
