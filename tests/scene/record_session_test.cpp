#include "thigma/scene/record_session.h"

#include <filesystem>

#include "support/copy_recording.h"
#include "support/small_jaws.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

TEST(RecordSession, ReplaysBitForBit) {
  const std::string path = (fs::temp_directory_path() / "thigma_record_session.mcap").string();
  const Scene scene = load_scene(test::small_jaws());
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.0, .seed = 7});
  const SessionSummary felt = record_lockstep(session, path);
  const Recording recording = read_recording(path);
  EXPECT_EQ(recording.frames.size(), felt.frames);
  const ReplayReport again = replay_recording(path);
  EXPECT_TRUE(again.identical) << again.reason;
  EXPECT_EQ(again.state_hash, felt.state_hash);
  EXPECT_GT(felt.force_max, 0.1);
  fs::remove(path);
}

TEST(RecordSession, FrictionReplaysBitForBit) {
  const std::string path = (fs::temp_directory_path() / "thigma_record_friction.mcap").string();
  for (const ResponseKind response : {ResponseKind::coupled, ResponseKind::direct,
                                      ResponseKind::constrained, ResponseKind::potential}) {
    SceneDescription description = test::small_jaws();
    description.contact.response = response;
    description.object.material = Material{{0.3, 0.5}};
    description.statics[0].material = Material{{0.4, 0.4}};
    const Scene scene = load_scene(std::move(description));
    SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.0, .seed = 7});
    const SessionSummary felt = record_lockstep(session, path);
    const ReplayReport again = replay_recording(path);
    EXPECT_TRUE(again.identical) << again.reason;
    EXPECT_EQ(again.state_hash, felt.state_hash);
    EXPECT_EQ(read_config(read_recording(path).config).friction, session.config.contact.friction);
    EXPECT_GT(felt.force_max, 0.1);
    fs::remove(path);
  }
}

TEST(RecordSession, ImpactsReplayBitForBitAndChangeNothingWhereTheyAreOff) {
  const std::string path = (fs::temp_directory_path() / "thigma_record_taps.mcap").string();
  std::uint64_t quiet = 0;
  for (const bool is_on : {false, true}) {
    SceneDescription description = test::small_jaws();
    description.contact.response = ResponseKind::constrained;
    description.taps.is_on = is_on;
    const Scene scene = load_scene(std::move(description));
    SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.0, .seed = 7});
    EXPECT_EQ(session.config.haptic.impacts.empty(), !is_on);
    const SessionSummary felt = record_lockstep(session, path);
    const ReplayReport again = replay_recording(path);
    EXPECT_TRUE(again.identical) << again.reason;
    EXPECT_EQ(again.state_hash, felt.state_hash);
    if (is_on) EXPECT_NE(felt.state_hash, quiet);
    quiet = felt.state_hash;
    fs::remove(path);
  }
}

TEST(RecordSession, SaysWhereItCannotWrite) {
  const Scene scene = load_scene(test::small_jaws());
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 0.1});
  EXPECT_THROW(record_lockstep(session, "/no/such/folder/session.mcap"), IoError);
}

TEST(RecordSession, RefusesToReplayFramesWithoutTheirConfiguration) {
  const std::string path = (fs::temp_directory_path() / "thigma_record_whole.mcap").string();
  const std::string without = (fs::temp_directory_path() / "thigma_record_part.mcap").string();
  const Scene scene = load_scene(test::small_jaws());
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 0.05});
  record_lockstep(session, path);
  test::copy_recording(path, without, [](const std::string& topic, const McapMessage& message) {
    return topic == "/config" ? std::nullopt : std::optional(std::string(message.data));
  });
  EXPECT_THROW(replay_recording(without), InputError);
  fs::remove(path);
  fs::remove(without);
}

TEST(RecordSession, RefusesToReplayWhatIsNoRecording) {
  EXPECT_THROW(replay_recording("/no/such/file.mcap"), InputError);
}

}  // namespace
}  // namespace thigma
