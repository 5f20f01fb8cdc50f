#include "thigma/recording/world_recording.h"

#include <cmath>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/math/random.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"

namespace thigma {
namespace {

BodyState random_state(Random& random) {
  const auto any = [&] { return Vec3(random.normal(), random.normal(), random.normal()); };
  BodyState y;
  y.position = any();
  y.orientation = Quat(random.normal(), random.normal(), random.normal(), 1.0).normalized();
  y.linear_momentum = 1e-9 * any();
  y.angular_momentum = 1e9 * any();
  y.angular_momentum.x() = -0.0;
  return y;
}

std::string path_of(const char* name) {
  return (std::filesystem::path(testing::TempDir()) / name).string();
}

std::vector<BodyState> write_some(const std::string& path) {
  WorldRecordingInfo info;
  info.scene = "a \"scene\".toml";
  info.devices = {"hand:?force=2", "null:"};
  info.seed = 7;
  info.rate = 500.0;
  info.bodies = {"table", "block 1"};
  info.joints = {"hinge"};
  WorldRecordingWriter writer(path, info);
  Random random(3);
  std::vector<BodyState> all;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const std::vector<BodyState> states{random_state(random), random_state(random)};
    const RecordedJoint joint{random.normal(), 1.0, -2.0, 0.0};
    writer.write(i, 0.002 * static_cast<double>(i + 1), states, {&joint, 1},
                 std::vector<Wrench>(2));
    all.insert(all.end(), states.begin(), states.end());
  }
  writer.close(40, 0xfedcba9876543210u);
  return all;
}

TEST(WorldRecording, TellsWhatTheDevicesWereSoThatNoneIsOpened) {
  const std::string path = path_of("limits.mcap");
  WorldRecordingInfo info;
  info.devices = {"dhd:0", "web:"};
  info.bodies = {"block"};
  info.is_apart = true;
  info.limits.resize(2);
  info.limits[0].max_force = 0.1 + 0.2;
  info.limits[0].actuates_rotation = info.limits[0].senses_rotation = false;
  info.limits[0].clock = DeviceClock::device;
  info.limits[1].holds_person = false;
  { WorldRecordingWriter(path, info).close(0, 0); }
  const WorldRecording read = read_world_recording(path);
  ASSERT_EQ(read.limits.size(), 2u);
  EXPECT_EQ(read.limits[0].max_force, 0.1 + 0.2);
  EXPECT_FALSE(read.limits[0].actuates_rotation);
  EXPECT_FALSE(read.limits[0].senses_rotation);
  EXPECT_TRUE(read.limits[0].senses_translation);
  EXPECT_EQ(read.limits[0].clock, DeviceClock::device);
  EXPECT_TRUE(read.limits[0].holds_person);
  EXPECT_FALSE(read.limits[1].holds_person);
  for (const double wrong : {-1.0, std::nan("")}) {
    info.limits[1].max_torque = wrong;
    { WorldRecordingWriter(path, info).close(0, 0); }
    try {
      read_world_recording(path);
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("max_torque"), std::string::npos) << error.what();
    }
  }
}

TEST(WorldRecording, ComesBackBitForBit) {
  const std::string path = path_of("world.mcap");
  const std::vector<BodyState> written = write_some(path);
  EXPECT_TRUE(is_world_recording(path));
  const WorldRecording read = read_world_recording(path);
  EXPECT_EQ(read.scene, "a \"scene\".toml");
  EXPECT_EQ(read.devices, (std::vector<std::string>{"hand:?force=2", "null:"}));
  EXPECT_EQ(read.seed, 7u);
  EXPECT_EQ(read.rate, 500.0);
  EXPECT_EQ(read.bodies, (std::vector<std::string>{"table", "block 1"}));
  EXPECT_EQ(read.joints, (std::vector<std::string>{"hinge"}));
  EXPECT_EQ(read.frames, 40u);
  EXPECT_EQ(read.state_hash, 0xfedcba9876543210u);
  ASSERT_EQ(read.states.size(), written.size());
  for (std::size_t i = 0; i < written.size(); ++i)
    EXPECT_TRUE(same_bits(read.states[i], written[i])) << i;
}

