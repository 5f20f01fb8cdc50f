// run, replay, export: the same inputs give the same bits, a change is found where it is, and
// forces end at zero.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/program.h"
#include "support/copy_recording.h"
#include "support/far_recording.h"
#include "support/mcap_bytes.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/files/file.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> run_arguments(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run", "--object",   kBall,    "--against",
                                        kBall, "--headless", "--json", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// A machine that stops a real-time thread for 50 ms gives a fault of its own: a few tries, until
/// the run ends as it should.
template <class Run>
Ended undisturbed(const Run& run, int code) {
  Ended e = run();
  for (int i = 0; i < 4 && e.code != code; ++i) e = run();
  return e;
}

nlohmann::json run_ball(const std::vector<std::string>& more) {
  const Ended e = undisturbed([&] { return run_program(run_arguments(more)); }, 0);
  EXPECT_EQ(e.code, 0) << e.err;
  return json_line(e);
}

TEST(RecordVerbs, same_inputs_same_bits) {
  const std::string file = out_file("once.mcap");
  const nlohmann::json once = run_ball({"--lockstep", "--duration", "1", "--record", file});
  EXPECT_GT(once["force"]["max"].get<double>(), 0.5);
  EXPECT_EQ(once["haptic"]["frames"], 1000);
  const nlohmann::json again = run_ball({"--lockstep", "--duration", "1"});
  EXPECT_EQ(once["state_hash"], again["state_hash"]) << "recording must not change a run";
  const nlohmann::json other = run_ball({"--lockstep", "--duration", "1", "--seed", "2"});
  EXPECT_NE(once["state_hash"], other["state_hash"]);
  const Ended e = run_program({"replay", file, "--json"});
  EXPECT_EQ(e.code, 0) << e.err;
  const nlohmann::json replay = json_line(e);
  EXPECT_EQ(replay["identical"], true);
  EXPECT_EQ(replay["frames"], 1000);
  EXPECT_EQ(replay["state_hash"], once["state_hash"]);
  EXPECT_EQ(replay["recorded_hash"], once["state_hash"]);
  EXPECT_TRUE(replay["first_difference"].is_null());
}

TEST(RecordVerbs, threaded_sessions_replay_identical) {
  const std::string file = out_file("threaded.mcap");
  const nlohmann::json run = run_ball({"--duration", "1", "--record", file});
  EXPECT_GT(run["force"]["max"].get<double>(), 0.1);
  EXPECT_EQ(run["dropped_samples"], 0);
  const nlohmann::json replay = json_line(run_program({"replay", file, "--json"}));
  EXPECT_EQ(replay["identical"], true) << replay;
  EXPECT_EQ(replay["state_hash"], run["state_hash"]);
}

TEST(RecordVerbs, relief_is_the_same_on_a_graphics_processor) {
  const auto run = [](const std::string& depth, const std::string& file) {
    const std::string scene =
        write_text(depth + ".toml",
                   "[object]\nmesh = \"procedural:ball?triangles=320\"\nunit_scale = 0.2\nposition "
                   "= [0.0, 0.0, 0.022]\n"
                   "mass = 0.01\n[[static]]\ntexture = \"procedural:ridged_plate?texels=64\"\n"
                   "[contact]\nstiffness = 2000.0\n[device]\napproach = [0.0, 0.0, "
                   "-1.0]\n[texture]\nresolution = 12\ndepth = \"" +
                       depth + "\"\n");
    return run_program(
        {"run", scene, "--headless", "--json", "--lockstep", "--duration", "2", "--record", file});
  };
  const std::string file = out_file("gpu.mcap");
  const Ended there = run("gpu", file), here = run("grid", out_file("grid.mcap"));
  ASSERT_EQ(there.code, 0) << there.err;
  ASSERT_EQ(here.code, 0) << here.err;
  const double most = json_line(here)["force"]["max"].get<double>();
  EXPECT_GT(most, 0.1);
  EXPECT_NEAR(json_line(there)["force"]["max"].get<double>(), most, 1e-3 * most);
  EXPECT_EQ(here.err.find("textures are computed"), std::string::npos);
  // Without one in hardware a line tells so, once.
  const std::size_t first = there.err.find("textures are computed");
  if (first != std::string::npos) {
    EXPECT_EQ(there.err.find("textures are computed", first + 1), std::string::npos) << there.err;
  }
  EXPECT_EQ(json_line(run_program({"replay", file, "--json"}))["identical"], true);
}

