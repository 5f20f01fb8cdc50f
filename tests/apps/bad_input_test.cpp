// Bad files of every kind through `inspect` and `run`. Prints a table and leaves it as
// bad_input.txt beside the build.

#include <cmath>
#include <cstdio>
#include <fstream>

#include "apps/bad_files.h"
#include "apps/program.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

/// What is printed when all are done.
class Table : public ::testing::Environment {
 public:
  static std::string& rows() {
    static std::string text;
    return text;
  }
  void TearDown() override {
    if (rows().empty()) return;
    char head[200];
    std::snprintf(head, sizeof head, "%-20s %-22s %-13s %4s %6s %6s  %s\n", "kind", "file", "verb",
                  "exit", "MiB", "s", "message or result");
    const std::string table = head + rows();
    std::printf("%s", table.c_str());
    std::ofstream(THIGMA_BINARY_DIR "/bad_input.txt") << table;
  }
};

const auto* const table = ::testing::AddGlobalTestEnvironment(new Table);

void add_row(const std::string& kind, const std::string& file, const char* verb, const Ended& e,
             std::string text) {
  // The folder of the test tells nothing.
  const std::string folder = work_folder().string() + "/";
  for (std::size_t at; (at = text.find(folder)) != std::string::npos;)
    text.erase(at, folder.size());
  while (!text.empty() && text.back() == '\n') text.pop_back();
  char row[120];
  std::snprintf(row, sizeof row, "%-20s %-22s %-13s %4d %6.0f %6.2f  ", kind.c_str(), file.c_str(),
                verb, e.code, e.peak_mib, e.seconds);
  Table::rows() += row + text + "\n";
}

/// Holds for every end: no crash, no hang, bounded memory; refused with one line that names the
/// file.
void expect_orderly(const Ended& e, const std::string& path) {
  EXPECT_EQ(e.signal, 0) << e.err;
  EXPECT_FALSE(e.timed_out);
  EXPECT_TRUE(e.code == 0 || e.code == 4) << e.code << ": " << e.err;
  EXPECT_LT(e.peak_mib, kMostMib);
  if (e.code == 4) {
    expect_one_line(e, path + ": ");
    EXPECT_LT(e.err.size(), 400 + path.size());
    EXPECT_EQ(e.err.find("terminate"), std::string::npos);
  }
}

std::string summary(const Ended& e) {
  if (e.code != 0) return e.err;
  const nlohmann::json json = nlohmann::json::parse(e.out, nullptr, false);
  if (!json.is_object()) return "no JSON: " + e.out;
  if (json.contains("verdict")) {
    std::string text = json["verdict"].get<std::string>();
    for (const auto& reason : json["reasons"]) text += "; " + reason.get<std::string>();
    return text;
  }
  char text[160];
  std::snprintf(text, sizeof text, "force.max %.3g N, penetration_max %.3g m, %zu safety events",
                json["force"]["max"].get<double>(), json["penetration_max"].get<double>(),
                json["safety_events"].size());
  return text;
}

Ended run_mesh(const BadMesh& bad, const std::string& path, bool is_repair) {
  // A second: the hand comes near, touches and presses. Needles stand tip on tip first, and slip
  // off. Damaged files only have to start.
  const char* pressing = bad.name == "needle.obj" ? "4" : "1";
  const char* duration = bad.due == Due::result || is_repair ? pressing : "0.1";
  std::vector<std::string> arguments = {
      "run",    "--object",   path,     "--against", path,      "--lockstep", "--duration",
      duration, "--headless", "--json", "--quiet",   "--scale", "1"};  // of any size
  if (is_repair) arguments.push_back("--repair");
  const Ended e = run_program(arguments);
  add_row(bad.kind, bad.name, is_repair ? "run --repair" : "run", e, summary(e));
  expect_orderly(e, path);
  return e;
}

void expect_felt(const Ended& e) {
  ASSERT_EQ(e.code, 0) << e.err;
  const nlohmann::json json = json_line(e);
  EXPECT_GT(json["force"]["max"].get<double>(), 0.1);
  EXPECT_LT(json["force"]["max"].get<double>(), 20.0);
  EXPECT_TRUE(json["safety_events"].empty());
}