TEST(WorldRecording, APagesHandComesBackBitForBit) {
  const std::string path = path_of("page.mcap");
  WorldRecordingInfo info;
  info.devices = {"hand:", "web:"};
  info.bodies = {"block"};
  Random random(5);
  std::vector<RecordedHand> written;
  {
    WorldRecordingWriter writer(path, info);
    for (std::uint64_t i = 0; i < 30; ++i) {
      std::vector<RecordedHand> hands(2);
      DeviceState& d = hands[1].device;
      d.time = random.normal();
      const BodyState pose = random_state(random);
      d.motion.pose = {pose.position, pose.orientation};
      d.motion.twist = {pose.linear_momentum, pose.angular_momentum};
      d.buttons = static_cast<std::uint32_t>(i % 2);
      d.status = i % 7 == 0 ? DeviceStatus::lost : DeviceStatus::ok;
      d.weight = 1.0 / static_cast<double>(i + 1);
      if (i % 5 == 0) hands[1].aimed = WorldAim{static_cast<std::int32_t>(i) - 1, pose.position};
      writer.write(i, 1e-3 * static_cast<double>(i + 1), {&pose, 1}, {}, std::vector<Wrench>(2),
                   hands);
      written.push_back(hands[1]);
    }
    writer.close(30, 1);
  }
  const WorldRecording read = read_world_recording(path);
  ASSERT_EQ(read.hands.size(), 2u);
  EXPECT_EQ(read.hands[0].size(), 30u);
  ASSERT_EQ(read.hands[1].size(), 30u);
  for (std::size_t i = 0; i < 30; ++i) {
    const RecordedHand &a = read.hands[1][i], &b = written[i];
    EXPECT_EQ(a.device.time, b.device.time);
    EXPECT_EQ(a.device.motion.pose.position, b.device.motion.pose.position);
    EXPECT_EQ(a.device.motion.pose.orientation.coeffs(), b.device.motion.pose.orientation.coeffs());
    EXPECT_EQ(a.device.motion.twist.linear, b.device.motion.twist.linear);
    EXPECT_EQ(a.device.motion.twist.angular, b.device.motion.twist.angular);
    EXPECT_EQ(a.device.buttons, b.device.buttons);
    EXPECT_EQ(a.device.status, b.device.status);
    EXPECT_EQ(a.device.weight, b.device.weight);
    ASSERT_EQ(a.aimed.has_value(), b.aimed.has_value());
    if (!a.aimed) continue;
    EXPECT_EQ(a.aimed->body, b.aimed->body);
    EXPECT_EQ(a.aimed->point, b.aimed->point);
  }
}

DeviceState random_device(Random& random, bool has_true_handle) {
  DeviceState d;
  const BodyState pose = random_state(random), seen = random_state(random);
  d.time = random.normal();
  d.motion.pose = {pose.position, pose.orientation};
  d.motion.twist = {pose.linear_momentum, pose.angular_momentum};
  d.has_true_handle = has_true_handle;
  if (has_true_handle) d.true_handle = {seen.position, seen.orientation};
  return d;
}

/// Two hands apart from their world, the first simulated: three haptic steps a frame.
std::vector<HandTick> write_apart(const std::string& path) {
  WorldRecordingInfo info;
  info.devices = {"hand:", "web:"};
  info.bodies = {"block"};
  info.is_apart = true;
  WorldRecordingWriter writer(path, info);
  Random random(9);
  std::vector<HandTick> all;
  for (std::uint64_t frame = 0; frame < 20; ++frame) {
    std::vector<HandTick> ticks;
    for (std::uint64_t k = 0; k < 6; ++k) {
      HandTick made;
      made.hand = static_cast<std::int32_t>(k % 2);
      made.step = 3 * frame + k / 2;
      made.tick = {1e-3 * static_cast<double>(made.step), 1e-3 / 3.0,
                   k == 5 ? Fault::watchdog : Fault::none};
      made.device = random_device(random, made.hand == 0);
      made.news = frame;
      made.sent = {random_state(random).position, random_state(random).angular_momentum};
      ticks.push_back(made);
    }
    const BodyState state = random_state(random);
    std::vector<RecordedHand> hands(2);
    for (RecordedHand& hand : hands) hand.seen = {3 * frame + 1, 3 * frame + 2};
    writer.write(frame, 1e-3 * static_cast<double>(frame + 1), {&state, 1}, {},
                 std::vector<Wrench>(2), hands);
    writer.write(ticks);
    all.insert(all.end(), ticks.begin(), ticks.end());
  }
  writer.close(20, 1);
  return all;
}