TEST(RecordVerbs, only_objects_that_touch_are_moved_apart) {
  // Two balls of 50 mm: 4 mm apart, and overlapping.
  for (const bool is_apart : {true, false}) {
    const std::string file = out_file("placed.mcap");
    const Ended e = run_program({"run", "--object", kBall, "--against", kBall, "--pose",
                                 is_apart ? "0,0,0.104,0,0,0,1" : "0,0,0.05,0,0,0,1", "--headless",
                                 "--lockstep", "--duration", "2", "--record", file});
    ASSERT_EQ(e.code, 0) << e.err;
    EXPECT_GT(json_line(e)["force"]["max"].get<double>(), 0.5);
    EXPECT_NE(e.err.find(is_apart ? "start as given" : "overlap as given: moved apart"),
              std::string::npos)
        << e.err;
    const Vec3 first = read_recording(file).frames.at(0).body.position;
    EXPECT_EQ((first - Vec3(0.0, 0.0, is_apart ? 0.104 : 0.05)).norm() < 1e-4, is_apart) << first;
  }
}

TEST(RecordVerbs, a_recording_of_more_than_4_GiB_is_used_like_any_other) {
  const std::string file = out_file("far.mcap"), csv = out_file("far.csv");
  run_ball({"--lockstep", "--duration", "0.5", "--record", file});
  ASSERT_EQ(run_program({"export", file, "-o", csv}).code, 0);
  const std::string rows = read_file(csv);
  test::push_away(file, (std::uint64_t{1} << 32) + 99);
  EXPECT_EQ(json_line(run_program({"replay", file, "--json"}))["identical"], true);
  ASSERT_EQ(run_program({"export", file, "-o", csv}).code, 0);
  EXPECT_EQ(read_file(csv), rows);
  EXPECT_EQ(json_line(run_program({"plot", file, "-o", out_file("far.png"), "--json"}))["frames"],
            500);
  run_ball({"--lockstep", "--device", "replay:" + file, "--duration", "0.5"});
  std::filesystem::remove(file);
}

TEST(RecordVerbs, recorded_samples_as_a_device_give_the_recorded_session) {
  const std::string file = out_file("as_device.mcap");
  const nlohmann::json recorded =
      run_ball({"--lockstep", "--duration", "1", "--rate", "800", "--record", file});
  ASSERT_GT(recorded["force"]["max"].get<double>(), 0.5);
  const std::vector<std::string> again = {"--lockstep", "--device", "replay:" + file};
  std::vector<std::string> as_long = again;
  as_long.insert(as_long.end(), {"--duration", "1"});
  EXPECT_EQ(run_ball(as_long)["state_hash"], recorded["state_hash"]);
  // Without a duration the device ends the session, a frame later.
  const nlohmann::json whole = run_ball(again);
  EXPECT_EQ(whole["force"]["max"], recorded["force"]["max"]);
  EXPECT_NEAR(whole["haptic"]["frames"].get<double>(), 800.0, 30.0);
  // What a device that set its own pace gave is played at the engine's.
  std::string bytes = expanded_recording(read_text(file));
  const std::string clock = "\"device_clock\":false", other = "\"device_clock\": true";
  const std::size_t at = bytes.find(clock);
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, clock.size(), other);
  const nlohmann::json paced = run_ball({"--lockstep", "--duration", "1", "--device",
                                         std::string("replay:") + write_text("paced.mcap", bytes)});
  EXPECT_EQ(paced["state_hash"], recorded["state_hash"]);
}

