// The verb as a process: names, refusals, and one real run with its files.

#include <set>

#include "apps/program.h"
#include "experiments/claims_schema.h"
#include "experiments/common/experiment.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

TEST(ExperimentVerb, lists_what_there_is) {
  const Ended ended = run_program({"experiment", "list", "--json"});
  EXPECT_EQ(ended.code, 0);
  std::set<std::string> names;
  for (const nlohmann::json& line : json_lines(ended)) names.insert(line.at("name"));
  EXPECT_EQ(names.size(), experiments::all_experiments().size());
  EXPECT_TRUE(names.count("fig-3-15"));
}

TEST(ExperimentVerb, refuses_names_and_folders_it_does_not_have) {
  const Ended unknown = run_program({"experiment", "fig-3-51", "-o", work_folder().string()});
  EXPECT_EQ(unknown.code, 2);
  expect_one_line(unknown, "experiment: no experiment 'fig-3-51', nearest is 'fig-3-15'");
  const Ended nowhere = run_program({"experiment", "fig-3-15"});
  EXPECT_EQ(nowhere.code, 2);
  expect_one_line(nowhere, "experiment: -o DIR is missing");
  const Ended blocked =
      run_program({"experiment", "fig-3-15", "-o", write_text("a_file", "x"), "--quiet"});
  EXPECT_EQ(blocked.code, 1);
}

// Whether the claims hold is said by the exit code and by claims.json alike; a test of the engine's numbers it is not.
TEST(ExperimentVerb, writes_data_plot_and_claims_and_says_whether_they_hold) {
  const std::filesystem::path folder = work_folder() / "out";
  const Ended ended = run_program(
      {"experiment", "fig-3-15", "--quick", "--quiet", "--json", "-o", folder.string()}, 900.0);
  const nlohmann::json claims =
      nlohmann::json::parse(read_text(folder / "fig-3-15" / "claims.json"));
  expect_claims_schema(claims, "fig-3-15");
  EXPECT_EQ(json_line(ended), claims);
  std::set<std::string> ids;
  bool is_broken = false;
  for (const nlohmann::json& claim : claims.at("claims")) {
    ids.insert(claim.at("id"));
    is_broken = is_broken || (!claim.at("holds").get<bool>() && claim.at("expected").get<bool>());
  }
  for (const char* id : {"profile", "curvature", "front", "time"}) EXPECT_TRUE(ids.count(id)) << id;
  EXPECT_EQ(ended.code, is_broken ? 5 : 0) << ended.err;
  EXPECT_EQ(read_text(folder / "fig-3-15" / "fig-3-15.png").substr(1, 3), "PNG");
  EXPECT_GT(read_text(folder / "fig-3-15" / "data.csv").size(), 10'000u);
}

}  // namespace
}  // namespace thigma::test
