// Recordings that a page asks for where the folder cannot hold them.

#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <map>
#include <string>

#include "support/file_limit.h"
#include "viewer/live_program.h"
#include <gtest/gtest.h>

#include "thigma/files/file.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kFull = 2 << 20;  // [byte]

TEST(LiveRecordings, AFolderThatTakesNoFilesRefusesTheRecording) {
  RunningProgram run("record_nowhere", {"--device", "null:"});
  ASSERT_TRUE(run.client);
  fs::remove_all(run.folder);
  write_text("record_nowhere", "a file in the place of the folder");
  run.expect_refused({R"({"type":"record","id":1,"value":true})"});
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRecordings, TheMenuTellsCutRecordingsFromThoseThatGrow) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"old.mcap.part", "cut"}, {"older.mcap.part.2", "cut"}, {"a.mcap.part.x", "no name of ours"}};
  RunningProgram run("record_menu", {"--device", "null:", "--record", "now.mcap"}, files);
  ASSERT_TRUE(run.client);
  const auto titles = [&] {
    WebClient late(run.port);
    std::map<std::string, std::string> found;
    const Json menu = message_where(late, "menu", [](const Json& m) {
      return m["recordings"].dump().find("now.mcap") != std::string::npos;
    });
    for (const Json& item : menu["recordings"])
      found[item["name"].get<std::string>()] = item["title"].get<std::string>();
    return found;
  };
  const std::map<std::string, std::string> found = titles();
  ASSERT_EQ(found.count("now.mcap.part"), 1u);
  EXPECT_EQ(found.at("now.mcap.part"), "now.mcap, being written");
  EXPECT_EQ(found.at("old.mcap.part"), "old.mcap, cut off");
  EXPECT_EQ(found.at("older.mcap.part.2"), "older.mcap, cut off");
  EXPECT_EQ(found.size(), 3u);
  EXPECT_EQ(run.end().code, 130);
}

/// A file in pieces that a message may hold.
void upload_in_pieces(WebClient& client, int id, const std::string& name,
                      const std::string& bytes) {
  constexpr std::size_t kPiece = 60000;
  client.send_text(
      Json{{"type", "upload"}, {"id", id}, {"name", name}, {"value", bytes.size()}}.dump());
  for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
    const std::string piece = bytes.substr(at, kPiece);
    std::string head("\x21\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16);
    const auto size = static_cast<std::uint32_t>(piece.size());
    std::memcpy(head.data() + 4, &size, 4);
    client.send_binary(head + piece);
  }
}

TEST(LiveRecordings, ADroppedRecordingIsShownWithItsForceAndInSlowMotion) {
  const std::string file = out_file("dropped.mcap");
  const Ended made =
      run_program({"run", "ellipsoid", "--exact", "--headless", "--lockstep", "--duration", "1",
                   "--device", "hand:", "--record", file, "--quiet"});
  ASSERT_EQ(made.code, 0) << made.err;
  RunningProgram run("record_dropped", {"--device", "null:"}, {}, "ellipsoid");
  ASSERT_TRUE(run.client);
  upload_in_pieces(*run.client, 5, "mine.mcap", read_file(file));
  const Json strip = message_where(*run.client, "strip", [](const Json&) { return true; });
  ASSERT_FALSE(strip.is_null()) << run.program->said();
  EXPECT_EQ(strip["force"].size(), 300u);
  EXPECT_NEAR(strip["seconds"].get<double>(), 1.0, 0.01);
  const Json shown = state_where(*run.client, [](const Json& s) { return !s["replay"].is_null(); });
  ASSERT_FALSE(shown.is_null());
  EXPECT_TRUE(shown["replay"]["file"].get<std::string>().ends_with("mine.mcap"));
  EXPECT_EQ(shown["replay"]["speed"], 1.0);
  EXPECT_TRUE(ask(*run.client, R"({"type":"speed","id":6,"value":0.25})")["ok"].get<bool>());
  const Json slow =
      state_where(*run.client, [](const Json& s) { return s["replay"]["speed"] == 0.25; });
  EXPECT_FALSE(slow.is_null());
  EXPECT_FALSE(ask(*run.client, R"({"type":"speed","id":7,"value":5})")["ok"].get<bool>());
  upload_in_pieces(*run.client, 8, "broken.mcap", "not a recording");
  const Json refused =
      message_where(*run.client, "ack", [](const Json& a) { return a["id"] == 8; });
  EXPECT_FALSE(refused["ok"].get<bool>());
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRecordings, AFullDiskEndsTheRecordingAndNotTheSession) {
  std::unique_ptr<RunningProgram> run;
  {
    const FileLimit limit(kFull);
    run = std::make_unique<RunningProgram>("record_full",
                                           std::vector<std::string>{"--device", "null:"});
  }
  ASSERT_TRUE(run->client);
  ASSERT_TRUE(ask(*run->client, R"({"type":"record","id":1,"value":true})")["ok"].get<bool>());
  const Json recording =
      state_where(*run->client, [](const Json& s) { return !s["recording"].is_null(); });
  ASSERT_FALSE(recording.is_null());
  const Json told = message_where(*run->client, "event",
                                  [](const Json& e) { return e["kind"] == "recording_ended"; });
  ASSERT_FALSE(told.is_null()) << run->program->said();
  EXPECT_EQ(told["detail"], recording["recording"]);
  EXPECT_NE(told["text"].get<std::string>().find("cannot be written"), std::string::npos);
  const Json after =
      state_where(*run->client, [](const Json& s) { return s["recording"].is_null(); });
  ASSERT_FALSE(after.is_null());
  EXPECT_EQ(after["session"], recording["session"]);
  run->expect_goes_on(after);
  // Once more: the page may try again, and what was locked for the recording is free.
  EXPECT_TRUE(
      ask(*run->client, R"({"type":"set","id":2,"name":"mass","value":0.02})")["ok"].get<bool>());
  const Ended e = run->end();
  EXPECT_EQ(e.code, 130);
  EXPECT_GT(json_line(e)["haptic"]["frames"].get<int>(), 0);  // the summary
  const std::size_t first = e.err.find("the recording ends there");
  ASSERT_NE(first, std::string::npos) << e.err;
  EXPECT_EQ(e.err.find("the recording ends there", first + 1), std::string::npos) << e.err;
}

