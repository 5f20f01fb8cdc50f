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

// Whether the claims hold is said by the exit code and by claims.json alike; a test of the engine's
// numbers it is not.
TEST(ExperimentVerb, writes_data_plot_and_claims_and_says_whether_they_hold) {
  const std::filesystem::path folder = work_folder() / "out";
  const Ended ended = run_program(
      {"experiment", "fig-5-6", "--quick", "--quiet", "--json", "-o", folder.string()}, 900.0);
  const nlohmann::json claims =
      nlohmann::json::parse(read_text(folder / "fig-5-6" / "claims.json"));
  expect_claims_schema(claims, "fig-5-6");
  EXPECT_EQ(json_line(ended), claims);
  std::set<std::string> ids;
  int broken = 0;
  for (const nlohmann::json& claim : claims.at("claims")) {
    ids.insert(claim.at("id"));
    broken += !claim.at("holds").get<bool>() && claim.at("expected").get<bool>() ? 1 : 0;
  }
  for (const char* id : {"forward-euler", "runge-kutta", "backward-euler", "ratio"})
    EXPECT_TRUE(ids.count(id)) << id;
  EXPECT_EQ(claims.at("counts").at("broken"), broken);
  EXPECT_EQ(ended.code, broken > 0 ? 5 : 0) << ended.err;
  EXPECT_EQ(read_text(folder / "fig-5-6" / "fig-5-6.png").substr(1, 3), "PNG");
  EXPECT_GT(read_text(folder / "fig-5-6" / "data.csv").size(), 200u);
}

TEST(ExperimentVerb, tells_the_claims_of_a_folder) {
  const Ended nowhere = run_program({"experiment", "claims"});
  EXPECT_EQ(nowhere.code, 2);
  const Ended ended = run_program({"experiment", "claims", "-o", work_folder().string()});
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.out.find("0 claims: 0 checked"), std::string::npos) << ended.out;
  EXPECT_NE(ended.out.find("Not run: table-3-2,"), std::string::npos) << ended.out;
}

TEST(ExperimentVerb, says_how_many_claims_are_of_which_kind) {
  const Ended ended = run_program(
      {"experiment", "fig-5-6", "--quiet", "--text", "-o", (work_folder() / "kinds").string()});
  EXPECT_NE(ended.out.find("9 claims: 5 checked, 4 stated, 0 not reproduced; 0 broken"),
            std::string::npos)
      << ended.out;
  for (std::size_t at = ended.out.find("stated "); at != std::string::npos;
       at = ended.out.find("stated ", at + 1)) {
    const std::size_t end = ended.out.find('\n', at);
    EXPECT_EQ(ended.out.substr(at, end - at).find("holds"), std::string::npos);
  }
}

}  // namespace
}  // namespace thigma::test
