#include "experiments/common/experiment.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "experiments/claims_schema.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::experiments {
namespace {

using Json = nlohmann::json;

std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                       ("thigma_experiment_" + name + std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  return folder;
}

Outcome small_outcome(const Context& context) {
  Outcome outcome;
  outcome.tables = {{.columns = {"x"}}};
  add_row(outcome.tables[0], {context.quick ? 1.0 : 2.0});
  outcome.figure = {.title = "small", .width = 100, .panel_height = 80};
  outcome.claims = {at_least("good", "is large", 3.0, 2.0, "N"),
                    known_not_to(at_most("known", "is small", 3.0, 2.0),
                                 {.reason = "because", .sweep = "data.csv", .floor = 4.0}),
                    within("between", "lies there", 5.0, 1.0, 10.0),
                    stated("said", "only said", std::nan(""))};
  return outcome;
}

TEST(Experiments, WriteDataPlotAndClaims) {
  const std::filesystem::path folder = fresh_folder("files");
  const Experiment experiment{"small-one", "Fig. 0", "a small one", small_outcome};
  run_experiment(experiment, {.quick = true}, folder);
  EXPECT_EQ(read_file((folder / "small-one" / "data.csv").string()), "x\n1\n");
  EXPECT_EQ(read_file((folder / "small-one" / "small-one.png").string()).substr(1, 3), "PNG");
  const Json claims = Json::parse(read_file((folder / "small-one" / "claims.json").string()));
  test::expect_claims_schema(claims, "small-one");
  EXPECT_EQ(claims["claims"][0]["value"], 3.0);
  EXPECT_EQ(claims["claims"][0]["bound"], 2.0);
  EXPECT_EQ(claims["claims"][0]["kind"], "checked");
  EXPECT_EQ(claims["claims"][1]["expected"], false);
  EXPECT_EQ(claims["claims"][1]["kind"], "not reproduced");
  EXPECT_EQ(claims["claims"][1]["floor"], 4.0);
  EXPECT_EQ(claims["claims"][3]["kind"], "stated");
  EXPECT_EQ(claims["counts"],
            Json::parse(R"({"checked": 2, "stated": 1, "not_reproduced": 1, "broken": 1})"));
  EXPECT_EQ(claims["claims"][2]["bound_low"], 1.0);
  EXPECT_TRUE(claims["claims"][3]["value"].is_null());
  const Json run = Json::parse(read_file((folder / "small-one" / "run.json").string()));
  EXPECT_EQ(run["quick"], true);
  EXPECT_GT(run["dependent_adds_ghz"].get<double>(), 0.0);
  std::filesystem::remove_all(folder);
}

TEST(Experiments, LeaveNoClaimsOfAnEarlierRunBehind) {
  const std::filesystem::path folder = fresh_folder("stale");
  run_experiment({"one", "", "", small_outcome}, {}, folder);
  ASSERT_TRUE(std::filesystem::exists(folder / "one" / "claims.json"));
  const auto fails = [](const Context&) -> Outcome { throw InputError("no"); };
  EXPECT_THROW(run_experiment({"one", "", "", fails}, {}, folder), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "one" / "claims.json"));
  std::filesystem::remove_all(folder);
}

TEST(Experiments, RefuseAFolderThatIsAFile) {
  const std::filesystem::path folder = fresh_folder("file");
  write_file(folder.string(), "x");
  EXPECT_THROW(run_experiment({"one", "", "", small_outcome}, {}, folder), IoError);
  std::filesystem::remove_all(folder);
}

TEST(Experiments, AreThoseOfTheInterface) {
  std::set<std::string> names;
  for (const Experiment& e : all_experiments()) EXPECT_TRUE(names.insert(e.name).second) << e.name;
  for (const char* name : {"table-3-2", "table-3-3", "fig-3-15", "fig-3-16", "e1-static-queries",
                           "e8-lod-error", "e14-degradation", "e16-scaling"}) {
    EXPECT_TRUE(names.count(name)) << name;
  }
  for (const std::string& name : names) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(THIGMA_SOURCE_DIR) / "experiments" /
                                        name / "README.md"))
        << name;
  }
}

}  // namespace
}  // namespace thigma::experiments