/// Where in the file the text of the device sample of a frame begins.
std::size_t sample_of(const std::string& bytes, int frame) {
  const std::string start = "{\"frame\":" + std::to_string(frame) + ",";
  std::size_t at = bytes.find(start);
  while (at != std::string::npos &&
         bytes.substr(at, 700).find("\"input_digest\"") == std::string::npos)
    at = bytes.find(start, at + 1);
  return at;
}

/// Changes the number at `at` by as little as its length allows, a bit or a few of its mantissa.
void change_number(std::string& bytes, std::size_t at) {
  const std::size_t end = bytes.find_first_of(",]e", at);
  const double before = std::strtod(bytes.c_str() + at, nullptr);
  for (std::size_t i = end; i-- > at;) {
    const char digit = bytes[i];
    if (std::isdigit(static_cast<unsigned char>(digit)) == 0) continue;
    for (const char other :
         {digit == '9' ? '8' : static_cast<char>(digit + 1), digit < '5' ? '9' : '1'}) {
      bytes[i] = other;
      if (std::strtod(bytes.c_str() + at, nullptr) != before) return;
    }
    bytes[i] = digit;
  }
  FAIL() << "no digit";
}

TEST(RecordVerbs, one_changed_digit_is_found_at_its_frame) {
  const std::string file = out_file("digit.mcap");
  run_ball({"--lockstep", "--duration", "0.8", "--record", file});
  const std::string whole = expanded_recording(read_text(file));
  for (const int frame : {300, 641, 799}) {
    for (const std::string field : {"\"position\":[", "\"linear_velocity\":["}) {
      std::string bytes = whole;
      const std::size_t sample = sample_of(bytes, frame);
      ASSERT_NE(sample, std::string::npos) << frame;
      change_number(bytes, bytes.find(field, sample) + field.size());
      const Ended e = run_program({"replay", write_text("changed.mcap", bytes), "--json"});
      EXPECT_EQ(e.code, 5) << frame << field << e.err;
      const nlohmann::json report = json_line(e);
      EXPECT_EQ(report["identical"], false);
      EXPECT_EQ(report["first_difference"], frame) << report;
      EXPECT_NE(e.err.find("checksum"), std::string::npos) << e.err;
    }
  }
}

/// Changes a number of the contact model that a frame is the first to use: its replay says so.
void expect_changed_model_is_found(const std::string& response, const std::string& field) {
  const std::string file = out_file("model.mcap");
  run_ball({"--lockstep", "--duration", "0.8", "--response", response, "--record", file});
  const std::string whole = expanded_recording(read_text(file));
  const Recording recording = read_recording(file);
  const HapticSample& user = recording.frames.at(750);
  ASSERT_NE(user.model_sequence, recording.frames.at(749).model_sequence);
  std::string bytes = whole;
  const std::size_t model =
      bytes.find("{\"sequence\":" + std::to_string(user.model_sequence) + ",");
  ASSERT_NE(model, std::string::npos);
  const std::size_t at = bytes.find(field, model);
  ASSERT_LT(at, bytes.find("\"model_digest\"", model)) << "nothing touches there";
  change_number(bytes, at + field.size());
  const nlohmann::json report =
      json_line(run_program({"replay", write_text("changed.mcap", bytes), "--json"}));
  EXPECT_EQ(report["identical"], false);
  EXPECT_EQ(report["first_difference"], 750) << report;
  EXPECT_NE(report["reason"].get<std::string>().find("contact model"), std::string::npos);
}

TEST(RecordVerbs, a_changed_contact_model_is_found_at_its_frame) {
  for (const char* field : {"\"stiffness\":", "\"scene_point\":["})
    expect_changed_model_is_found("penalty", field);
  for (const char* field : {"\"travel\":", "\"scene_point\":["})
    expect_changed_model_is_found("constraint", field);
}

