// Recordings that something ends before their session does: a kill, a full disk, a folder that
// goes, a second writer. What was flushed is read by every verb, and said to be a part.

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "apps/program.h"
#include "support/file_limit.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/recording/recording.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> loss_arguments(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run", "--object",   kBall,    "--against",
                                        kBall, "--headless", "--json", "--quiet"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Waits until the recording has more than `size` bytes on the disk, or the program is gone.
void wait_for_growth(const std::string& file, std::uintmax_t size) {
  for (int i = 0; i < 6000 && !fs::exists(file); ++i) {
    std::error_code none;
    const auto now = fs::file_size(file + ".part", none);
    if (!none && now > size) return;
    usleep(10'000);
  }
}

/// Leaves FILE.part of a session that was killed; returns its path.
std::string killed_recording(const std::string& name) {
  const std::string file = out_file(name);
  Program program(loss_arguments({"--lockstep", "--record", file}));
  wait_for_growth(file, 3'000'000);
  program.send(SIGKILL);
  EXPECT_EQ(program.finish().signal, SIGKILL);
  EXPECT_FALSE(fs::exists(file));
  return file + ".part";
}

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

/// One line that says where the recording ends, in time and bytes.
void expect_told_where_it_ends(const Ended& e, const std::string& path) {
  EXPECT_EQ(count(e.err, "thigma: " + path + ": the recording ends at "), 1u) << e.err;
  EXPECT_EQ(count(e.err, " frames, byte "), 1u) << e.err;
}

/// replay, export and plot take the recording; returns what replay says.
nlohmann::json expect_read_by_every_verb(const std::string& path) {
  const Ended replayed = run_program({"replay", path, "--json"});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  expect_told_where_it_ends(replayed, path);
  const nlohmann::json said = json_line(replayed);
  EXPECT_EQ(said["identical"], true) << said;
  EXPECT_TRUE(said["recorded_hash"].is_null()) << said;
  for (const std::string verb : {"export", "plot"}) {
    const std::string out = path + (verb == "plot" ? ".png" : ".csv");
    const Ended e = run_program({verb, path, "-o", out, "--json"});
    EXPECT_EQ(e.code, 0) << verb << e.err;
    expect_told_where_it_ends(e, path);
    EXPECT_EQ(json_line(e)["frames"], said["frames"]);
    EXPECT_TRUE(fs::exists(out));
  }
  return said;
}

TEST(RecordLoss, what_was_flushed_before_a_kill_is_read_by_every_verb) {
  const std::string part = killed_recording("killed.mcap");
  const nlohmann::json said = expect_read_by_every_verb(part);
  EXPECT_GT(said["frames"].get<int>(), 500);
  const std::string name = part.substr(0, part.rfind('.'));
  expect_one_line(run_program({"replay", name}), name + ": is not there, but");
  const Ended text = run_program({"replay", part, "--text"});
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("no recorded hash"), std::string::npos) << text.out;
  const Ended device = run_program(loss_arguments({"--lockstep", "--device", "replay:" + part}));
  EXPECT_EQ(device.code, 0) << device.err;
}

TEST(RecordLoss, the_page_shows_what_was_flushed) {
  const std::string part = killed_recording("shown.mcap");
  Program program(
      {"run", "--object", kBall, "--against", kBall, "--exact", "--port", "0", "--replay", part});
  ASSERT_TRUE(program.waits_for("Ctrl-C ends it")) << program.said();
  program.send(SIGINT);
  const Ended e = program.finish();
  EXPECT_EQ(e.code, 130) << e.err;
  EXPECT_EQ(count(e.err, part + ": the recording ends"), 1u) << e.err;
}

TEST(RecordLoss, any_cut_is_read_as_a_part_or_refused) {
  const std::string file = out_file("whole.mcap");
  ASSERT_EQ(run_program(loss_arguments({"--lockstep", "--duration", "1.6", "--record", file})).code,
            0);
  const std::string whole = read_text(file);
  std::size_t before = 0;
  for (const double share : {0.0, 0.001, 0.3, 0.6, 0.9, 0.999}) {
    const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
    const std::string cut = write_text("cut.mcap", whole.substr(0, size));
    const Ended e = run_program({"replay", cut, "--json"});
    if (e.code != 0) {
      EXPECT_EQ(e.code, 4) << share << e.err;
      expect_one_line(e, cut + ": ");
      EXPECT_LT(share, 0.3) << e.err;
      continue;
    }
    EXPECT_EQ(json_line(e)["identical"], true) << e.out;
    const auto frames = json_line(e)["frames"].get<std::size_t>();
    EXPECT_GE(frames, before);
    before = frames;
    expect_told_where_it_ends(e, cut);
  }
  EXPECT_GT(before, 1000u);
  // All that is missing is what nobody reads: the recorded hash is there, and compared.
  for (const std::size_t missing : {1u, 9u, 40u}) {
    const std::string cut = write_text("cut.mcap", whole.substr(0, whole.size() - missing));
    const Ended e = run_program({"replay", cut, "--json"});
    EXPECT_EQ(e.code, 0) << e.err;
    EXPECT_EQ(json_line(e)["frames"], 1600);
    EXPECT_FALSE(json_line(e)["recorded_hash"].is_null());
    expect_told_where_it_ends(e, cut);
  }
}

