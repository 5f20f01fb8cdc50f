// `thigma build`: what it prints, what it writes, what it refuses; and .clod files as input of
// `contacts`.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/program.h"
#include "support/zero_area.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_file.h"
#include "thigma/files/checksum.h"
#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

const std::string kTorus = "procedural:torus?triangles=3000";

Ended build(const std::string& mesh, const std::string& out,
            const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"build", mesh, "-o", out, "--json", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

/// The torus, built once.
const std::string& torus_file() {
  static const std::string path = [] {
    const std::string out = out_file("shared_torus.clod");
    const Ended e = build(kTorus, out);
    EXPECT_EQ(e.code, 0) << e.err;
    return out;
  }();
  return path;
}

// inspect calls it usable: so it has to build, be read again, and run.
TEST(BuildVerb, BuildsWhatIsUsableThoughTrianglesHaveNoArea) {
  for (const double size : {1e-9, 0.02, 1e3}) {
    TriangleMesh ball = make_ball(1.0, 8);
    for (int i = 0; i < 5; ++i) add_stray(ball, {0.1 * i, 0, 0}, {0.1 * i, 0.5, 0});
    for (int i = 0; i < 5; ++i) flatten(ball, 100 * static_cast<std::size_t>(i) + 7, 0, 0.5);
    for (Vec3& p : ball.positions) p *= size;
    const std::string mesh = write_text("strays.obj", format_mesh(ball, MeshFormat::obj, "strays")),
                      out = out_file("strays.clod");
    EXPECT_EQ(json_line(run_program({"inspect", mesh, "--json"}))["verdict"], "usable");
    const Ended e = build(mesh, out);
    ASSERT_EQ(e.code, 0) << e.err;
    EXPECT_GE(json_line(e)["levels"].size(), 3u);
    if (size != 0.02) continue;
    for (const std::string& held : {mesh, out}) {
      const Ended ran = run_program({"run", "--object", held, "--against", mesh, "--lockstep",
                                     "--headless", "--duration", "0.5", "--quiet", "--no-cache"});
      EXPECT_EQ(ran.code, 0) << ran.err;
    }
  }
}

TEST(BuildVerb, PrintsTheFieldsOfTheInterface) {
  const std::string out = out_file("fields.clod");
  const Ended e = build(kTorus, out);
  ASSERT_EQ(e.code, 0) << e.err;
  EXPECT_TRUE(e.err.empty()) << e.err;
  const nlohmann::json j = json_line(e);
  for (const char* name : {"file", "triangles", "patches", "radius", "levels", "seconds",
                           "peak_bytes", "file_bytes", "sha256"})
    EXPECT_TRUE(j.contains(name)) << name;
  const std::string bytes = read_text(out);
  EXPECT_EQ(j["file"], out);
  EXPECT_EQ(j["file_bytes"], bytes.size());
  EXPECT_EQ(j["sha256"], hex_text(sha256(bytes)));
  EXPECT_GT(j["peak_bytes"].get<double>(), 1e6);
  const auto& levels = j["levels"];
  ASSERT_GT(levels.size(), 3u);
  EXPECT_EQ(levels[0]["triangles"], j["triangles"]);
  EXPECT_EQ(levels[0]["patches"], j["patches"]);
  EXPECT_TRUE(levels[0]["resolution"].is_null()) << "infinite";
  double resolution = 1e300;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    EXPECT_EQ(levels[k]["level"], k);
    if (k == 0) continue;
    EXPECT_LE(levels[k]["patches"], levels[k - 1]["patches"]);
    if (levels[k]["free"]) {
      EXPECT_TRUE(levels[k]["triangles"].is_null());
      EXPECT_TRUE(levels[k]["resolution"].is_null());
      continue;
    }
    EXPECT_LT(levels[k]["resolution"].get<double>(), resolution) << k;
    resolution = levels[k]["resolution"].get<double>();
    EXPECT_GT(levels[k]["deviation_max"].get<double>(), 0.0);
    EXPECT_GT(levels[k]["hausdorff_max"].get<double>(), 0.0);
  }
  EXPECT_TRUE(levels.back()["free"]);
  EXPECT_EQ(levels.back()["patches"], 1);
}

TEST(BuildVerb, WritesTheSameBytesWhateverTheThreads) {
  const std::string first = read_text(torus_file());
  for (const char* threads : {"1", "2", "5"}) {
    const std::string out = out_file("threads.clod");
    ASSERT_EQ(build(kTorus, out, {"--threads", threads}).code, 0);
    EXPECT_TRUE(read_text(out) == first) << threads << " threads";
  }
}