TEST(RecordVerbs, friction_is_for_every_contact) {
  const std::string file = out_file("friction.mcap");
  run_ball({"--lockstep", "--duration", "0.8", "--friction", "0.25", "--record", file});
  int rows = 0;
  for (const ContactSample& contact : read_recording(file).contacts) {
    for (const ContactRow& row : contact.model.constraints.rows) {
      EXPECT_EQ(row.friction, (Friction{0.25, 0.25}));
      ++rows;
    }
  }
  EXPECT_GT(rows, 0);
  for (const char* wrong : {"-0.1", "nan", "inf"}) {
    const Ended e = run_program(run_arguments({"--lockstep", "--friction", wrong}));
    EXPECT_EQ(e.code, 2) << wrong;
    EXPECT_NE(e.err.find("--friction must be a number, 0 or more"), std::string::npos) << e.err;
  }
}

TEST(RecordVerbs, events_are_recorded) {
  const std::string file = out_file("events.mcap");
  const Ended e = run_program(
      run_arguments({"--lockstep", "--duration", "3", "--record", file, "--fault", "unplug@0.8"}));
  EXPECT_EQ(e.code, 6) << e.err;
  std::vector<std::string> kinds;
  for (const SessionEvent& event : read_recording(file).events)
    kinds.push_back(event_name(event.kind));
  for (const char* kind : {"grasped", "armed", "fault", "disarmed"}) {
    EXPECT_NE(std::find(kinds.begin(), kinds.end(), kind), kinds.end()) << kind;
  }
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), "fault"), 1);
}

TEST(RecordVerbs, damaged_recordings_are_refused) {
  const std::string file = out_file("damaged.mcap");
  run_ball({"--lockstep", "--duration", "0.2", "--record", file});
  const std::string whole = read_text(file);
  const auto expect_refused = [&](const std::string& name, const std::string& bytes) {
    const std::string path = write_text(name, bytes);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"replay", path}, {"export", path, "-o", path + ".csv"}}) {
      const Ended e = run_program(arguments);
      EXPECT_EQ(e.code, 4) << name << e.out;
      EXPECT_EQ(e.err.rfind("thigma: " + path + ": ", 0), 0u) << e.err;
      EXPECT_LT(e.peak_mib, kMostMib);
      EXPECT_FALSE(fs::exists(path + ".csv"));
    }
  };
  expect_refused("empty.mcap", "");
  expect_refused("text.mcap", "frame,time\n");
  // A record that claims to be as long as the address space.
  std::string lying = whole;
  lying.replace(9, 8, 8, '\xff');
  expect_refused("lying.mcap", lying);
}

TEST(RecordVerbs, export_has_a_row_a_frame) {
  const std::string file = out_file("rows.mcap"), csv = out_file("rows.csv");
  run_ball({"--lockstep", "--duration", "0.3", "--record", file});
  const Ended e = run_program({"export", file, "-o", csv, "--json"});
  EXPECT_EQ(e.code, 0) << e.err;
  EXPECT_EQ(json_line(e)["frames"], 300);
  std::istringstream text(read_text(csv));
  std::string line;
  std::getline(text, line);
  const auto columns = std::count(line.begin(), line.end(), ',');
  EXPECT_NE(line.find("command fx [N]"), std::string::npos) << line;
  int rows = 0;
  for (; std::getline(text, line); ++rows)
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
  EXPECT_EQ(rows, 300);
  const Ended folder = run_program({"export", file, "-o", work_folder().string()});
  EXPECT_EQ(folder.code, 1);
  expect_one_line(folder, work_folder().string() + ": ");
}

TEST(RecordVerbs, plot_draws_what_was_recorded) {
  const std::string file = out_file("drawn.mcap"), png = out_file("drawn.png");
  run_ball({"--lockstep", "--duration", "0.3", "--record", file});
  const Ended e = run_program({"plot", file, "-o", png, "--json"});
  EXPECT_EQ(e.code, 0) << e.err;
  EXPECT_EQ(json_line(e)["frames"], 300);
  const std::string drawn = read_text(png);
  EXPECT_EQ(drawn.substr(1, 3), "PNG");
  EXPECT_GT(drawn.size(), 10000u);
  for (const std::string ending : {".svg", ".pdf"}) {
    const std::string lines = out_file("drawn" + ending);
    EXPECT_EQ(run_program({"plot", file, "-o", lines}).code, 0);
    EXPECT_GT(fs::file_size(lines), 10000u) << lines;
  }
  const Ended jpg = run_program({"plot", file, "-o", out_file("drawn.jpg")});
  EXPECT_EQ(jpg.code, 2);
  EXPECT_NE(jpg.err.find(".png, .svg or .pdf"), std::string::npos) << jpg.err;
  const Ended folder = run_program({"plot", file, "-o", work_folder().string()});
  EXPECT_EQ(folder.code, 1);
  expect_one_line(folder, work_folder().string() + ": ");
  const Ended other = run_program({"plot", png, "-o", png});
  EXPECT_EQ(other.code, 4);
  expect_one_line(other, png + ": ");
}