TEST(WorldRecording, HapticStepsComeBackBitForBit) {
  const std::string path = path_of("apart.mcap");
  const std::vector<HandTick> written = write_apart(path);
  const WorldRecording read = read_world_recording(path);
  EXPECT_TRUE(read.is_apart);
  ASSERT_EQ(read.ticks.size(), 2u);
  for (const auto& ticks : read.ticks) ASSERT_EQ(ticks.size(), 60u);
  for (const HandTick& then : written) {
    const HandTick& now = read.ticks[static_cast<std::size_t>(then.hand)][then.step];
    EXPECT_EQ(now.hand, then.hand);
    EXPECT_EQ(now.step, then.step);
    EXPECT_EQ(now.tick.now, then.tick.now);
    EXPECT_EQ(now.tick.elapsed, then.tick.elapsed);
    EXPECT_EQ(now.tick.external_fault, then.tick.external_fault);
    EXPECT_EQ(now.news, then.news);
    EXPECT_EQ(now.sent.force, then.sent.force);
    EXPECT_EQ(now.sent.torque, then.sent.torque);
    EXPECT_EQ(now.device.motion.twist.angular, then.device.motion.twist.angular);
    ASSERT_EQ(now.device.has_true_handle, then.device.has_true_handle);
    EXPECT_EQ(now.device.true_handle.position, then.device.true_handle.position);
    EXPECT_EQ(now.device.true_handle.orientation.coeffs(),
              then.device.true_handle.orientation.coeffs());
  }
  for (const auto& hand : read.hands) {
    ASSERT_EQ(hand.size(), 20u);
    EXPECT_EQ(hand[7].seen.read, 22u);
    EXPECT_EQ(hand[7].seen.told, 23u);
  }
}

TEST(WorldRecording, TellsHowManyHapticStepsWereMade) {
  const std::string path = path_of("made.mcap");
  WorldRecordingInfo info;
  info.devices = {"hand:", "hand:"};
  info.bodies = {"block"};
  info.is_apart = true;
  const std::vector<std::uint64_t> made = {7, 0};
  { WorldRecordingWriter(path, info).close(0, 1, made); }
  EXPECT_EQ(read_world_recording(path).haptic_steps, made);
  EXPECT_EQ(parse_world_recording(read_file(path), "a name").haptic_steps, made);
  info.is_apart = false;
  { WorldRecordingWriter(path, info).close(0, 1, made); }
  EXPECT_TRUE(read_world_recording(path).haptic_steps.empty());
}

TEST(WorldRecording, AMissingHapticStepIsToldWhenItIsWritten) {
  WorldRecordingInfo info;
  info.devices = {"hand:"};
  info.bodies = {"block"};
  info.is_apart = true;
  WorldRecordingWriter writer(path_of("gap.mcap"), info);
  std::vector<HandTick> ticks(2);
  ticks[1].step = 2;
  EXPECT_THROW(writer.write(ticks), IoError);
}