TEST(BuildVerb, TakesMetresPerUnitAndTolerance) {
  const std::string a = out_file("scale_a.clod"), b = out_file("scale_b.clod");
  ASSERT_EQ(build(kTorus, a, {"--scale", "0.25"}).code, 0);
  ClodAsset scaled = read_clod(torus_file(), 0.25);
  EXPECT_EQ(format_clod(scaled), read_text(a));
  // 1 % of the radius is the default.
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", 0.02 * scaled.hierarchy.radius);
  ASSERT_EQ(build(kTorus, b, {"--scale", "0.25", "--contact-tolerance", text}).code, 0);
  EXPECT_NEAR(read_clod(b).origin.contact_tolerance, 0.02, 1e-15);
}

TEST(BuildVerb, RefusesAndLeavesNothing) {
  const std::string out = out_file("never.clod");
  const std::string mesh = write_text("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  const struct {
    std::vector<std::string> arguments;
    int code;
  } wrong[] = {
      {{"build", mesh}, 2},
      {{"build", mesh, "-o", out, "--threads", "0"}, 2},
      {{"build", mesh, "-o", out, "--threads", "many"}, 2},
      {{"build", mesh, "-o", out, "--scale", "-1"}, 2},
      {{"build", mesh, "-o", out, "--scale", "nan"}, 2},
      {{"build", mesh, "-o", out, "--contact-tolerance", "0"}, 2},
      {{"build", mesh, "-o", mesh}, 2},
      {{"build", mesh, "-o", out}, 4},
      {{"build", "nowhere.obj", "-o", out}, 4},
      {{"build", "procedural:tours", "-o", out}, 4},
      {{"build", torus_file(), "-o", out}, 4},
      {{"build", kTorus, "-o", "/no/such/folder/a.clod"}, 1},
      {{"build", kTorus, "-o", work_folder().string()}, 1},
  };
  const std::string before = read_text(mesh);
  for (const auto& w : wrong) {
    std::vector<std::string> arguments = w.arguments;
    arguments.push_back("--quiet");
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, w.code) << e.err;
    expect_one_line(e, "");
    EXPECT_TRUE(e.out.empty());
    EXPECT_FALSE(fs::exists(out));
  }
  EXPECT_EQ(read_text(mesh), before);
  for (const auto& entry : fs::directory_iterator(work_folder()))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
}

TEST(BuildVerb, TellsPeopleWithoutATerminalInPlainLines) {
  const Ended e = run_program({"build", kTorus, "-o", out_file("plain.clod"), "--text"});
  EXPECT_EQ(e.code, 0);
  EXPECT_EQ(e.err.find('\r'), std::string::npos);
  EXPECT_EQ(e.err.find('\x1b'), std::string::npos);
  EXPECT_NE(e.out.find("sha256"), std::string::npos);
}

// ---- as input of contacts
// ------------------------------------------------------------------------------

std::string poses() {
  std::string text = kHeader;
  char row[200];
  for (int i = 0; i < 40; ++i) {
    std::snprintf(row, sizeof row, "0.055,0,%.17g,0,0,%.17g,%.17g\n", 0.034 - 0.0002 * i,
                  std::sin(0.01 * i), std::cos(0.01 * i));
    text += row;
  }
  return write_text("levels_path.csv", text);
}

std::vector<nlohmann::json> contacts(const std::string& object, const std::string& scene,
                                     const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"contacts",    object,   scene,    "--poses", poses(),
                                        "--tolerance", "0.0006", "--json", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Ended e = run_program(arguments);
  EXPECT_EQ(e.code, 0) << e.err;
  return json_lines(e);
}

std::size_t count_contacts(const std::vector<nlohmann::json>& lines) {
  std::size_t count = 0;
  for (const auto& line : lines) count += line["contacts"].size();
  return count;
}

TEST(ContactsOfLevels, AtThresholdZeroAreTheExactOnes) {
  const auto exact = contacts(kTorus, kTorus, {"--exact"});
  ASSERT_EQ(exact.size(), 40u);
  EXPECT_GT(count_contacts(exact), 100u);
  const auto by_default = contacts(kTorus, kTorus);
  const auto of_files = contacts(torus_file(), torus_file(), {"--exact"});
  const auto at_zero = contacts(torus_file(), kTorus, {"--threshold", "0"});
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (const auto* other : {&by_default, &of_files, &at_zero}) {
      EXPECT_EQ((*other)[i]["contacts"], exact[i]["contacts"]) << i;
      EXPECT_EQ((*other)[i]["min_distance"], exact[i]["min_distance"]) << i;
    }
  }
}

