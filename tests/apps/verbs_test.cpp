// What every verb owes: help, usage errors, JSON on standard output and nothing else.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "apps/program.h"
#include "support/shared.h"
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kVerbs = {"run",    "build",  "contacts",    "inspect", "repair",
                                         "replay", "export", "conformance", "bench",   "devices",
                                         "doctor", "tune",   "bake",        "cache"};

std::string poses_file() {
  return write_text("poses.csv",
                    "x,y,z,qx,qy,qz,qw\n0,0,0.1004,0,0,0,1\n0,0,0.0998,0,0,0,1\n0,0,0.5,0,0,0,1\n");
}

TEST(Verbs, tell_what_they_take) {
  const Ended all = run_program({"--help"});
  EXPECT_EQ(all.code, 0);
  for (const std::string& verb : kVerbs) {
    EXPECT_NE(all.out.find("\n  " + verb), std::string::npos) << verb;
    const Ended one = run_program({verb, "--help"});
    EXPECT_EQ(one.code, 0) << verb;
    EXPECT_TRUE(one.err.empty()) << one.err;
    for (const char* option : {"--json", "--text", "--quiet", "--seed"}) {
      EXPECT_NE(one.out.find(option), std::string::npos) << verb << " " << option;
    }
  }
  const Ended version = run_program({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.rfind("thigma ", 0), 0u) << version.out;
}

TEST(Verbs, refuse_wrong_use_with_one_sentence) {
  const std::string poses = poses_file();
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {""},
      {"--verson"},
      {"inpsect", "x"},
      {"inspect"},
      {"inspect", "x", "--nosuch"},
      {"inspect", "x", "y"},
      {"inspect", "x", "--seed", "-3"},
      {"inspect", "x", "--seed", "many"},
      {"repair", "x"},
      {"replay"},
      {"export", "x"},
      {"conformance"},
      {"bench", "--filter", "("},
      {"bench", "--filter", "no such row"},
      {"contacts", kBall, kBall, "--poses", poses},
      {"contacts", kBall, kBall, "--tolerance", "0.001"},
      {"contacts", kBall, kBall, "--poses", poses, "--tolerance", "-1"},
      {"contacts", kBall, kBall, "--poses", poses, "--tolerance", "nan"},
      {"contacts", kBall, kBall, "--poses", poses, "--tolerance", "0.001", "--scale", "0"},
      {"contacts", kBall, kBall, "--poses", poses, "--tolerance", "0.001", "--scale", "nan"},
      {"run"},
      {"run", "jaws", "--object", kBall, "--against", kBall},
      {"run", "--object", kBall},
      {"run", "jaws", "--scale", "2"},
      {"run", "--object", kBall, "--against", kBall, "--scale", "0"},
      {"run", "--object", kBall, "--against", kBall, "--pose", "0,0,0"},
      {"run", "jaws", "--duration", "-1"},
      {"run", "jaws", "--duration", "0"},
      {"run", "jaws", "--duration", "inf"},
      {"run", "jaws", "--duration", "1e300"},
      {"run", "jaws", "--rate", "0"},
      {"run", "jaws", "--rate", "1e9"},
      {"run", "jaws", "--fault", "stall=1e300@1"},
      {"run", "jaws", "--response", "loud"},
      {"run", "jaws", "--exact", "--threshold", "0.01"},
      {"run", "jaws", "--threshold", "-1"},
      {"run", "jaws", "--deviation-cap", "0"},
      {"run", "jaws", "--budget-us", "0"},
      {"run", "jaws", "--budget-tests", "0"},
      {"run", "jaws", "--fault", "unplug"},
      {"run", "jaws", "--fault", "stall@1"},
      {"run", "jaws", "--fault", "nan@-1"},
      {"run", "--object", kBall, "--against", kBall, "--device", "nosuch", "--quiet"},
      {"run", "--object", kBall, "--against", kBall, "--device", "hand:?masss=1", "--quiet"},
      {"run", "--object", kBall, "--against", kBall, "--device", "hand:?mass=-1", "--quiet"},
  };
  for (const auto& arguments : wrong) {
    const Ended e = run_program(arguments);
    std::string line;
    for (const std::string& a : arguments) line += " " + a;
    EXPECT_EQ(e.code, 2) << line << "\n" << e.err;
    EXPECT_TRUE(e.out.empty()) << line << "\n" << e.out;
    if (arguments.size() < 2 || arguments[0] != "bench") expect_one_line(e);
  }
}

