// Recordings of worlds of several bodies: export, plot, what they carry.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "apps/program.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

/// Pushes a block over a table.
std::string pushed_block(const std::string& name) {
  const std::string box = "mesh = \"procedural:box?triangles=12\"\ndensity = 300.0\n";
  return write_text(
      name + ".toml",
      "title = \"Pushed\"\ngravity = [0.0, 0.0, -9.81]\n[object]\nname = \"pusher\"\n" + box +
          "unit_scale = 0.3\nposition = [-0.035, 0.0, 0.008]\n[[static]]\nname = \"table\"\n"
          "mesh = \"procedural:box?triangles=12\"\nunit_scale = 10.0\nposition = [0.0, 0.0, "
          "-0.2]\n[[body]]\nname = \"block\"\n" +
          box +
          "unit_scale = 0.3\nposition = [0.0, 0.0, 0.006002]\n[device]\nuri = "
          "\"hand:\"\napproach = [1.0, 0.0, 0.0]\nclearance = 0.005\n");
}

nlohmann::json run_world(const std::string& scene, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run", scene, "--headless", "--json", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Ended e = run_program(arguments);
  EXPECT_EQ(e.code, 0) << e.err;
  return json_line(e);
}

/// A column of a table whose names need no quotes.
std::vector<double> column(const std::string& path, const std::string& name) {
  std::istringstream in(read_text(path));
  std::string line, cell;
  std::getline(in, line);
  std::istringstream names(line);
  std::size_t at = 0;
  while (std::getline(names, cell, ',') && cell != name) ++at;
  EXPECT_EQ(cell, name) << line;
  std::vector<double> values;
  while (std::getline(in, line)) {
    std::istringstream row(line);
    for (std::size_t i = 0; i <= at; ++i) std::getline(row, cell, ',');
    values.push_back(cell.empty() ? -1e9 : std::stod(cell));
  }
  return values;
}

TEST(WorldRecords, export_gives_what_the_run_said) {
  const std::string file = out_file("pushed.mcap"), csv = out_file("pushed.csv");
  const nlohmann::json run =
      run_world(pushed_block("exported"), {"--lockstep", "--duration", "1.5", "--record", file});
  const Ended e = run_program({"export", file, "-o", csv, "--json"});
  ASSERT_EQ(e.code, 0) << e.err;
  EXPECT_EQ(json_line(e)["frames"], 1500);
  ASSERT_EQ(column(csv, "frame").size(), 1500u);
  EXPECT_EQ(column(csv, "time [s]").back(), 1.5);
  EXPECT_EQ(column(csv, "device energy [J]").back(), run["hands"][0]["energy"].get<double>());
  EXPECT_GT(run["hands"][0]["energy"].get<double>(), 0.0);
  const std::vector<double> x = column(csv, "body block x [m]");
  EXPECT_GT(x.back(), x.front() + 1e-3) << "it was pushed";
  double force = 0.0;
  const std::vector<double> fx = column(csv, "device command fx [N]"),
                            fy = column(csv, "device command fy [N]"),
                            fz = column(csv, "device command fz [N]");
  for (std::size_t i = 0; i < fx.size(); ++i)
    force = std::max(force, std::hypot(fx[i], fy[i], fz[i]));
  EXPECT_NEAR(force, run["force"]["max"].get<double>(), 1e-12);
  const std::vector<double> asleep = column(csv, "body block asleep");
  EXPECT_EQ(
      std::count(asleep.begin(), asleep.end(), 0.0) + std::count(asleep.begin(), asleep.end(), 1.0),
      1500);
}

TEST(WorldRecords, export_has_the_haptic_frames_of_hands_that_are_apart) {
  const std::string file = out_file("clock.mcap"), csv = out_file("clock.csv"),
                    steps = out_file("clock_steps.csv");
  const nlohmann::json run =
      run_world(pushed_block("apart"), {"--duration", "0.3", "--record", file});
  const Ended e = run_program({"export", file, "-o", csv, "--haptic", steps, "--json"});
  ASSERT_EQ(e.code, 0) << e.err;
  const nlohmann::json& haptic = run["hands"][0]["haptic"];
  EXPECT_EQ(json_line(e)["haptic_frames"], haptic["frames"]);
  EXPECT_EQ(column(steps, "step").size(), haptic["frames"].get<std::size_t>());
  EXPECT_EQ(column(steps, "device energy [J]").back(), haptic["energy"].get<double>());
  EXPECT_EQ(column(csv, "frame").size(), run["frames"].get<std::size_t>());
}

TEST(WorldRecords, haptic_frames_are_refused_where_there_are_none_of_their_own) {
  const std::string file = out_file("one_loop.mcap"), none = out_file("none.csv");
  run_world(pushed_block("refused"), {"--lockstep", "--duration", "0.05", "--record", file});
  expect_one_line(run_program({"export", file, "-o", out_file("all.csv"), "--haptic", none}),
                  file + ": has no haptic frames of their own");
  EXPECT_FALSE(std::filesystem::exists(out_file("all.csv")));
  EXPECT_FALSE(std::filesystem::exists(none));
}

