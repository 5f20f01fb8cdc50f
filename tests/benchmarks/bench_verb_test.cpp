// `thigma bench`: rows as scripts read them.

#include <set>

#include "apps/program.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

void expect_figure(const nlohmann::json& figure, const std::string& row) {
  for (const char* key : {"p50", "p99", "p999", "max"}) ASSERT_TRUE(figure.contains(key)) << row;
  EXPECT_GT(figure["p50"].get<double>(), 0.0) << row;
  EXPECT_GE(figure["p99"].get<double>(), figure["p50"].get<double>()) << row;
}

TEST(BenchVerb, RowsCarryTimesBaselinesRecallAndError) {
  const Ended e = run_program(
      {"bench", "--quick", "--json", "--filter", "^(levels-cup-spoon|haptic-step)$"}, 300.0);
  ASSERT_EQ(e.code, 0) << e.err;
  const std::vector<nlohmann::json> lines = json_lines(e);
  ASSERT_GT(lines.size(), 4u);
  EXPECT_EQ(lines[0]["name"], "machine");
  EXPECT_GT(lines[0]["dependent_adds_ghz"].get<double>(), 0.0);
  EXPECT_TRUE(lines[0]["empty_loop_late_us"].contains("p999"));
  std::set<std::string> baselines;
  bool has_exact = false, says_absent = false;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const nlohmann::json& row = lines[i];
    const std::string name = row["name"];
    expect_figure(row["ours"], name);
    const double scale = row["dependent_adds_ghz"].get<double>() / 3.56;
    EXPECT_NEAR(row["ours_at_3_56_ghz"]["p50"].get<double>(),
                scale * row["ours"]["p50"].get<double>(),
                1e-6 * scale * row["ours"]["p50"].get<double>());
    if (name.rfind("cup-spoon", 0) != 0) continue;
    ASSERT_TRUE(row["baseline"].is_object()) << name;
    expect_figure(row["baseline"], name);
    baselines.insert(row["baseline"]["name"].get<std::string>());
    for (const char* key : {"recall_ours", "recall_baseline", "error_ours", "error_baseline"}) {
      ASSERT_TRUE(row[key].is_number()) << name << " " << key;
      EXPECT_GE(row[key].get<double>(), 0.0);
    }
    EXPECT_LE(row["recall_baseline"].get<double>(), 1.0);
    EXPECT_NEAR(row["ratio"].get<double>(),
                row["baseline"]["p50"].get<double>() / row["ours"]["p50"].get<double>(),
                1e-6 * row["ratio"].get<double>());
    says_absent =
        says_absent || row["note"].get<std::string>().find("built without") != std::string::npos;
    if (name.find("exact") != std::string::npos) {
      has_exact = true;
      EXPECT_EQ(row["recall_ours"].get<double>(), 1.0);
      EXPECT_LT(row["error_ours"].get<double>(), 1e-9);
    }
  }
  EXPECT_TRUE(has_exact);
  EXPECT_TRUE(baselines.size() == 3 || says_absent) << "a baseline is missing without a word";
}

TEST(BenchVerb, SaysWhatItLeavesOut) {
  const Ended e = run_program({"bench", "--filter", "no such row"});
  EXPECT_EQ(e.code, 2);
  EXPECT_NE(e.err.find("levels-conforming-1m"), std::string::npos) << e.err;
}

TEST(BenchVerb, MeasuresAConstrainedSessionOfAnyScene) {
  const std::string scene =
      write_text("bench_boxes.toml",
                 "[object]\nmesh = \"procedural:box\"\nposition = [0.0, 0.0, 0.05]\n"
                 "[[static]]\nmesh = \"procedural:box\"\n");
  const Ended e = run_program({"bench", "--quick", "--json", "--scene", scene}, 300.0);
  ASSERT_EQ(e.code, 0) << e.err;
  const std::vector<nlohmann::json> lines = json_lines(e);
  ASSERT_EQ(lines.size(), 7u);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const nlohmann::json& row = lines[i];
    const std::string name = row["name"];
    expect_figure(row["ours"], name);
    expect_figure(row["baseline"], name);
    if (name.find("exact") == std::string::npos) continue;
    EXPECT_GT(row["contacts_ours"].get<double>(), 0.0) << name;
    EXPECT_GT(row["force_error_baseline"].get<double>(), 0.0) << name << ": nothing is felt";
    EXPECT_EQ(row["force_error_ours"].get<double>(), 0.0) << name;
    EXPECT_LT(row["entered_ours"].get<double>(), 1e-9) << name;
  }
}

TEST(BenchVerb, NamesScenesThatItCannotMeasure) {
  const std::string alone = write_text("bench_alone.toml", "[object]\nmesh = \"procedural:box\"\n");
  const std::pair<std::string, const char*> scenes[] = {{"no such scene", "no such file"},
                                                        {"spoon_in_cup", "nobody holds"},
                                                        {"plate", "relief"},
                                                        {alone, "0 static objects"}};
  for (const auto& [scene, words] : scenes) {
    // Before anything is measured.
    const Ended e =
        run_program({"bench", "--quick", "--json", "--scene", "jaws", "--scene", scene});
    EXPECT_EQ(e.code, 4) << scene << ": " << e.err;
    EXPECT_TRUE(e.out.empty()) << scene;
    EXPECT_NE(e.err.find(words), std::string::npos) << e.err;
  }
  EXPECT_EQ(run_program({"bench", "--scene", "jaws", "--full"}).code, 2);
}

}  // namespace
}  // namespace thigma::test
