#include "thigma/scene/record_session.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

Scene small_scene() {
  SceneDescription scene = read_scene("jaws");
  scene.object.mesh = "procedural:jaw_upper?triangles=4000";
  scene.object.model->triangles = 4000;
  scene.statics[0].mesh = "procedural:jaw_lower?triangles=4000";
  scene.statics[0].model->triangles = 4000;
  scene.contact.resolution.is_exact = true;
  return load_scene(std::move(scene));
}

TEST(RecordSession, ReplaysBitForBit) {
  const std::string path = (fs::temp_directory_path() / "thigma_record_session.mcap").string();
  const Scene scene = small_scene();
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

TEST(RecordSession, SaysWhereItCannotWrite) {
  const Scene scene = small_scene();
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 0.1});
  EXPECT_THROW(record_lockstep(session, "/no/such/folder/session.mcap"), IoError);
}

TEST(RecordSession, RefusesToReplayWhatIsNoRecording) {
  EXPECT_THROW(replay_recording("/no/such/file.mcap"), InputError);
}

}  // namespace
}  // namespace thigma