void expect_line_with(const Ended& ended, const std::string& text) {
  expect_one_line(ended);
  EXPECT_NE(ended.err.find(text), std::string::npos) << ended.err;
}

TEST(Verbs, numbers_beyond_their_type_are_refused_not_clamped) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"inspect", kBall, "--seed", "18446744073709551616"},
        {"run", "jaws", "--headless", "--budget-tests", "99999999999999999999"}}) {
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 2) << e.err;
    expect_one_line(e, arguments[arguments.size() - 2].c_str());
  }
  EXPECT_EQ(run_program({"inspect", kBall, "--seed", "18446744073709551615"}).code, 0);
}

TEST(Verbs, help_is_a_verb_too) {
  EXPECT_EQ(run_program({"help"}).out, run_program({"--help"}).out);
  EXPECT_EQ(run_program({"help", "bake"}).out, run_program({"bake", "--help"}).out);
  EXPECT_EQ(run_program({"help"}).code, 0);
  const Ended e = run_program({"help", "bak"});
  EXPECT_EQ(e.code, 2);
  expect_line_with(e, "nearest is 'bake'");
}

TEST(Verbs, unknown_words_get_the_nearest_and_the_list) {
  const Ended option = run_program({"build", kBall, "--output", "x", "--scal", "2"});
  EXPECT_EQ(option.code, 2);
  expect_line_with(option, "nearest is '--scale'");
  EXPECT_NE(option.err.find("--contact-tolerance"), std::string::npos) << option.err;
  const Ended other = run_program({"inspect", kBall, "--zzzzzzzzzzzz=3"});
  EXPECT_EQ(other.code, 2);
  expect_line_with(other, "'--zzzzzzzzzzzz'");
  EXPECT_NE(other.err.find("--json"), std::string::npos) << other.err;
  const Ended model = run_program({"inspect", "procedural:torsu"});
  EXPECT_EQ(model.code, 4);
  expect_line_with(model, "expected 'torus', one of");
  EXPECT_NE(model.err.find("golf_ball"), std::string::npos) << model.err;
}

TEST(Verbs, a_pair_of_meshes_in_millimetres_is_refused_with_the_scale) {
  const std::string ball =
      write_text("mm.obj", format_mesh(make_ball(15.7, 3), MeshFormat::obj, "mm"));
  std::vector<std::string> arguments = {"run",  "--object",   ball,         "--against",
                                        ball,   "--headless", "--lockstep", "--duration",
                                        "0.01", "--quiet",    "--no-cache"};
  const Ended without = run_program(arguments);
  EXPECT_EQ(without.code, 2);
  expect_line_with(without, "--scale 0.001");
  EXPECT_NE(without.err.find("15.7 m"), std::string::npos) << without.err;
  for (const char* scale : {"0.001", "1"}) {
    std::vector<std::string> with = arguments;
    with.insert(with.end(), {"--scale", scale});
    const Ended e = run_program(with);
    EXPECT_EQ(e.code, 0) << e.err;
  }
}

TEST(Verbs, a_bad_second_mesh_is_found_before_the_first_is_built) {
  TriangleMesh fin = make_box({0.02, 0.02, 0.02});
  fin.triangles.push_back(fin.triangles[0]);
  const std::string bad = write_text("twice.obj", format_mesh(fin, MeshFormat::obj, "twice"));
  // What builds says so on standard error, unless told to be quiet.
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"run", "--object", "procedural:ellipsoid", "--against", bad,
                                 "--headless", "--lockstep", "--duration", "0.01", "--no-cache"},
        {"contacts", "procedural:ellipsoid", bad, "--poses", poses_file(), "--tolerance", "0.001",
         "--threshold", "0.025"}}) {
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 4) << e.err;
    expect_line_with(e, "--repair");
  }
}