TEST(ContactsOfLevels, CarryLevelsAndBounds) {
  const auto exact = contacts(kTorus, kTorus);
  const auto coarse =
      contacts(torus_file(), torus_file(), {"--threshold", "0.05", "--deviation-cap", "off"});
  ASSERT_EQ(coarse.size(), exact.size());
  int with_bound = 0;
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    if (!exact[i]["contacts"].empty()) {
      EXPECT_FALSE(coarse[i]["contacts"].empty()) << i;
    }
    for (const auto& c : coarse[i]["contacts"]) {
      EXPECT_GE(c["bound"].get<double>(), 0.0);
      EXPECT_GE(c["depth"].get<double>(), -0.0006 - c["bound"].get<double>() - 1e-12);
      with_bound += c["bound"].get<double>() > 0.0 &&
                    c["levels"][0].get<int>() + c["levels"][1].get<int>() > 0;
    }
  }
  EXPECT_GT(with_bound, 10);
}

TEST(ContactsOfLevels, StayWithinATestBudget) {
  int left_coarse = 0;
  for (const int budget : {1, 300, 3000}) {
    const auto lines = contacts(torus_file(), torus_file(),
                                {"--threshold", "0.01", "--budget-tests", std::to_string(budget)});
    const auto again = contacts(torus_file(), torus_file(),
                                {"--threshold", "0.01", "--budget-tests", std::to_string(budget)});
    ASSERT_EQ(lines.size(), again.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      EXPECT_EQ(lines[i]["contacts"], again[i]["contacts"]);
      EXPECT_LE(lines[i]["tests"].get<int>(),
                std::max(budget, lines[i]["mandatory_tests"].get<int>()));
      left_coarse += lines[i]["unrefined"].get<int>();
    }
  }
  EXPECT_GT(left_coarse, 0);
}

TEST(ContactsOfLevels, TakeEveryMetric) {
  for (const char* metric :
       {"haptic", "velocity=0.001", "view=1,0.5,0.1,0.2,1080", "haptic+velocity=0.01"}) {
    const auto lines = contacts(torus_file(), torus_file(), {"--metric", metric, "--dt", "0.002"});
    EXPECT_EQ(lines.size(), 40u) << metric;
    EXPECT_GT(count_contacts(lines), 0u) << metric;
  }
}

TEST(ContactsOfLevels, RefuseWrongOptions) {
  const std::string path = poses();
  const std::vector<std::vector<std::string>> wrong = {
      {"--exact", "--threshold", "0.01"},
      {"--exact", "--budget-tests", "100"},
      {"--threshold", "-0.1"},
      {"--threshold", "nan"},
      {"--threshold", "much"},
      {"--deviation-cap", "-1"},
      {"--deviation-cap", "none"},
      {"--budget-us", "0"},
      {"--budget-us", "inf"},
      {"--budget-tests", "0"},
      {"--budget-tests", "2.5"},
      {"--metric", "speed"},
      {"--metric", "velocity"},
      {"--metric", "velocity=-1"},
      {"--metric", "view=1,2,3"},
      {"--dt", "0"},
      {"--dt", "nan"},
  };
  for (const auto& w : wrong) {
    std::vector<std::string> arguments = {"contacts", torus_file(),  torus_file(), "--poses",
                                          path,       "--tolerance", "0.001"};
    arguments.insert(arguments.end(), w.begin(), w.end());
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 2) << w[0] << ' ' << w.back() << ": " << e.err;
    EXPECT_NE(e.err.find(w[0]), std::string::npos) << e.err;
    EXPECT_TRUE(e.out.empty());
  }
}

TEST(ContactsOfLevels, RefuseBadClodFiles) {
  const std::string good = read_text(torus_file());
  std::string flipped = good, newer = good;
  flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 4);
  newer[8] = 9;
  const struct {
    const char *name, *says;
    std::string bytes;
  } bad[] = {{"cut.clod", "cut off", good.substr(0, good.size() - 100)},
             {"head.clod", "cut off", good.substr(0, 20)},
             {"flipped.clod", "checksum", flipped},
             {"newer.clod", "version 9", newer}};
  for (const auto& b : bad) {
    const std::string path = write_text(b.name, b.bytes);
    const Ended e =
        run_program({"contacts", path, torus_file(), "--poses", poses(), "--tolerance", "0.001"});
    EXPECT_EQ(e.code, 4);
    expect_one_line(e, path + ": ");
    EXPECT_NE(e.err.find(b.says), std::string::npos) << e.err;
    EXPECT_LT(e.peak_mib, kMostMib);
    EXPECT_TRUE(e.out.empty());
  }
}

}  // namespace
}  // namespace thigma::test