/// A recording of a world by the clock, and what the program says of it.
nlohmann::json record_world(const std::string& file) {
  const std::string scene = std::string(THIGMA_SOURCE_DIR) + "/scenes/row_of_blocks.toml";
  const Ended e = run_program(
      {"run", scene, "--headless", "--duration", "0.1", "--json", "--quiet", "--record", file});
  EXPECT_EQ(e.code, 0) << e.err;
  return json_line(e);
}

TEST(RecordVerbs, haptic_steps_that_a_world_left_out_at_its_end_are_known) {
  const std::string file = out_file("steps.mcap"), lost = out_file("lost_steps.mcap");
  const nlohmann::json run = record_world(file);
  EXPECT_EQ(run["dropped_samples"], 0);
  const std::string steps = std::to_string(run["hands"][0]["haptic"]["frames"].get<int>());
  const nlohmann::json whole = json_line(run_program({"replay", file, "--json"}));
  EXPECT_EQ(whole["identical"], true) << whole;
  EXPECT_EQ(whole["haptic"]["lost"], 0);
  const std::string words = "\"haptic_steps\":[";
  copy_recording(file, lost, [&](const std::string&, const McapMessage& message) {
    std::string data(message.data);
    if (const std::size_t at = data.find(words + steps + "]"); at != std::string::npos)
      data.insert(at + words.size(), "1");
    return data;
  });
  const Ended e = run_program({"replay", lost, "--json"});
  EXPECT_EQ(e.code, 5) << e.err;
  const nlohmann::json replay = json_line(e);
  EXPECT_EQ(replay["identical"], false);
  EXPECT_TRUE(replay["first_difference"].is_null());
  EXPECT_TRUE(replay["haptic"]["first_difference"].is_null());
  EXPECT_EQ(replay["haptic"]["lost"].get<int>(), std::stoi("1" + steps) - std::stoi(steps));
}

TEST(RecordVerbs, a_world_without_a_frame_is_replayed_to_its_end) {
  const std::string file = out_file("world.mcap"), none = out_file("no_frame.mcap");
  record_world(file);
  copy_recording(file, none, [](const std::string& topic, const McapMessage& message) {
    return topic == "/config" ? std::optional(std::string(message.data)) : std::nullopt;
  });
  const Ended e = run_program({"replay", none, "--json"}, 60.0);
  EXPECT_EQ(e.code, 0) << e.err;
  EXPECT_EQ(json_line(e)["frames"], 0);
  EXPECT_EQ(json_line(e)["recorded_frames"], 0);
}

TEST(RecordVerbs, a_recording_not_named_so_is_told_of_and_written) {
  const std::string scene = std::string(THIGMA_SOURCE_DIR) + "/scenes/row_of_blocks.toml";
  for (const std::vector<std::string>& what :
       {std::vector<std::string>{scene}, {"--object", kBall, "--against", kBall}}) {
    for (const char* name : {"recording.txt", "recording.mcap"}) {
      const std::string file = out_file(name);
      std::vector<std::string> arguments = {"run",  "--headless", "--lockstep", "--duration",
                                            "0.02", "--json",     "--record",   file};
      arguments.insert(arguments.end(), what.begin(), what.end());
      const Ended e = run_program(arguments);
      EXPECT_EQ(e.code, 0) << e.err;
      const bool is_told = e.err.find(file + ": not named .mcap") != std::string::npos;
      EXPECT_EQ(is_told, file.ends_with(".txt")) << e.err;
      EXPECT_EQ(run_program({"replay", file, "--json"}).code, 0);
    }
  }
}