TEST(RecordLoss, a_full_disk_ends_the_recording_not_the_session) {
  const std::vector<std::string> session = {"--lockstep", "--duration", "3"};
  const nlohmann::json free = json_line(run_program(loss_arguments(session)));
  for (const bool is_lockstep : {true, false}) {
    const std::string file = out_file(is_lockstep ? "full.mcap" : "full_threaded.mcap");
    std::vector<std::string> more = {"--duration", "3", "--record", file};
    if (is_lockstep) more.push_back("--lockstep");
    const Ended e = [&] {
      const FileLimit limit(1'000'000);
      return run_program(loss_arguments(more));
    }();
    if (is_lockstep) {
      EXPECT_EQ(e.code, 1) << e.err;
      expect_one_line(e, file + ": cannot be written");
      EXPECT_EQ(json_line(e)["state_hash"], free["state_hash"]) << "the session went on";
    }
    EXPECT_EQ(count(e.err, file + ": "), 1u) << e.err;
    EXPECT_GT(json_line(e)["haptic"]["frames"].get<int>(), 1500);
    const std::string kept = fs::exists(file) ? file : file + ".part";
    EXPECT_NE(e.err.find(" s are in " + kept + ";"), std::string::npos)
        << "names the file: " << e.err;
    EXPECT_GT(expect_read_by_every_verb(kept)["frames"].get<int>(), 500);
  }
}

TEST(RecordLoss, a_full_disk_ends_the_recording_of_a_world_not_its_session) {
  const std::string scene = std::string(THIGMA_SOURCE_DIR) + "/scenes/row_of_blocks.toml";
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"run", scene,    "--headless", "--duration",
                                          "1.5", "--json", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  };
  const nlohmann::json free = json_line(run({"--lockstep"}));
  for (const bool is_lockstep : {true, false}) {
    const std::string file = out_file(is_lockstep ? "full_world.mcap" : "full_world_clock.mcap");
    std::vector<std::string> more = {"--record", file};
    if (is_lockstep) more.push_back("--lockstep");
    const Ended e = [&] {
      const FileLimit limit(300'000);
      return run(more);
    }();
    EXPECT_EQ(e.code, 1) << e.err;
    EXPECT_EQ(count(e.err, file + ": "), 1u) << e.err;
    EXPECT_NE(e.err.find("the session goes on"), std::string::npos) << e.err;
    if (is_lockstep) EXPECT_EQ(json_line(e)["state_hash"], free["state_hash"]);
    EXPECT_GT(json_line(e)["frames"].get<int>(), 50);
  }
}

TEST(RecordLoss, a_disk_full_from_the_start_is_told_before_the_session) {
  const std::string file = out_file("nothing.mcap");
  const FileLimit limit(100);
  const Ended e =
      run_program(loss_arguments({"--lockstep", "--duration", "1000000", "--record", file}), 60.0);
  EXPECT_EQ(e.code, 1);
  EXPECT_FALSE(fs::exists(file));
  EXPECT_FALSE(fs::exists(file + ".part"));
}

TEST(RecordLoss, two_processes_do_not_write_one_recording) {
  const std::string file = out_file("shared.mcap");
  Program first(loss_arguments({"--lockstep", "--record", file}));
  wait_for_growth(file, 1'000'000);
  const Ended second =
      run_program(loss_arguments({"--lockstep", "--duration", "1000000", "--record", file}), 60.0);
  EXPECT_EQ(second.code, 1) << second.err;
  expect_one_line(second, file + ": ");
  EXPECT_NE(second.err.find("another process"), std::string::npos) << second.err;
  EXPECT_NE(second.err.find("expected another name"), std::string::npos) << second.err;
  first.send(SIGINT);
  const Ended e = first.finish();
  EXPECT_EQ(e.code, 130) << e.err;
  const Ended replayed = run_program({"replay", file, "--json"});
  EXPECT_EQ(json_line(replayed)["identical"], true) << replayed.err;
  EXPECT_EQ(json_line(replayed)["state_hash"], json_line(e)["state_hash"]);
}

TEST(RecordLoss, a_second_session_leaves_what_a_killed_one_flushed) {
  const std::string part = killed_recording("again.mcap"), bytes = read_text(part);
  const std::string file = out_file("again.mcap");
  std::vector<std::string> arguments =
      loss_arguments({"--lockstep", "--duration", "0.3", "--record", file});
  arguments.erase(std::find(arguments.begin(), arguments.end(), "--quiet"));
  const Ended e = run_program(arguments);
  EXPECT_EQ(e.code, 0) << e.err;
  EXPECT_NE(e.err.find(part + ".1"), std::string::npos) << e.err;
  EXPECT_EQ(read_text(part + ".1"), bytes);
  EXPECT_EQ(run_program({"replay", file, "--quiet"}).code, 0);
  EXPECT_FALSE(fs::exists(part));
}

TEST(RecordLoss, a_folder_that_goes_ends_the_recording_not_the_session) {
  for (const bool is_moved : {false, true}) {
    const std::string folder = out_file("gone"), elsewhere = out_file("elsewhere");
    fs::create_directory(folder);
    const std::string file = folder + "/x.mcap";
    Program program(loss_arguments({"--lockstep", "--record", file}));
    wait_for_growth(file, 1'000'000);
    if (is_moved) fs::rename(folder, elsewhere);
    if (!is_moved) fs::remove_all(folder);
    usleep(200'000);
    program.send(SIGINT);
    const Ended e = program.finish();
    EXPECT_GT(json_line(e)["haptic"]["frames"].get<int>(), 100) << e.err;
    if (is_moved) {
      EXPECT_EQ(e.code, 130) << e.err;
      EXPECT_EQ(run_program({"replay", elsewhere + "/x.mcap", "--quiet"}).code, 0);
    } else {
      EXPECT_TRUE(e.code == 1 || e.code == 130) << e.code;
      expect_one_line(e, file + ": ");
    }
  }
}

}  // namespace
}  // namespace thigma::test
