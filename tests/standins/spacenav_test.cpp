// The daemon of SpaceMice, pretended: its two protocols and its faults.
#include <array>
#include <cmath>
#include <cstring>

#include "services.h"

namespace standin_test {
namespace {

using Packet = std::array<std::int32_t, 8>;
constexpr std::int32_t kTag = 0x7faa0000;

class SpaceNav : public ::testing::Test {
 protected:
  SpaceNav()
      : path("/tmp/si_spnav_" + std::to_string(getpid())),
        daemon("standin_spacenav", "SPACENAV", {"--socket", path}),
        wire(Wire::unix_socket(path)) {}
  ~SpaceNav() override { std::remove(path.c_str()); }

  static Packet next(Wire& from) {
    Packet packet{};
    from.read(32);
    std::memcpy(packet.data(), from.in().data(), std::min<std::size_t>(from.in().size(), 32));
    from.drop(32);
    return packet;
  }
  void say(std::int32_t word) { wire.send({reinterpret_cast<const char*>(&word), 4}); }
  Packet ask(std::int32_t type, std::int32_t value = 0) {
    const Packet request{kTag | type, value};
    wire.send({reinterpret_cast<const char*>(request.data()), 32});
    return next(wire);
  }
  void use_protocol_1() {
    say(kTag | 0x5500 | 1);
    std::int32_t answer = 0;
    wire.read(4);
    std::memcpy(&answer, wire.in().data(), 4);
    wire.drop(4);
    ASSERT_EQ(answer, kTag | 0x5500 | 1);
  }

  std::string path;
  Running daemon;
  Wire wire;
};

TEST_F(SpaceNav, a_motion_has_six_counts_and_a_time) {
  ASSERT_TRUE(daemon.reaches("clients", 1));
  daemon.set("axis_x", 100);
  Packet motion = next(wire);
  EXPECT_EQ(motion[0], 0);
  EXPECT_EQ(motion[1], 100);
  EXPECT_GE(motion[7], 0);
  daemon.set("axis_rz", -1000);
  motion = next(wire);
  EXPECT_EQ(motion[6], -350);
}

TEST_F(SpaceNav, a_held_mouse_is_told_once_unless_the_daemon_repeats) {
  ASSERT_TRUE(daemon.reaches("clients", 1));
  daemon.set("axis_y", 50);
  EXPECT_EQ(next(wire)[2], 50);
  EXPECT_TRUE(wire.read(1, 0.1).empty());
  daemon.set("repeat_ms", 10);
  EXPECT_EQ(next(wire)[2], 50);
  EXPECT_EQ(next(wire)[2], 50);
}

TEST_F(SpaceNav, noise_below_the_dead_zone_is_rest) {
  ASSERT_TRUE(daemon.reaches("clients", 1));
  daemon.set("axis_x", 1);
  EXPECT_TRUE(wire.read(1, 0.1).empty());
}

TEST_F(SpaceNav, buttons) {
  ASSERT_TRUE(daemon.reaches("clients", 1));
  daemon.set("buttons", 2);
  EXPECT_EQ(next(wire), (Packet{1, 1, 1}));
  daemon.set("buttons", 0);
  EXPECT_EQ(next(wire), (Packet{2, 1, 0}));
}

TEST_F(SpaceNav, protocol_0_takes_a_sensitivity) {
  const float half = 0.5F;
  wire.send({reinterpret_cast<const char*>(&half), 4});
  ASSERT_TRUE(daemon.reaches("sensitivity", 0.5));
  daemon.set("axis_x", 100);
  EXPECT_EQ(next(wire)[1], 50);
}

TEST_F(SpaceNav, an_old_daemon_does_not_answer_the_request_for_protocol_1) {
  daemon.set("protocol", 0);
  say(kTag | 0x5500 | 1);
  EXPECT_TRUE(daemon.reaches("messages", 1));
  EXPECT_TRUE(wire.read(1, 0.1).empty());
  EXPECT_EQ(daemon.get("sensitivity"), 1.0);  // the number is none that is finite
}

TEST_F(SpaceNav, a_protocol_beyond_is_answered_with_the_highest) {
  say(kTag | 0x5500 | 9);
  std::int32_t answer = 0;
  wire.read(4);
  std::memcpy(&answer, wire.in().data(), 4);
  EXPECT_EQ(answer, kTag | 0x5500 | 1);
}

TEST_F(SpaceNav, protocol_1_answers_questions) {
  use_protocol_1();
  EXPECT_EQ(ask(0x2002)[1], 6);       // axes
  EXPECT_EQ(ask(0x2003)[1], 2);       // buttons
  EXPECT_EQ(ask(0x2004)[2], 0xc626);  // USB numbers
  Packet name = ask(0x2000);
  EXPECT_EQ(std::string(reinterpret_cast<char*>(name.data() + 1), 24), "3Dconnexion SpaceNavigat");
  EXPECT_EQ(name[7], 26);
  name = next(wire);
  EXPECT_EQ(std::string(reinterpret_cast<char*>(name.data() + 1)), "or");
  EXPECT_EQ(name[7], 2 | 0x10000);
  EXPECT_EQ(ask(0x7777)[7], -1);
  daemon.set("unplug", 1);
  EXPECT_EQ(next(wire)[0], 3);  // the event that it is gone
  EXPECT_EQ(ask(0x2002)[7], -1);
}

TEST_F(SpaceNav, protocol_1_hears_of_devices_protocol_0_does_not) {
  Wire old(Wire::unix_socket(path));
  ASSERT_TRUE(daemon.reaches("clients", 2));
  use_protocol_1();
  daemon.set("unplug", 1);
  Packet event = next(wire);
  EXPECT_EQ(event[0], 3);
  EXPECT_EQ(event[1], 1);
  daemon.set("axis_x", 100);
  EXPECT_TRUE(wire.read(1, 0.1).empty());
  daemon.set("unplug", 0);
  event = next(wire);
  EXPECT_EQ(event[1], 0);
  EXPECT_EQ(next(old)[0], 0);  // the motion, nothing before it
}

TEST_F(SpaceNav, the_mask_of_events) {
  use_protocol_1();
  EXPECT_EQ(ask(0x1004)[1], 7);
  EXPECT_EQ(ask(0x1003, 2)[7], 0);
  daemon.set("axis_x", 100);
  daemon.set("buttons", 1);
  EXPECT_EQ(next(wire)[0], 1);
}

TEST_F(SpaceNav, faults) {
  ASSERT_TRUE(daemon.reaches("clients", 1));
  daemon.set("garbage", 1);
  daemon.set("axis_x", 100);
  EXPECT_EQ(next(wire)[0], 0x5a5a5a5a);
  daemon.set("garbage", 0);
  daemon.set("half", 1);
  daemon.set("axis_x", 120);
  EXPECT_EQ(wire.read(32, 0.2).size(), 16U);
  EXPECT_FALSE(wire.is_closed(0.05));
  daemon.set("drop", 1);
  EXPECT_TRUE(wire.is_closed());
  EXPECT_TRUE(daemon.reaches("clients", 0));
}

}  // namespace
}  // namespace standin_test
