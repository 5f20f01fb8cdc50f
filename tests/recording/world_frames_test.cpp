#include "thigma/recording/world_frames.h"

#include <utility>

#include "recording/written_worlds.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/replay_session.h"

namespace thigma {
namespace {

using namespace test;

TEST(WorldFrames, come_back_whole) {
  const std::string path = path_of("frames.mcap");
  write_world(path, true);
  std::uint64_t frames = 0, ticks = 0;
  const WorldRecordingPass pass = stream_world_recording(
      path,
      {[&](const WorldRecordingInfo& info) {
         EXPECT_EQ(frames, 0u);
         EXPECT_EQ(info.joints.size(), 1u);
       },
       [&](const RecordedWorldFrame& frame) {
         EXPECT_EQ(frame.frame, frames);
         EXPECT_EQ(frame.time, static_cast<double>(frames + 1) / 1e3);
         for (int i = 0; i < 2; ++i)
           EXPECT_TRUE(same_bits(frame.bodies[static_cast<std::size_t>(i)], body_at(frames, i)));
         EXPECT_EQ(frame.is_asleep[1], frames >= 10);
         EXPECT_EQ(frame.joints[0].coordinate, 0.25 * static_cast<double>(frames));
         EXPECT_EQ(frame.commands[0].force, Vec3(1.0, 2.0, 3.0));
         ASSERT_TRUE(frame.hands[0].has_value());
         EXPECT_EQ(frame.hands[0]->energy, 1e-3 * static_cast<double>(frames));
         ++frames;
       },
       [&](const HandTick& tick) {
         EXPECT_EQ(tick.energy, -1.0);
         ++ticks;
       }});
  EXPECT_EQ(frames, kFrames);
  EXPECT_EQ(ticks, 2 * kSteps * kFrames);
  EXPECT_EQ(pass.frame_count, kFrames);
  EXPECT_EQ(pass.tick_count, ticks);
  EXPECT_EQ(pass.cut_off, "");
  EXPECT_TRUE(pass.info.has_end);
}

/// Two whole frames of two bodies and a hand, and the first messages of a third.
void write_begun(const std::string& path, int messages) {
  const std::string body = R"("position":[0,0,0],"quat_xyzw":[0,0,0,1],"linear_momentum":[0,0,0],)"
                           R"("angular_momentum":[0,0,0]})";
  const std::string wrench = R"("force":[0,0,0],"torque":[0,0,0]})";
  const std::string sample =
      R"("time":0,"position":[0,0,0],"quat_xyzw":[0,0,0,1],"linear":[0,0,0],"angular":[0,0,0],)"
      R"("buttons":0,"status":0,"weight":1})";
  McapWriter writer(path);
  const std::uint16_t config = writer.add_channel("/config", "thigma.world_config", "");
  const std::pair<std::uint16_t, const std::string*> frame[] = {
      {writer.add_channel("/body/a/state", "thigma.body_state", ""), &body},
      {writer.add_channel("/body/b/state", "thigma.body_state", ""), &body},
      {writer.add_channel("/device/command", "thigma.wrench", ""), &wrench},
      {writer.add_channel("/device/sample", "thigma.hand_sample", ""), &sample}};
  writer.write(config, 0, 0,
               R"({"kind":"thigma world 1","scene":"a.toml","devices":["hand:"],"seed":1,)"
               R"("rate_hz":1000.0,"bodies":["a","b"],"joints":[]})");
  for (std::uint32_t i = 0; i < 3; ++i)
    for (int k = 0; k < (i < 2 ? 4 : messages); ++k)
      writer.write(frame[k].first, i, (i + 1) * std::uint64_t{1000000},
                   "{\"frame\":" + std::to_string(i) + "," + *frame[k].second);
  writer.close();
}

TEST(WorldFrames, a_recording_that_was_cut_off_ends_with_its_last_whole_frame) {
  const std::string path = path_of("cut.mcap");
  for (const int messages : {0, 1, 2, 3, 4}) {
    write_begun(path, messages);
    std::uint64_t frames = 0;
    const auto count = [&](const RecordedWorldFrame& frame) {
      EXPECT_TRUE(frame.hands[0].has_value());
      EXPECT_EQ(frame.frame, frames++);
    };
    const WorldRecordingPass pass = stream_world_recording(path, {{}, count, {}});
    EXPECT_EQ(frames, messages == 4 ? 3u : 2u) << messages;
    EXPECT_EQ(pass.frame_count, frames);
    EXPECT_NE(pass.cut_off.find("the recording ends at 0.00"), std::string::npos) << pass.cut_off;
    EXPECT_EQ(read_world_recording(path).states.size(), 2 * frames);
  }
}

TEST(WorldFrames, a_session_of_one_object_is_refused) {
  const std::string path = path_of("nothing.mcap");
  write_file(path, "no recording");
  EXPECT_THROW(stream_world_recording(path, {}), InputError);
  EXPECT_THROW(stream_world_recording(path_of("absent.mcap"), {}), InputError);
}

}  // namespace
}  // namespace thigma
