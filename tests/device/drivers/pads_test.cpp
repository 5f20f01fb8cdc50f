// SpaceMouse and gamepad against stand-ins of their daemon and of the kernel's event devices.
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

class SpacenavDevice : public testing::Test {
 protected:
  SpacenavDevice()
      : path_(testing::TempDir() + "spnav_" + std::to_string(getpid())),
        daemon_("standin_spacenav", "SPACENAV", {"--socket", path_}) {}
  ~SpacenavDevice() override { std::remove(path_.c_str()); }
  std::string address(const std::string& more = "") const { return "spacenav:" + path_ + more; }

  std::string path_;
  Running daemon_;
};

TEST_F(SpacenavDevice, pushes_are_velocities_in_our_axes) {
  const auto device = open_device(address());
  const char* const axes[6] = {"axis_x", "axis_y", "axis_z", "axis_rx", "axis_ry", "axis_rz"};
  const Vec3 ours[3] = {Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX()};  // right, up, away
  double now = 0.0;
  std::printf("pushed       velocity [m/s]                turning [rad/s]\n");
  for (int axis = 0; axis < 6; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      daemon_.set(axes[axis], sign * 350.0);
      const Vec3 way = sign * ours[axis % 3];
      const Vec3 linear = axis < 3 ? Vec3(0.1 * way) : Vec3(Vec3::Zero());
      const Vec3 angular = axis < 3 ? Vec3(Vec3::Zero()) : way;
      Twist twist;
      EXPECT_TRUE(wait_for([&] {
        twist = device->read(now += 1e-3).motion.twist;
        return (twist.linear - linear).norm() < 1e-4 && (twist.angular - angular).norm() < 1e-3;
      })) << axes[axis];
      std::printf("%-8s %c   %7.3f %7.3f %7.3f    %7.3f %7.3f %7.3f\n", axes[axis],
                  sign > 0.0 ? '+' : '-', twist.linear.x(), twist.linear.y(), twist.linear.z(),
                  twist.angular.x(), twist.angular.y(), twist.angular.z());
      daemon_.set(axes[axis], 0);
    }
  }
}

TEST_F(SpacenavDevice, a_push_that_is_held_goes_on_and_ends_with_it) {
  const auto device = open_device(address());
  double now = 0.0;
  daemon_.set("axis_y", 350);
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).motion.twist.linear.z() > 0.099; }));
  for (int i = 0; i < 1000; ++i) device->read(now += 1e-3);  // one event, told once
  EXPECT_NEAR(device->read(now += 1e-3).motion.twist.linear.z(), 0.1, 1e-3);
  daemon_.set("axis_y", 0);
  EXPECT_TRUE(
      wait_for([&] { return std::abs(device->read(now += 1e-3).motion.twist.linear.z()) < 1e-5; }));
}

TEST_F(SpacenavDevice, turns_a_device_of_three_axes) {
  const auto device = open_device("hand:?dof=3&path=rest&rotation=" + address());
  double now = 0.0;
  daemon_.set("axis_ry", 350);
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).motion.twist.angular.z() > 0.99; }));
  EXPECT_TRUE(device->limits().senses_rotation);
}

TEST_F(SpacenavDevice, a_daemon_that_leaves_or_says_nonsense_is_a_loss) {
  {
    const auto device = open_device(address());
    double now = 0.0;
    daemon_.set("axis_y", 350);
    EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).motion.twist.linear.z() > 0.09; }));
    daemon_.set("garbage", 1);
    daemon_.set("axis_y", 300);
    EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).status == DeviceStatus::lost; }));
    EXPECT_STRNE(device->trouble(), "");
    daemon_.set("garbage", 0);
    daemon_.set("axis_y", 0);
  }
  const auto device = open_device(address());
  daemon_.set("die", 1);
  EXPECT_TRUE(wait_for([&] { return device->read(0.0).status == DeviceStatus::lost; }));
  EXPECT_STREQ(device->trouble(), "spacenavd has gone");
}

/// This program again, in which the stand-in's library stands before the kernel's calls.
class GamepadDevice : public testing::Test {
 protected:
  static std::string folder() { return testing::TempDir() + "pads_" + std::to_string(getpid()); }
  /// Runs one of the tests below whose names begin with DISABLED; its exit status.
  static int run_under(const Running& pads, const std::string& name) {
    const std::string place = folder(), filter = "--gtest_filter=UnderPads.DISABLED_" + name;
    const pid_t child = fork();
    if (child == 0) {
      setenv("LD_PRELOAD", STANDIN_FOLDER "/libstandin_evdev.so", 1);
      setenv("ASAN_OPTIONS", "verify_asan_link_order=0", 0);
      setenv("STANDIN_GAMEPAD_BOARD", pads.path().c_str(), 1);
      setenv("STANDIN_EVDEV_FOLDER", place.c_str(), 1);
      execl("/proc/self/exe", "pads", filter.c_str(), "--gtest_also_run_disabled_tests",
            "--gtest_brief=1", nullptr);
      _exit(99);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
};

TEST_F(GamepadDevice, is_found_read_and_lost) {
  Running pads("standin_gamepad", "GAMEPAD", {"--socket", folder()});
  pads.set("axis_x", 32767.0);
  EXPECT_EQ(run_under(pads, "a_stick_is_a_velocity"), 0);
  EXPECT_EQ(run_under(pads, "unplugged_is_lost"), 0);
}

TEST_F(GamepadDevice, says_what_to_do_without_permission) {
  Running pads("standin_gamepad", "GAMEPAD", {"--socket", folder()}, {"NO_PERMISSION=1"});
  EXPECT_EQ(run_under(pads, "no_permission_says_what_to_do"), 0);
}

// Run by the tests above.
TEST(UnderPads, DISABLED_a_stick_is_a_velocity) {
  EXPECT_EQ(plugged_devices("gamepad:").size(), 1u);
  const auto device = open_device("gamepad:");
  std::printf("%s\n", device->name().c_str());
  double now = 0.0;
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).motion.twist.linear.y() > 0.099; }));
}

TEST(UnderPads, DISABLED_unplugged_is_lost) {
  int inherited = -1;
  standin::use_board(standin::open_board(std::getenv("STANDIN_GAMEPAD_BOARD"), &inherited));
  const auto device = open_device("gamepad:");
  double now = 0.0;
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).motion.twist.linear.y() > 0.05; }));
  standin_set("unplug", 1);
  EXPECT_TRUE(wait_for([&] { return device->read(now += 1e-3).status == DeviceStatus::lost; }));
  standin_set("unplug", 0);
  EXPECT_NE(std::string(device->trouble()).find("unplugged"), std::string::npos);
}

TEST(UnderPads, DISABLED_no_permission_says_what_to_do) {
  try {
    open_device("gamepad:");
    ADD_FAILURE();
  } catch (const DeviceUnavailable& error) {
    std::printf("%s\n", error.what());
    EXPECT_NE(std::string(error.what()).find("usermod -aG input"), std::string::npos);
  }
}

}  // namespace
}  // namespace thigma