TEST(WorldRecords, nothing_is_written_over_what_is_read) {
  const std::string scene = pushed_block("kept"), file = out_file("kept.mcap");
  run_world(scene, {"--lockstep", "--duration", "0.1", "--record", file});
  const std::string bytes = read_text(file), text = read_text(scene);
  const std::string csv = out_file("kept.csv");
  const std::vector<std::vector<std::string>> all = {
      {"export", file, "-o", file},
      {"export", file, "-o", csv, "--haptic", file},
      {"export", file, "-o", csv, "--haptic", csv},
      {"pack", file, "-o", file},
      {"pack", scene, "-o", scene},
      {"run", file, "--lockstep", "--headless", "--duration", "0.1", "--record", file}};
  for (const std::vector<std::string>& arguments : all) {
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 2) << arguments[0];
    EXPECT_NE(e.err.find("expected another"), std::string::npos) << e.err;
  }
  EXPECT_EQ(read_text(file), bytes);
  EXPECT_EQ(read_text(scene), text);
  // What is no recording is said to be none, whatever was asked of it.
  const Ended e = run_program({"export", scene, "-o", csv, "--haptic", out_file("steps.csv")});
  EXPECT_EQ(e.code, 4) << e.err;
}

TEST(WorldRecords, replay_says_where_a_recording_was_cut_off_and_what_its_scene_lacks) {
  const std::string file = out_file("whole.mcap");
  run_world(pushed_block("cut"), {"--lockstep", "--duration", "1", "--record", file});
  const Ended whole = run_program({"replay", file, "--json"});
  EXPECT_TRUE(json_line(whole)["cut_off"].is_null());
  EXPECT_EQ(whole.err, "");
  const std::string bytes = read_text(file);
  const std::string cut = write_text("cut_off.mcap", bytes.substr(0, 2 * bytes.size() / 3));
  const Ended e = run_program({"replay", cut, "--json"});
  EXPECT_EQ(e.code, 0) << e.err;
  EXPECT_NE(e.err.find("the recording ends at"), std::string::npos) << e.err;
  EXPECT_TRUE(json_line(e)["cut_off"].is_string());
}

TEST(WorldRecords, plot_draws_what_there_is) {
  const std::string file = out_file("drawn.mcap"), svg = out_file("drawn.svg");
  run_world(pushed_block("drawn"), {"--lockstep", "--duration", "1.2", "--record", file});
  const Ended e = run_program({"plot", file, "-o", svg, "--json"});
  ASSERT_EQ(e.code, 0) << e.err;
  EXPECT_EQ(json_line(e)["frames"], 1200);
  EXPECT_EQ(json_line(e)["panels"], 6) << "it has no joints";
  EXPECT_GT(std::filesystem::file_size(svg), 10000u);
  expect_one_line(run_program({"plot", file, "-o", out_file("drawn.gif")}), "plot: -o");
}

TEST(WorldRecords, a_recording_brings_its_scene_and_replays_where_nothing_else_is) {
  namespace fs = std::filesystem;
  const fs::path there = work_folder() / "there";
  fs::create_directories(there);
  write_text("there/octahedron.obj",
             "v 15 0 0\nv -15 0 0\nv 0 15 0\nv 0 -15 0\nv 0 0 15\nv 0 0 -15\nf 1 3 5\nf 3 2 "
             "5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n");
  const std::string scene = write_text(
      "there/falls.toml",
      "title = \"Falls\"\ngravity = [0.0, 0.0, -9.81]\n[[static]]\nname = \"floor\"\nmesh = "
      "\"procedural:box?triangles=12\"\nunit_scale = 3.0\nposition = [0.0, 0.0, "
      "-0.1]\n[[body]]\nname = \"thing\"\nmesh = \"octahedron.obj\"\nunit_scale = 1e-3\n"
      "position = [0.0, 0.0, 0.03]\nquat_xyzw = [0.18257418583505536, 0.3651483716701107, "
      "0.5477225575051661, 0.7302967433402214]\ndensity = 700.0\ncopies = "
      "2\nspacing = [0.0, 0.0, 0.04]\n");
  const std::string file = out_file("falls.mcap"), packed = out_file("falls_packed.mcap");
  const nlohmann::json run =
      run_world(scene, {"--lockstep", "--duration", "0.3", "--record", file});
  ASSERT_EQ(run_program({"pack", scene, "-o", packed}).code, 0);
  fs::remove_all(there);
  EXPECT_EQ(run_program({"run", scene, "--lockstep", "--duration", "0.1"}).code, 4);
  const nlohmann::json replay = json_line(run_program({"replay", file, "--json"}));
  EXPECT_EQ(replay["identical"], true) << replay;
  EXPECT_EQ(replay["frames"], 300);
  for (const std::string& brought : {file, packed}) {
    const nlohmann::json again = run_world(brought, {"--lockstep", "--duration", "0.3"});
    EXPECT_EQ(again["state_hash"], run["state_hash"]) << brought;
  }
  const std::string twice = out_file("falls_twice.mcap");
  ASSERT_EQ(run_program({"pack", file, "-o", twice}).code, 0);
  EXPECT_EQ(
      json_line(run_program({"pack", twice, "-o", out_file("thrice.mcap"), "--json"}))["files"], 2);
}

}  // namespace
}  // namespace thigma::test
