// Kills, full disks and failing calls at every call that changes the disk: a recording is then a
// prefix of what was written, an asset is the old one or the new one, and nothing is ever anything
// else.

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "recording/recording_samples.h"
#include "support/faulty_disk.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/files/growing_file.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;
using test::DiskFault;
using test::survives;
using test::with_disk;

constexpr std::uint64_t kFrames = 60;

fs::path fresh_folder(const char* name) {
  const fs::path folder =
      fs::path(::testing::TempDir()) / ("thigma_" + std::string(name) + std::to_string(::getpid()));
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/// A session of a frame every 40 ms, so that a few chunks are flushed.
HapticSample slow_sample(std::uint64_t frame) {
  HapticSample s = test::sample(frame);
  s.time = 0.04 * static_cast<double>(frame);
  s.input_digest = input_digest(s);
  return s;
}

/// Writes it; what the writer refused with, once, or "".
std::string record(const std::string& path) {
  std::string why;
  const auto attempt = [&](const auto& work) {
    try {
      work();
    } catch (const IoError& error) {
      EXPECT_EQ(why, "") << "said once, but again: " << error.what();
      why = error.what();
    }
  };
  std::unique_ptr<RecordingWriter> writer;
  attempt([&] { writer = std::make_unique<RecordingWriter>(path, R"({"version":1})"); });
  for (std::uint64_t i = 0; writer && i < kFrames; ++i) {
    if (i % 10 == 0) attempt([&] { writer->write(test::contact_sample(i / 10)); });
    attempt([&] { writer->write(slow_sample(i)); });
  }
  if (writer) attempt([&] { writer->close({.frames = kFrames, .state_hash = 1, .dropped = 0}); });
  return why;
}

/// Frames that a file gives back, each with its bits; 0 for what is refused with a reason.
std::size_t frames_of(const std::string& path, bool& is_whole) {
  Recording r;
  try {
    r = read_recording(path);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(path + ": ", 0), 0u) << error.what();
    return 0;
  }
  is_whole = r.cut_off.empty();
  EXPECT_TRUE(!is_whole || (r.has_end && r.frames.size() == kFrames)) << r.cut_off;
  EXPECT_EQ(r.warnings.size(), is_whole ? 0u : 1u);
  for (std::size_t i = 0; i < r.frames.size(); ++i) {
    const HapticSample want = slow_sample(i);
    EXPECT_EQ(r.frames[i].frame, i);
    EXPECT_EQ(input_digest(r.frames[i]), want.input_digest);
    EXPECT_EQ(r.frames[i].body.position, want.body.position);
    EXPECT_EQ(r.frames[i].command.torque, want.command.torque);
    EXPECT_EQ(r.frames[i].step_cpu, want.step_cpu) << "the last message of a frame";
  }
  for (std::size_t i = 0; i < r.contacts.size(); ++i)
    EXPECT_EQ(model_digest(r.contacts[i].model), test::contact_sample(i).model_digest);
  return r.frames.size();
}

TEST(PowerCut, a_recording_killed_at_any_call_is_a_prefix) {
  const fs::path folder = fresh_folder("killed");
  const std::string path = folder / "x.mcap";
  std::size_t most = 0;
  bool is_over = false;
  int calls = 0;
  for (; !is_over && calls < 1000; ++calls) {
    fs::remove(path);
    fs::remove(path + ".part");
    is_over = survives({.dies_at = calls}, [&] { record(path); });
    const bool has_place = fs::exists(path);
    bool is_whole = false;
    const std::size_t frames = frames_of(has_place ? path : path + ".part", is_whole);
    EXPECT_TRUE(!has_place || is_whole) << "what has its name is whole: " << calls;
    EXPECT_GE(frames, most) << "what was flushed stays: " << calls;
    most = std::max(most, frames);
    EXPECT_LE(fs::exists(path) + fs::exists(path + ".part"), 1);
  }
  EXPECT_TRUE(is_over);
  EXPECT_GT(calls, 10);
  EXPECT_EQ(most, kFrames);
  fs::remove_all(folder);
}

