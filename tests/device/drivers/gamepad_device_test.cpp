// The driver of gamepads against the stand-in of the kernel's event devices. This program is linked
// to the stand-in's library, whose open, read and ioctl stand before the C library's.
#include "thigma/device/detail/gamepad_device.h"

#include <cmath>
#include <cstdio>
#include <memory>

#include "standins/services.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"

namespace thigma {
namespace {

using standin_test::Running;
using standin_test::wait_for;

/// One process for all tests: the library asks once where it is.
class GamepadDevice : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* key : {"axis_x", "unplug", "no_permission", "not_a_pad"}) pads().set(key, 0.0);
    ASSERT_TRUE(wait_for([] { return plugged_devices("gamepad:").size() == 1; }));
  }
  static Running& pads() {
    static const std::string folder = testing::TempDir() + "pads_" + std::to_string(getpid());
    static Running running = [] {
      setenv("STANDIN_EVDEV_FOLDER", folder.c_str(), 1);  // asked for by the first call of open
      return Running("standin_gamepad", "GAMEPAD", {"--socket", folder});
    }();
    setenv("STANDIN_GAMEPAD_BOARD", running.path().c_str(), 1);
    return running;
  }
  static std::string refusal(const std::string& address) {
    try {
      open_device(address);
    } catch (const DeviceUnavailable& error) {
      return error.what();
    }
    return "";
  }
  /// Whether the handle comes to move to the right as fast as that [m/s].
  static bool moves(HapticDevice& device, double speed) {
    double now = 0.0;
    return wait_for([&] { return device.read(now += 1e-3).motion.twist.linear.y() > speed; });
  }
};

TEST_F(GamepadDevice, a_stick_is_a_velocity) {
  EXPECT_EQ(plugged_devices("gamepad:"), std::vector<std::string>{"gamepad:0"});
  pads().set("axis_x", 32767.0);
  const auto device = open_device("gamepad:");
  std::printf("%s\n", device->name().c_str());
  EXPECT_TRUE(moves(*device, 0.099));
}

TEST_F(GamepadDevice, unplugged_is_lost_and_moves_no_more) {
  const auto device = open_device("gamepad:");
  // Unlike the kernel the stand-in tells only what changes after it has seen that it is read.
  double now = 0.0, push = 0.0;
  EXPECT_TRUE(wait_for([&] {
    pads().set("axis_x", push = push == 32767.0 ? 32000.0 : 32767.0);
    return device->read(now += 1e-3).motion.twist.linear.y() > 0.05;
  }));
  pads().set("unplug", 1.0);
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).status == DeviceStatus::lost; }));
  EXPECT_NE(std::string(device->trouble()).find("unplugged"), std::string::npos);
  EXPECT_TRUE(
      wait_for([&] { return device->read(now += 1e-3).motion.twist.linear.norm() < 1e-4; }));
}

TEST_F(GamepadDevice, says_what_to_do_without_permission) {
  pads().set("no_permission", 1.0);
  const std::string said = refusal("gamepad:");
  std::printf("%s\n", said.c_str());
  EXPECT_NE(said.find("usermod -aG input"), std::string::npos) << said;
  EXPECT_NE(refusal("gamepad:/dev/input/event0").find("Permission denied. Let your user read it"),
            std::string::npos)
      << refusal("gamepad:/dev/input/event0");
}

TEST_F(GamepadDevice, a_keyboard_is_no_gamepad) {
  pads().set("not_a_pad", 1.0);
  EXPECT_NE(refusal("gamepad:").find("none is plugged in"), std::string::npos)
      << refusal("gamepad:");
  EXPECT_EQ(refusal("gamepad:/dev/null"),
            "gamepad: /dev/null is no gamepad. Plug one in; `thigma devices` lists them.");
}

}  // namespace
}  // namespace thigma