TEST(Verbs, say_what_is_not_built_yet) {
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
           {"--texture", "rough"}, {"--port", "8080"}}) {
    const Ended e = run_program({"run", "jaws", "--headless", option, value});
    EXPECT_EQ(e.code, 2) << e.err;
    expect_one_line(e, option);
  }
  const Ended embedded = run_program({"run", "jaws", "--headless", "--embed"});
  EXPECT_EQ(embedded.code, 2) << embedded.err;
  expect_one_line(embedded, "--embed belongs to the page");
  for (const char* port : {"x", "65536"}) {
    const Ended e = run_program({"run", "jaws", "--port", port});
    EXPECT_EQ(e.code, 2) << e.err;
    expect_one_line(e, "--port");
  }
  const Ended web =
      run_program({"run", "--object", kBall, "--against", kBall, "--device", "web:", "--headless"});
  EXPECT_EQ(web.code, 3) << web.err;
  expect_one_line(web, "web:");
}

TEST(Verbs, refuse_a_missing_file_as_input) {
  const std::string poses = poses_file();
  const std::string gone = (work_folder() / "gone").string();
  const std::vector<std::vector<std::string>> missing = {
      {"inspect", gone},
      {"repair", gone, "-o", gone + ".out"},
      {"replay", gone},
      {"export", gone, "-o", gone + ".out"},
      {"conformance", gone},
      {"run", gone + ".toml"},
      {"run", "--object", gone, "--against", kBall},
      {"contacts", gone, kBall, "--poses", poses, "--tolerance", "0.001"},
      {"contacts", kBall, gone, "--poses", poses, "--tolerance", "0.001"},
      {"contacts", kBall, kBall, "--poses", gone, "--tolerance", "0.001"},
      {"run", "--object", kBall, "--against", kBall, "--quiet", "--device", "script:" + gone},
      {"run", "--object", kBall, "--against", kBall, "--quiet", "--device", "replay:" + gone},
  };
  for (const auto& arguments : missing) {
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 4) << arguments[0] << ": " << e.err;
    expect_one_line(e, gone);
    EXPECT_TRUE(e.out.empty());
    EXPECT_FALSE(fs::exists(gone + ".out"));
  }
  const Ended model = run_program({"inspect", "procedural:bal"});
  EXPECT_EQ(model.code, 4);
  EXPECT_NE(model.err.find("'ball'"), std::string::npos) << model.err;
  const Ended folder = run_program({"inspect", work_folder().string()});
  EXPECT_EQ(folder.code, 4);
  const Ended long_path = run_program({"inspect", std::string(50'000, 'p')});
  EXPECT_EQ(long_path.code, 4);
}

TEST(Verbs, survive_names_that_are_no_text) {
  const std::string box =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const std::string path = write_text("odd\xff\x1b[31m\n.obj", box);
  EXPECT_EQ(json_line(run_program({"inspect", path, "--json"}))["verdict"], "usable");
  const std::string out = (work_folder() / "out\xff.ply").string();
  const Ended repaired = run_program({"repair", path, "-o", out, "--json"});
  EXPECT_EQ(repaired.code, 0) << repaired.err;
  EXPECT_TRUE(fs::exists(out));
  const std::string recording = (work_folder() / "odd\xff.mcap").string();
  const Ended ran = run_program({"run", "--object", path, "--against", path, "--lockstep",
                                 "--duration", "0.01", "--record", recording, "--json", "--quiet"});
  EXPECT_EQ(ran.code, 0) << ran.err;
  EXPECT_EQ(json_line(run_program({"replay", recording, "--json", "--quiet"}))["identical"], true);
  const Ended gone = run_program({"inspect", "gone\n\x1b[31m"});
  EXPECT_EQ(gone.code, 4);
  expect_one_line(gone, "gone??[31m: ");
}

bool is_finite_or_null(const nlohmann::json& json) {
  if (json.is_structured()) {
    for (const auto& item : json) {
      if (!is_finite_or_null(item)) return false;
    }
  }
  return !json.is_number_float() || std::isfinite(json.get<double>());
}

void expect_fields(const nlohmann::json& json, const std::vector<const char*>& names) {
  EXPECT_TRUE(is_finite_or_null(json)) << json;
  for (const char* name : names)
    EXPECT_TRUE(json.contains(nlohmann::json::json_pointer(name))) << name << " in " << json;
}

TEST(Verbs, print_the_fields_of_the_interface) {
  const nlohmann::json mesh = json_line(run_program({"inspect", kBall, "--json"}));
  expect_fields(mesh, {"/file",
                       "/format",
                       "/triangles",
                       "/vertices",
                       "/vertices_in_file",
                       "/components",
                       "/boundary_edges",
                       "/nonmanifold_edges",
                       "/nonmanifold_vertices",
                       "/misoriented_edges",
                       "/degenerate_triangles",
                       "/duplicate_triangles",
                       "/self_intersections",
                       "/closed",
                       "/manifold",
                       "/oriented",
                       "/area",
                       "/volume",
                       "/center_of_mass/2",
                       "/inertia/2/2",
                       "/radius",
                       "/bounds/min",
                       "/bounds/max",
                       "/verdict",
                       "/reasons",
                       "/warnings"});
  const std::string out = (work_folder() / "ball.ply").string();
  expect_fields(json_line(run_program({"repair", kBall, "-o", out, "--json"})),
                {"/repairs", "/verdict"});
  EXPECT_EQ(json_line(run_program({"inspect", out, "--json"}))["triangles"], mesh["triangles"]);

  const std::vector<const char*> durations = {"/haptic/step_cpu_us", "/haptic/wake_late_us",
                                              "/contact/query_cpu_us"};
  for (const bool is_lockstep : {true, false}) {
    std::vector<std::string> arguments = {"run",        "--object",   kBall, "--against", kBall,
                                          "--headless", "--duration", "0.3", "--quiet"};
    arguments.push_back(is_lockstep ? "--lockstep" : "--json");
    const nlohmann::json run = json_line(run_program(arguments));
    expect_fields(run, {"/scene",
                        "/device",
                        "/seconds",
                        "/haptic/rate_hz",
                        "/haptic/frames",
                        "/haptic/missed",
                        "/contact/updates",
                        "/contact/rate_hz",
                        "/contact/contacts_mean",
                        "/contact/clusters_mean",
                        "/contact/front_mean",
                        "/contact/model_age_ms/p50",
                        "/contact/model_age_ms/p99",
                        "/contact/model_age_ms/max",
                        "/force/max",
                        "/force/rms",
                        "/torque/max",
                        "/torque/rms",
                        "/penetration_max",
                        "/coupling_stretch_max",
                        "/energy_min",
                        "/dropped_samples",
                        "/safety_events",
                        "/state_hash"});
    for (const std::string name : durations) {
      for (const char* q : {"/p50", "/p99", "/p999", "/max"})
        expect_fields(run, {(name + q).c_str()});
    }
    EXPECT_EQ(run["state_hash"].get<std::string>().size(), 16u);
  }
  for (const char* verb : {"devices", "doctor"}) {
    const Ended e = run_program({verb, "--json"});
    EXPECT_EQ(e.code, 0);
    EXPECT_GT(json_lines(e).size(), 3u);
  }
}

TEST(Verbs, look_at_a_device) {
  const Ended seen = run_program({"devices", "check", "hand:", "--duration", "0.3", "--json"});
  EXPECT_EQ(seen.code, 0) << seen.err;
  const auto report = json_lines(seen).at(0);
  EXPECT_GT(report["frames"].get<int>(), 10);
  EXPECT_GT(report["rules"].size(), 8u);
  const struct {
    std::vector<std::string> words;
    int code;
  } refused[] = {{{"check", "hand:", "--duration", "nan"}, 2},
                 {{"check", "hand:", "--rate", "nan"}, 2},
                 {{"check", "hand:", "--duration", "0"}, 2},
                 {{"check", "hand:", "--rate", "1e9"}, 2},
                 {{"check"}, 2},
                 {{"check", "hond:"}, 3},
                 {{"check", "dhd:x"}, 2},
                 {{"check", "script:none.csv"}, 4},
                 {{"check", "web:"}, 3},
                 {{"calibrate", "hand:"}, 3},
                 {{"calibrate", "dhd:x"}, 2}};
  for (const auto& [words, code] : refused) {
    std::vector<std::string> all = {"devices"};
    all.insert(all.end(), words.begin(), words.end());
    const Ended e = run_program(all, 10.0);
    EXPECT_EQ(e.code, code) << words.front() << ' ' << words.back() << ": " << e.err;
    EXPECT_TRUE(e.out.empty()) << e.out;
    EXPECT_NE(e.err.find("thigma: "), std::string::npos) << e.err;
  }
}

TEST(Verbs, judge_real_meshes) {
  THIGMA_NEEDS_SHARED(folder);
  const struct {
    const char *file, *verdict;
    bool is_closed;
  } meshes[] = {{"a09_round_peg_16mm.obj", "usable", true},
                {"a08_nut_m16_loose.obj", "repairable", true},
                {"a16_mountain_open.obj", "usable", false}};
  for (const auto& m : meshes) {
    const Ended e = run_program({"inspect", (folder / "meshes" / m.file).string(), "--json"});
    EXPECT_EQ(e.code, 0) << e.err;
    const nlohmann::json json = json_line(e);
    EXPECT_EQ(json["verdict"], m.verdict) << m.file << json["reasons"];
    EXPECT_EQ(json["reasons"].empty(), m.verdict == std::string("usable"));
    EXPECT_EQ(json["volume"].is_null(), !m.is_closed || m.verdict != std::string("usable"));
  }
  const std::string nut = (folder / "meshes" / "a08_nut_m16_loose.obj").string();
  const std::string poses = write_text("away.csv", "x,y,z,qx,qy,qz,qw\n9,0,0,0,0,0,1\n");
  std::vector<std::string> contacts = {"contacts", kBall,         nut,    "--poses",
                                       poses,      "--tolerance", "0.001"};
  const Ended refused = run_program(contacts);
  EXPECT_EQ(refused.code, 4);
  expect_one_line(refused, nut + ": ");
  EXPECT_NE(refused.err.find("--repair"), std::string::npos) << refused.err;
  contacts.push_back("--repair");
  EXPECT_EQ(run_program(contacts).code, 0);
  const std::string out = (work_folder() / "nut.ply").string();
  const nlohmann::json repaired = json_line(run_program({"repair", nut, "-o", out, "--json"}));
  EXPECT_FALSE(repaired["repairs"].empty());
  EXPECT_EQ(json_line(run_program({"inspect", out, "--json"}))["verdict"], "usable");
}

TEST(Verbs, keep_quiet_when_told) {
  const Ended e = run_program({"run", "--object", kBall, "--against", kBall, "--lockstep",
                               "--duration", "0.05", "--quiet"});
  EXPECT_EQ(e.code, 0);
  EXPECT_TRUE(e.err.empty()) << e.err;
  const Ended threaded = run_program(
      {"run", "--object", kBall, "--against", kBall, "--duration", "0.05", "--quiet", "--json"});
  EXPECT_TRUE(threaded.err.empty()) << threaded.err;
}

// 0: nothing failed. Of a shell command with `thigma` as $0.
int shell(const std::string& command, std::string* said) {
  const std::string err = (work_folder() / "shell_stderr").string();
  const std::string program = THIGMA_PROGRAM;
  const int status = std::system(("(" + command + ") 2>" + err).c_str());
  if (said != nullptr) *said = read_text(err);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Verbs, end_quietly_when_nobody_reads) {
  std::string poses = "x,y,z,qx,qy,qz,qw\n";
  for (int i = 0; i < 20'000; ++i) poses += "0,0,0.0999,0,0,0,1\n";
  const std::string path = write_text("many.csv", poses);
  const std::string contacts = std::string(THIGMA_PROGRAM) + " contacts '" + kBall + "' '" + kBall +
                               "' --poses " + path + " --tolerance 0.001";
  std::string said;
  EXPECT_EQ(shell(contacts + " | head -n 1 >/dev/null", &said), 0);
  EXPECT_EQ(said, "");
  EXPECT_EQ(shell(contacts + " >/dev/full", &said), 1);
  EXPECT_EQ(said, "thigma: standard output: cannot be written\n");
  EXPECT_EQ(shell(std::string(THIGMA_PROGRAM) + " inspect '" + kBall + "' >/dev/full", &said), 1);
  EXPECT_EQ(said, "thigma: standard output: cannot be written\n");
}

TEST(Verbs, write_a_whole_file_or_none) {
  const fs::path folder = work_folder() / "a_folder";
  fs::create_directories(folder / "inside");
  const std::string half = write_text("half.obj", "v 0 0 0\nv 1 0 0\n");
  for (const std::string& out : {folder.string(), (work_folder() / "no_folder" / "x.obj").string(),
                                 std::string("/proc/x.obj")}) {
    const Ended e = run_program({"repair", kBall, "-o", out});
    EXPECT_EQ(e.code, 1) << e.err;
    expect_one_line(e, out + ": ");
  }
  const std::string out = (work_folder() / "kept.obj").string();
  write_text("kept.obj", "what was there before\n");
  EXPECT_EQ(run_program({"repair", half, "-o", out}).code, 4);
  EXPECT_EQ(read_text(out), "what was there before\n");
  EXPECT_EQ(shell("ulimit -f 8; exec " + std::string(THIGMA_PROGRAM) +
                      " repair 'procedural:ball?triangles=8000' -o " + out,
                  nullptr),
            1);
  EXPECT_EQ(read_text(out), "what was there before\n");
  for (const auto& entry : fs::directory_iterator(work_folder())) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

// What a person sees: the program's output on a terminal.
std::string on_a_terminal(const std::string& arguments) {
  const std::string command = "script -qec '" THIGMA_PROGRAM " " + arguments + "' /dev/null";
  FILE* const pipe = ::popen((command + " </dev/null 2>&1").c_str(), "r");
  std::string text;
  for (int c; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
  if (pipe != nullptr) ::pclose(pipe);
  return text;
}

TEST(Verbs, a_terminal_gets_lines_for_people_and_a_pipe_the_json) {
  const std::string run = "run --object " + kBall + " --against " + kBall +
                          " --lockstep --headless --duration 0.02 --quiet";
  for (const std::string& arguments : {"inspect " + kBall, run}) {
    const std::string shown = on_a_terminal(arguments);
    EXPECT_EQ(shown.find('{'), std::string::npos) << shown;
    EXPECT_GT(std::count(shown.begin(), shown.end(), '\n'), 3) << shown;
    // Three digits, four of a count: none with what a double has.
    for (std::size_t i = 0, digits = 0; i < shown.size(); ++i) {
      digits = std::isdigit(static_cast<unsigned char>(shown[i])) != 0 ? digits + 1 : 0;
      EXPECT_LT(digits, 7u) << shown.substr(0, i + 1);
      if (shown.compare(i, 10, "state hash") == 0) break;  // 16 digits
    }
    std::istringstream words(arguments);
    const Ended piped = run_program({std::istream_iterator<std::string>(words), {}});
    EXPECT_TRUE(json_line(piped).is_object());
  }
  EXPECT_EQ(run_program({"inspect", kBall, "--text"}).out.find('{'), std::string::npos);
  EXPECT_EQ(run_program({"inspect", kBall, "--text", "--json"}).code, 2);
}

TEST(Verbs, the_cache_is_listed_and_cleared) {
  const fs::path home = fs::path(testing::TempDir()) / "thigma_verb_cache";
  fs::create_directories(home / "thigma");
  std::ofstream(home / "thigma" / "part.obj.0123456789abcdef.clod") << "12345";
  const std::string old = std::getenv("XDG_CACHE_HOME") ? std::getenv("XDG_CACHE_HOME") : "";
  ::setenv("XDG_CACHE_HOME", home.c_str(), 1);
  const Ended list = run_program({"cache", "list", "--text"});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_NE(list.out.find("part.obj."), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("in 1 files in"), std::string::npos) << list.out;
  const Ended kept = run_program({"cache", "clear", "--older", "1", "--json"});
  EXPECT_EQ(json_line(kept)["removed"], 0);
  const Ended cleared = run_program({"cache", "clear", "--json"});
  EXPECT_EQ(json_line(cleared)["removed"], 1);
  EXPECT_EQ(json_line(cleared)["bytes"], 5);
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"cache"},
                                                {"cache", "lsit"},
                                                {"cache", "list", "--older", "1"},
                                                {"cache", "clear", "--older", "-1"}})
    EXPECT_EQ(run_program(wrong).code, 2) << wrong.back();
  if (old.empty())
    ::unsetenv("XDG_CACHE_HOME");
  else
    ::setenv("XDG_CACHE_HOME", old.c_str(), 1);
  fs::remove_all(home);
}

}  // namespace
}  // namespace thigma::test