// On threads, with a page that looks on: what may befall a recording while it is written.
struct Mishap {
  const char* name;
  void (*happens)(RunningProgram& run, const std::string& file);
  const char* says;  // on the page and on standard error, once; null: nothing befalls it
};

void folder_vanishes(RunningProgram& run, const std::string&) { fs::remove_all(run.folder); }

// Whoever may not write a folder cannot give the recording its name; root may write any, but a
// folder in the place of the name is in everyone's way.
void folder_becomes_read_only(RunningProgram& run, const std::string& file) {
  fs::create_directory(run.folder / file);
  write_text((fs::path(run.folder.filename()) / file / "x").string(), "x");
  fs::permissions(run.folder, fs::perms::owner_read | fs::perms::owner_exec);
}

void nothing(RunningProgram&, const std::string&) {}

std::size_t times(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(LiveRecordings, WhateverBefallsARecordingTheSessionGoesOnAndSaysSoOnce) {
  for (const Mishap& mishap : {Mishap{"vanishes", folder_vanishes, "recording"},
                               Mishap{"read_only", folder_becomes_read_only, "recording"},
                               Mishap{"untouched", nothing, nullptr}}) {
    SCOPED_TRACE(mishap.name);
    const std::string name = std::string("mishap_") + mishap.name;
    RunningProgram run(name, {"--device", "null:"});
    ASSERT_TRUE(run.client);
    ASSERT_TRUE(ask(*run.client, R"({"type":"record","id":1,"value":true})")["ok"].get<bool>());
    const Json recording =
        state_where(*run.client, [](const Json& s) { return !s["recording"].is_null(); });
    ASSERT_FALSE(recording.is_null());
    run.expect_goes_on(recording);
    mishap.happens(run, recording["recording"].get<std::string>());
    const Json now = run.running();
    ASSERT_FALSE(now.is_null());
    run.expect_goes_on(now);
    const Ended e = run.end();
    std::error_code ignored;
    fs::permissions(run.folder, fs::perms::owner_all, ignored);
    EXPECT_TRUE(e.code == 130 || e.code == 1) << e.code << e.err;
    EXPECT_GT(json_line(e)["haptic"]["frames"].get<int>(), 100);
    EXPECT_TRUE(json_line(e)["safety_events"].empty());
    if (mishap.says == nullptr)
      EXPECT_EQ(times(e.err, "cannot be"), 0u) << e.err;
    else
      EXPECT_EQ(times(e.err, recording["recording"].get<std::string>() + ": "), 1u) << e.err;
  }
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(LiveRecordings, AClockThatIsSetBackTouchesNoSession) {
  ::setenv("LD_PRELOAD", THIGMA_CLOCK_BACK, 1);
  std::unique_ptr<RunningProgram> run = std::make_unique<RunningProgram>(
      "clock_back", std::vector<std::string>{"--device", "null:", "--record", "back.mcap"});
  long wall = 0;  // as programs see it
  FILE* const seen = ::popen("date +%s", "r");
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(std::fscanf(seen, "%ld", &wall), 1);
  ::pclose(seen);
  ::unsetenv("LD_PRELOAD");
  EXPECT_LT(wall, std::time(nullptr) - 3000);
  ASSERT_TRUE(run->client);
  const Json before = run->running();
  ASSERT_FALSE(before.is_null());
  run->expect_goes_on(before);
  const fs::path file = run->folder / "back.mcap";
  const Ended e = run->end();
  EXPECT_EQ(e.code, 130) << e.err;
  EXPECT_TRUE(json_line(e)["safety_events"].empty());
  const Ended replayed = run_program({"replay", file.string(), "--json"});
  EXPECT_EQ(json_line(replayed)["identical"], true) << replayed.err;
}
#endif

TEST(LiveRecordings, WithoutAPageAFullDiskEndsTheRecordingAndTheSummarySaysTheRest) {
  const FileLimit limit(kFull);
  const Ended e =
      run_program(run_arguments({"--device", "null:", "--headless", "--lockstep", "--duration",
                                 "30", "--record", out_file("full.mcap")}));
  EXPECT_EQ(e.code, 1);  // what was asked for is not there
  EXPECT_NE(e.err.find("the recording ends there"), std::string::npos) << e.err;
  EXPECT_EQ(json_line(e)["haptic"]["frames"], 30000);
}

}  // namespace
}  // namespace thigma::test