TEST(RecordVerbs, an_unwritable_place_is_told_before_the_run) {
  for (const std::string& place : {std::string("/proc/x.mcap"), out_file("no_folder/x.mcap"),
                                   work_folder().string(), std::string("/dev/null")}) {
    const Ended e = run_program(
        run_arguments({"--lockstep", "--duration", "1000000", "--record", place}), 60.0);
    EXPECT_EQ(e.code, 1) << place << e.err;
    expect_one_line(e, place + ": ");
    EXPECT_TRUE(e.out.empty());
  }
}

/// The command after `fault` of the recording is zero, to its end; returns when the last force was
/// sent.
void expect_zero_after(const Recording& recording, double fault, double within) {
  ASSERT_FALSE(recording.frames.empty());
  bool had_force = false;
  for (const HapticSample& frame : recording.frames) {
    const double size = frame.command.force.norm() + frame.command.torque.norm();
    had_force = had_force || size > 0.0;
    if (frame.time > fault + within + 1e-9) {
      EXPECT_EQ(size, 0.0) << frame.time;
    }
  }
  EXPECT_TRUE(had_force) << "a fault while nothing pushes shows nothing";
  EXPECT_EQ(recording.frames.back().command.force.norm(), 0.0);
}

TEST(RecordVerbs, faults_end_in_zero_force) {
  const struct {
    const char *fault, *name;
    double within;  // [s] after the fault
  } faults[] = {{"unplug@0.8", "device_lost", 0.0},
                {"nan@0.8", "not_finite", 0.0},
                {"stall=0.2@0.8", "contact_stale", 0.050},
                {"hang=0.1@0.8", "watchdog", 0.101}};
  for (const bool is_lockstep : {true, false}) {
    for (const auto& f : faults) {
      const std::string file = out_file("fault.mcap");
      std::vector<std::string> more = {"--duration", "3", "--record", file, "--fault", f.fault};
      if (is_lockstep) more.push_back("--lockstep");
      Ended e = run_program(run_arguments(more));
      for (int i = 0; i < 4 && e.err.find(f.name) == std::string::npos; ++i) {
        e = run_program(run_arguments(more));  // the machine's own fault came first
      }
      EXPECT_EQ(e.code, 6) << f.fault << e.err;
      expect_one_line(e, std::string("safety fault ") + f.name);
      const nlohmann::json summary = json_line(e);
      ASSERT_FALSE(summary["safety_events"].empty()) << summary;
      EXPECT_EQ(summary["safety_events"][0]["fault"], f.name);
      // The threaded session may be late by what the machine is busy with; its frames tell.
      expect_zero_after(read_recording(file), 0.8, f.within + (is_lockstep ? 0.001 : 0.002));
      EXPECT_EQ(json_line(run_program({"replay", file, "--json"}))["identical"], true) << f.fault;
    }
  }
}

/// Sends the signal well into the session, when the recording has grown.
Ended stopped_run(int signal, const std::vector<std::string>& more, const std::string& file) {
  fs::remove(file);
  Program program(run_arguments(more));
  const auto has_grown = [&] {
    std::error_code none;
    const auto size = fs::file_size(file + ".part", none);
    return !none && size > 3'000'000;
  };
  for (int i = 0; i < 6000 && !has_grown() && !fs::exists(file); ++i) usleep(10'000);
  program.send(signal);
  return program.finish(30.0);
}

TEST(RecordVerbs, a_stop_signal_ends_in_order) {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT, SIGTSTP}) {
    for (const bool is_lockstep : {true, false}) {
      const std::string file = out_file("stopped.mcap");
      std::vector<std::string> more = {"--record", file};
      if (is_lockstep) more.push_back("--lockstep");
      const Ended e = undisturbed([&] { return stopped_run(signal, more, file); }, 130);
      EXPECT_EQ(e.code, 130) << e.err;
      EXPECT_TRUE(json_line(e)["safety_events"].empty());
      if (signal == SIGTSTP) {
        expect_one_line(e, "a session cannot be suspended");
      } else {
        EXPECT_TRUE(e.err.empty()) << e.err;
      }
      EXPECT_FALSE(fs::exists(file + ".part"));
      const Recording recording = read_recording(file);
      EXPECT_TRUE(recording.has_end);
      EXPECT_GT(recording.frames.size(), 100u);
      EXPECT_EQ(json_line(run_program({"replay", file, "--json"}))["identical"], true);
    }
  }
}