/// What `inspect` names as the way on leads to something that can be touched, and says how far it
/// is from what was given.
void expect_way_on(const BadMesh& bad, const std::string& path, const Ended& inspected) {
  const nlohmann::json report = nlohmann::json::parse(inspected.out, nullptr, false);
  if (!report.is_object() || report["ways_on"].empty()) return;
  EXPECT_EQ(report["ways_on"].back(), "repair --shell");
  EXPECT_NE(inspected.err.find("`thigma repair --"), std::string::npos) << inspected.err;
  const std::string wrapped = out_file(bad.name + ".wrapped.ply");
  const Ended e = run_program({"repair", path, "--wrap", "0.15", "-o", wrapped, "--quiet"});
  add_row(bad.kind, bad.name, "repair --wrap", e, summary(e));
  ASSERT_EQ(e.code, 0) << e.err;
  const nlohmann::json said = json_line(e);
  EXPECT_EQ(said["verdict"], "usable");
  EXPECT_EQ(said["self_intersections"], 0);
  EXPECT_TRUE(said["closed"]);
  EXPECT_GT(said["shell"]["to_mesh"]["bound"].get<double>(), 0.0);
  EXPECT_GT(said["shell"]["from_mesh"]["bound"].get<double>(), 0.0);
  const Ended ran =
      run_program({"run", "--object", wrapped, "--against", wrapped, "--lockstep", "--exact",
                   "--duration", "1", "--headless", "--quiet", "--scale", "1"});
  ASSERT_EQ(ran.code, 0) << ran.err;
  const nlohmann::json felt = json_line(ran);
  EXPECT_GT(felt["force"]["max"].get<double>(), 0.0) << "touched within the second";
  EXPECT_LT(felt["force"]["max"].get<double>(), 20.0);
  EXPECT_TRUE(felt["safety_events"].empty());
}

class BadMeshes : public ::testing::TestWithParam<BadMesh> {};

TEST_P(BadMeshes, end_in_order) {
  const BadMesh& bad = GetParam();
  const std::string path = write_text(bad.name, bad.bytes);
  const Ended inspected = run_program({"inspect", path, "--json"});
  add_row(bad.kind, bad.name, "inspect", inspected, summary(inspected));
  expect_orderly(inspected, path);
  const Ended ran = run_mesh(bad, path, false);
  switch (bad.due) {
    case Due::refusal:
      EXPECT_EQ(inspected.code, 4);
      EXPECT_EQ(ran.code, 4);
      EXPECT_NE(inspected.err.find(bad.says), std::string::npos) << inspected.err;
      EXPECT_NE(ran.err.find(bad.says), std::string::npos) << ran.err;
      expect_way_on(bad, path, inspected);
      break;
    case Due::repair:
      EXPECT_EQ(json_line(inspected)["verdict"], "repairable");
      EXPECT_EQ(ran.code, 4);
      EXPECT_NE(ran.err.find("--repair"), std::string::npos) << ran.err;
      expect_felt(run_mesh(bad, path, true));
      break;
    case Due::result:
      EXPECT_EQ(json_line(inspected)["verdict"], "usable");
      expect_felt(ran);
      break;
    case Due::either:
      // The two verbs agree on what a file is.
      if (inspected.code == 4) {
        EXPECT_EQ(ran.code, 4);
      } else {
        EXPECT_EQ(ran.code, json_line(inspected)["verdict"] == "usable" ? 0 : 4);
      }
      break;
  }
}

std::string test_name(std::string name) {
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(BadInput, BadMeshes, ::testing::ValuesIn(bad_meshes()),
                         [](const auto& each) { return test_name(each.param.name); });

class BadScenes : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, are_refused) {
  const BadScene& bad = GetParam();
  const std::string path = write_text(bad.name, bad.bytes);
  const Ended e =
      run_program({"run", path, "--lockstep", "--duration", "0.1", "--json", "--quiet"});
  add_row(bad.kind, bad.name, "run", e, summary(e));
  expect_orderly(e, path);
  EXPECT_EQ(e.code, 4);
  EXPECT_NE(e.err.find(bad.says), std::string::npos) << e.err;
  EXPECT_TRUE(e.out.empty()) << e.out;
}

INSTANTIATE_TEST_SUITE_P(BadInput, BadScenes, ::testing::ValuesIn(bad_scenes()),
                         [](const auto& each) { return test_name(each.param.name); });

TEST(BadInput, no_file_is_no_file) {
  for (const char* path : {"/dev/zero", "/", "nowhere.obj"}) {
    const Ended e = run_program({"inspect", path});
    add_row("no file", path, "inspect", e, summary(e));
    expect_orderly(e, path);
    EXPECT_EQ(e.code, 4);
  }
  for (const char* path : {"/", "nowhere.toml"}) {
    const Ended e = run_program({"run", path, "--lockstep", "--duration", "0.1", "--quiet"});
    add_row("no file", path, "run", e, summary(e));
    expect_orderly(e, path);
    EXPECT_EQ(e.code, 4);
  }
}

}  // namespace
}  // namespace thigma::test