TEST(PowerCut, a_recording_refused_at_any_call_is_kept_and_said_once) {
  const fs::path folder = fresh_folder("refused");
  const std::string path = folder / "x.mcap";
  const auto clear = [&] {
    fs::remove(path);
    fs::remove(path + ".part");
  };
  const auto place = [&] { return fs::exists(path) ? path : path + ".part"; };
  const auto calls = static_cast<int>(with_disk({}, [&] { record(path); }).size());
  ASSERT_GT(calls, 10);
  for (int n = 0; n < calls; ++n) {
    clear();
    bool is_whole = false;
    survives({.dies_at = n}, [&] { record(path); });
    const std::size_t flushed = fs::exists(place()) ? frames_of(place(), is_whole) : 0;
    for (const bool recovers : {false, true}) {
      clear();
      std::string why;
      with_disk({.fails_from = n, .fails_to = recovers ? n + 1 : 1 << 30},
                [&] { why = record(path); });
      if (!fs::exists(place())) {
        EXPECT_NE(why, "") << n;
        EXPECT_EQ(flushed, 0u) << "flushed and gone: " << n << ": " << why;
        continue;
      }
      is_whole = false;
      EXPECT_GE(frames_of(place(), is_whole), flushed) << n;
      EXPECT_TRUE(why != "" || is_whole) << n << ": it is not all there, and nothing was said";
      if (why.find(" s are in ") != std::string::npos) {
        EXPECT_EQ(why.substr(why.size() - place().size()), place()) << why;
      }
    }
  }
  fs::remove_all(folder);
}

TEST(PowerCut, a_full_disk_leaves_room_for_the_end) {
  const fs::path folder = fresh_folder("full");
  const std::string path = folder / "x.mcap";
  record(path);
  const auto size = static_cast<std::int64_t>(fs::file_size(path));
  int closed = 0;
  for (std::int64_t capacity = 0; capacity < size; capacity += size / 40) {
    fs::remove(path);
    fs::remove(path + ".part");
    std::string why;
    with_disk({.capacity = capacity}, [&] { why = record(path); });
    EXPECT_NE(why, "") << capacity;
    EXPECT_FALSE(fs::exists(path + ".part")) << why;
    if (!fs::exists(path)) continue;  // not even a first frame
    ++closed;
    bool is_whole = true;
    EXPECT_GT(frames_of(path, is_whole), 0u);
    EXPECT_FALSE(is_whole);
    EXPECT_EQ(read_mcap(path).cut, "") << "a whole MCAP file, of the first part of the session";
    EXPECT_LE(fs::file_size(path), static_cast<std::uintmax_t>(capacity));
  }
  EXPECT_GT(closed, 20);
  fs::remove_all(folder);
}

TEST(PowerCut, an_asset_killed_or_refused_at_any_call_is_the_old_one_or_the_new_one) {
  const fs::path folder = fresh_folder("asset");
  const std::string path = folder / "a.clod", before(3000, 'a'), after(5000, 'b');
  bool is_over = false;
  int calls = 0;
  for (; !is_over && calls < 100; ++calls) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    write_file(path, before);
    is_over = survives({.dies_at = calls}, [&] { write_file(path, after); });
    const std::string now = read_file(path);
    EXPECT_TRUE(now == before || now == after) << calls << ": " << now.size() << " bytes";
    EXPECT_TRUE(!is_over || now == after);
    write_file(path, before);  // what is left of the first is in nobody's way
    EXPECT_EQ(read_file(path), before);
  }
  EXPECT_TRUE(is_over);
  EXPECT_GE(calls, 5);
  for (int n = 0; n < 3; ++n) {  // write, fsync, rename
    fs::remove_all(folder);
    fs::create_directories(folder);
    write_file(path, before);
    bool is_refused = false;
    with_disk({.fails_from = n, .error = EIO}, [&] {
      try {
        write_file(path, after);
      } catch (const IoError&) {
        is_refused = true;
      }
    });
    EXPECT_TRUE(is_refused) << n;
    EXPECT_EQ(read_file(path), before) << n;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1) << n;
  }
  fs::remove_all(folder);
}