/// What is said of a recording of one hand that has this haptic step and this sample.
std::string refused(const std::string& haptic, const std::string& sample, bool is_apart = true,
                    const std::string& times = R"("now":0.0,"elapsed":0.001,)",
                    const std::string& buttons = "0", const char* topic = "/device/sample") {
  const std::string path = path_of("lying.mcap");
  {
    McapWriter writer(path);
    const std::uint16_t config = writer.add_channel("/config", "thigma.world_config", "");
    const std::uint16_t steps = writer.add_channel("/device/haptic", "thigma.hand_tick", "");
    const std::uint16_t samples = writer.add_channel(topic, "thigma.hand_sample", "");
    writer.write(config, 0, 0,
                 std::string(R"({"kind":"thigma world 1","scene":"a.toml","devices":["hand:"],)") +
                     R"("seed":1,"rate_hz":1000.0,"bodies":["block"],"apart":)" +
                     (is_apart ? "true}" : "false}"));
    const std::string device =
        R"("time":0.0,"position":[0,0,0],"quat_xyzw":[0,0,0,1],"linear":[0,0,0],)"
        R"("angular":[0,0,0],"status":0,"weight":0.0,"buttons":)" +
        buttons;
    if (!haptic.empty())
      writer.write(steps, 0, 0,
                   "{" + haptic + "," + times + device + R"(,"force":[0,0,0],"torque":[0,0,0]})");
    if (!sample.empty()) writer.write(samples, 0, 0, "{" + sample + "," + device + "}");
    writer.close();
  }
  try {
    read_world_recording(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(WorldRecording, RefusesHapticStepsThatCannotBe) {
  const std::string good = R"("frame":0,"fault":0,"news":0)", seen = R"("read":1,"told":2)";
  EXPECT_EQ(refused(good, seen), "");
  const auto says = [](const std::string& said, const char* what) {
    EXPECT_NE(said.find(what), std::string::npos) << said;
  };
  says(refused(R"("frame":1,"fault":0,"news":0)", ""), "a haptic step is missing");
  says(refused(R"("frame":0,"fault":99,"news":0)", ""), "a fault that there is not");
  says(refused(R"("frame":0,"fault":-1,"news":0)", ""), "fault is not a whole number");
  says(refused(R"("frame":0,"fault":0,"news":-1)", ""), "news is not a whole number");
  says(refused(R"("frame":-1,"fault":0,"news":0)", ""), "frame is not a whole number");
  says(refused("", R"("read":-1,"told":2)"), "read is not a whole number");
  says(refused("", R"("read":1,"told":2.5)"), "told is not a whole number");
  says(refused(good, seen, false), "a haptic step of hands that are not apart");
  says(refused(good, "", true, R"("now":-1.0,"elapsed":0.001,)"), "now is not a time");
  says(refused(good, "", true, R"("now":1e300,"elapsed":0.001,)"), "now is not a time");
  says(refused(good, "", true, R"("now":null,"elapsed":0.001,)"), "a message is damaged");
  says(refused(good, "", true, R"("now":0.0,"elapsed":1e300,)"), "elapsed is not a time");
}

TEST(WorldRecording, RefusesSamplesThatCannotBe) {
  const std::string seen = R"("read":1,"told":2)", times = R"("now":0.0,"elapsed":0.001,)";
  const auto says = [](const std::string& said, const char* what) {
    EXPECT_NE(said.find(what), std::string::npos) << said;
  };
  EXPECT_EQ(refused("", seen + R"(,"frame":0)"), "");
  says(refused("", seen + R"(,"frame":1)"), "/device/sample out of order, at frame 0");
  says(refused("", seen, true, times, "1e99"),
       "buttons is not a whole number from 0 to 4294967295");
  says(refused("", seen, true, times, "4294967296"), "buttons is not a whole number");
  says(refused("", seen, true, times, "0", "/device/2/sample"), "/device/2/sample of 1 devices");
  says(refused("", seen, true, times, "0", "/device/x/sample"), "/device/x/sample of 1 devices");
  says(refused("", seen + R"(,"aim":1.5,"point":[0,0,0])"), "aim is not the number of a body");
  EXPECT_EQ(refused("", seen + R"(,"aim":99999999999,"point":[0,0,0])"), "");
}

TEST(WorldRecording, RefusesWhatIsDamaged) {
  const std::string path = path_of("world.mcap"), broken = path_of("broken.mcap");
  write_some(path);
  const std::string apart = path_of("apart.mcap");
  write_apart(apart);
  Random random(5);
  int refused = 0;
  for (int k = 0; k < 400; ++k) {
    const std::string bytes = read_file(k < 200 ? path : apart);
    std::string damaged = bytes;
    if (k % 2 == 0)
      damaged.resize(
          static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size())));
    else
      damaged[static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size()))] ^=
          0x55;
    write_file(broken, damaged);
    try {
      const WorldRecording read = read_world_recording(broken);
      EXPECT_EQ(read.states.size() % read.bodies.size(), 0u);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("broken.mcap"), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 40);
}

TEST(WorldRecording, KnowsItsKind) {
  const std::string other = path_of("other.mcap");
  write_file(other, "no recording");
  EXPECT_FALSE(is_world_recording(other));
  EXPECT_FALSE(is_world_recording(path_of("absent.mcap")));
  EXPECT_THROW(read_world_recording(other), InputError);
}

TEST(WorldRecording, IsRefusedByNameWhereASessionsIsRead) {
  const std::string path = path_of("of_a_world.mcap");
  write_some(path);
  try {
    read_recording(path);
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a world of several bodies"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace thigma