// Nobody holds the object: it falls, and comes to rest.
TEST(RecordVerbs, a_scene_that_simulates_itself) {
  const std::string scene = out_file("falls.toml"), file = out_file("falls.mcap");
  std::ofstream(scene) << "gravity = [0.0, 0.0, -9.81]\n[object]\nmesh = "
                          "\"procedural:ball?triangles=320\"\nunit_scale = 0.1\n"
                          "position = [0.0, 0.0, 0.25]\nmass = 0.05\n[[static]]\nmesh = "
                          "\"procedural:ball?triangles=320\"\n"
                          "unit_scale = 0.1\n[contact]\nexact = true\n[simulation]\nscatter = "
                          "1e-3\n[device]\nuri = \"null:\"\n";
  const auto play = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {
        "run",    scene,     "--device",   "null:",      "--headless",
        "--json", "--quiet", "--lockstep", "--duration", "0.4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, 0) << e.err;
    return json_line(e);
  };
  const nlohmann::json once = play({"--record", file});
  EXPECT_EQ(once["haptic"]["frames"], 400);
  EXPECT_GT(once["simulation"]["impulses"].get<int>(), 0);
  EXPECT_LE(once["simulation"]["energy"]["end"].get<double>(),
            once["simulation"]["energy"]["start"].get<double>());
  EXPECT_EQ(once["state_hash"], play({})["state_hash"]);
  EXPECT_NE(once["state_hash"], play({"--seed", "2"})["state_hash"]);
  const Ended replayed = run_program({"replay", file, "--json"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_EQ(json_line(replayed)["identical"], true);
  const Ended held =
      run_program({"run", scene, "--device", "hand:", "--headless", "--quiet", "--duration", "1"});
  EXPECT_EQ(held.code, 2) << held.err;
}

// The scene that ships, with its levels of detail and fewer triangles: nothing is deeper than the
// tolerance for 10 s.
TEST(RecordVerbs, the_spoon_stays_out_of_the_cup) {
  std::string text = read_text(std::string(THIGMA_SOURCE_DIR) + "/scenes/spoon_in_cup.toml");
  for (const auto& [from, to] : {std::pair{"86016", "24000"}, std::pair{"64000", "24000"}}) {
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::strlen(from), to);
  }
  constexpr double kLimit = 900.0;  // under a sanitizer [s]
  const Ended e =
      run_program({"run", write_text("spoon.toml", text), "--device", "null:", "--headless",
                   "--json", "--quiet", "--lockstep", "--duration", "10"},
                  kLimit);
  ASSERT_EQ(e.code, 0) << e.err;
  const nlohmann::json said = json_line(e);
  EXPECT_GT(said["contact"]["level_changes"].get<int>(), 0);
  EXPECT_GT(said["simulation"]["events"].get<int>(), 5);
  EXPECT_TRUE(said["simulation"]["at_rest"].get<bool>());
  EXPECT_EQ(said["simulation"]["unresolved"], 0);
  EXPECT_LE(said["simulation"]["deepest"].get<double>(),
            said["simulation"]["tolerance"].get<double>());
  EXPECT_LE(said["penetration_max"].get<double>(), said["simulation"]["tolerance"].get<double>());
  EXPECT_LE(said["simulation"]["energy"]["growth_max"].get<double>(),
            1e-6 * said["simulation"]["energy"]["start"].get<double>());
}

}  // namespace
}  // namespace thigma::test