TEST(PowerCut, bytes_are_on_the_disk_before_their_name_and_the_name_after) {
  const fs::path folder = fresh_folder("order");
  const std::string path = folder / "a";
  const std::vector<std::string> expected = {"write", "fsync", "rename", "fsync"};
  EXPECT_EQ(with_disk({}, [&] { write_file(path, "bytes"); }), expected);
  std::vector<std::string> calls = with_disk({}, [&] {
    GrowingFile file(path);
    file.append("bytes");
    file.keep();
  });
  ASSERT_GE(calls.size(), 4u);
  calls.erase(calls.begin(), calls.end() - 3);
  EXPECT_EQ(calls, (std::vector<std::string>{"fsync", "rename", "fsync"}));
  fs::remove_all(folder);
}

TEST(PowerCut, what_was_recorded_reaches_the_disk_every_two_seconds) {
  const fs::path folder = fresh_folder("synced");
  std::vector<std::string> calls;
  calls = with_disk({}, [&] {
    GrowingFile file(folder / "a");
    file.append("bytes");
    // At least three intervals on any machine; how many syncs there were in them is not asked.
    ::usleep(3 * kSyncSeconds * 1'000'000);
    file.append("more");
  });
  EXPECT_NE(std::find(calls.begin(), calls.end(), "fdatasync"), calls.end());
  fs::remove_all(folder);
}

TEST(PowerCut, a_disk_that_cannot_sync_is_told) {
  const fs::path folder = fresh_folder("unsynced");
  with_disk({}, [&] {
    GrowingFile file(folder / "a");
    file.append("bytes");
  });
  std::string why;
  try {
    GrowingFile file(folder / "b");
    file.append("bytes");
    with_disk({.fails_from = 0, .error = EIO}, [&] { file.keep(); });
  } catch (const IoError& error) {
    why = error.what();
  }
  EXPECT_NE(why.find("Input/output error"), std::string::npos) << why;
  EXPECT_FALSE(fs::exists(folder / "b"));
  EXPECT_EQ(read_file(folder / "b.part"), "bytes");
  fs::remove_all(folder);
}

TEST(PowerCut, a_clock_that_is_set_back_changes_nothing) {
  const fs::path folder = fresh_folder("clock");
  const std::string path = folder / "x.mcap";
  SessionConfig config = test::plane_session();
  config.duration = 0.6;
  config.haptic.safety.watchdog = 5.0;
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  config.haptic.safety.pose_jump = 1.0;
  HandDevice device(test::plane_hand(HandPath::press, 0.005));
  SessionSummary summary;
  with_disk({}, [&] {
    RecordingWriter writer(path, "{}");
    Session session(config, device,
                    {[&](const HapticSample& s) { writer.write(s); },
                     [&](const ContactSample& s) { writer.write(s); },
                     [&](const SessionEvent& e) { writer.write(e); }});
    session.start();
    summary = session.finish();
    writer.close({summary.frames, summary.state_hash, summary.dropped_samples});
  });
  EXPECT_EQ(test::wall_clock_calls(), 0) << "only the monotonic clock is asked";
  EXPECT_EQ(summary.end, SessionEnd::duration);
  const Recording r = read_recording(path);
  EXPECT_TRUE(r.has_end);
  ASSERT_EQ(r.frames.size(), summary.frames);
  for (std::size_t i = 1; i < r.frames.size(); ++i)
    ASSERT_GT(r.frames[i].time, r.frames[i - 1].time);
  EXPECT_LT(r.frames.back().time, config.duration);
  // That the clock on the wall would have gone back:
  with_disk({}, [] {
    const std::time_t first = std::time(nullptr);
    EXPECT_LT(std::time(nullptr), first - 3000);
    const auto now = std::chrono::system_clock::now();
    EXPECT_LT(std::chrono::system_clock::now(), now);
  });
  EXPECT_EQ(test::wall_clock_calls(), 4);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace thigma
