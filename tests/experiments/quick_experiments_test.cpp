// Every experiment, --quick: what it claims holds or is known not to, and a wrong value in any
// claim breaks it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "experiments/claims_schema.h"
#include "experiments/common/experiment.h"
#include "experiments/worse_value.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "thigma/files/file.h"
#include "thigma/scene/asset_cache.h"

namespace thigma::experiments {
namespace {

class QuickExperiment : public testing::TestWithParam<Experiment> {};

ClodHierarchy kept_levels(const std::string& uri) {
  ClodSource source;
  source.name = uri;
  source.params.threads = 1;
  return load_clod_cached(source).hierarchy;
}

/// Runs it into a folder that is removed again.
Outcome run_quick(const Experiment& experiment) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() /
      ("thigma_quick_" + std::string(experiment.name) + std::to_string(::getpid()));
  Assets assets{.kept = kept_levels};
  Outcome outcome = run_experiment(experiment, {.quick = true, .assets = &assets}, folder);
  const auto read = [&](const char* file) {
    return nlohmann::json::parse(read_file((folder / experiment.name / file).string()));
  };
  test::expect_claims_schema(read("claims.json"), experiment.name);
  std::printf("%s: %.1f CPU seconds; %s\n", experiment.name,
              read("run.json").at("cpu_seconds").get<double>(),
              counts_text(count_claims(outcome.claims)).c_str());
  std::filesystem::remove_all(folder);
  return outcome;
}

std::string line_of(const Claim& claim) {
  char numbers[160];
  std::snprintf(numbers, sizeof numbers, " %s: %.6g against %.6g (%.6g), ", verdict(claim),
                claim.value.value_or(std::nan("")), claim.bound.value_or(std::nan("")),
                claim.bound_low.value_or(std::nan("")));
  return claim.id + numbers + claim.text;
}

/// No farther from the value than the value is from its bound, or half of it.
bool is_near(const Claim& claim, double floor) {
  const double allowed =
      std::max(std::fabs(*claim.value - *claim.bound), 0.5 * std::fabs(*claim.value));
  return std::fabs(floor - *claim.value) <= allowed;
}

TEST_P(QuickExperiment, claims_what_holds_and_what_can_break) {
  const Outcome outcome = run_quick(GetParam());
  ASSERT_FALSE(outcome.tables.empty());
  EXPECT_EQ(outcome.tables[0].name, "data");
  EXPECT_FALSE(outcome.tables[0].rows.empty());
  EXPECT_FALSE(outcome.claims.empty());
  EXPECT_EQ(faults(outcome.claims, outcome.tables), std::vector<std::string>{});
  for (const Claim& claim : outcome.claims) {
    if (!claim.is_timed) {
      EXPECT_FALSE(is_broken(claim)) << line_of(claim);
      EXPECT_FALSE(holds_though_marked(claim)) << line_of(claim);
    }
    for (const double wrong : test::worse_values(claim))
      EXPECT_TRUE(is_broken(with_value(claim, wrong))) << line_of(claim) << ", with " << wrong;
    if (claim.kind == ClaimKind::not_reproduced && !claim.is_timed && claim.value)
      EXPECT_TRUE(is_near(claim, *claim.floor) ||
                  (claim.floor_low && is_near(claim, *claim.floor_low)))
          << "floor " << *claim.floor << ": " << line_of(claim);
  }
}

INSTANTIATE_TEST_SUITE_P(Quick, QuickExperiment, testing::ValuesIn(all_experiments()),
                         [](const testing::TestParamInfo<Experiment>& each) {
                           std::string name = each.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace thigma::experiments
