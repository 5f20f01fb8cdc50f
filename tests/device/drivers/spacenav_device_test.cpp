// The driver of SpaceMice against the stand-in of their daemon, a process of its own.
#include <cmath>
#include <cstdio>
#include <memory>

#include "standins/services.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/recording/replay_session.h"

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

TEST_F(SpacenavDevice, moves_the_view_while_another_device_holds_the_object) {
  SessionConfig config = test::plane_session();
  config.duration = 1.5;
  config.haptic.safety.watchdog = 5.0;
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  DeviceContext context;
  context.clearance = 0.005;
  const auto device = open_device("hand:?path=press&camera=" + address(), context);
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  Session session(config, *device,
                  {[&](const HapticSample& s) { samples.push_back(s); },
                   [&](const ContactSample& s) { models.push_back(s); },
                   {}});
  daemon_.set("axis_x", 350);  // to the right, y of ours
  session.start();
  usleep(500'000);
  daemon_.set("axis_x", 0);
  daemon_.set("axis_ry", 350);
  const SessionSummary summary = session.finish();
  EXPECT_EQ(summary.end, SessionEnd::duration);
  const HapticSample& last = samples.back();
  ASSERT_TRUE(last.device.has_camera);
  EXPECT_GT(last.device.camera.position.y(), 0.01);
  EXPECT_GT(last.device.camera.orientation.z(), 0.01);
  EXPECT_GT(summary.force_max, 0.1);  // the hand pressed meanwhile
  HapticParams params = config.haptic;
  use_device_limits(device->limits(), params);
  const ReplayReport replay = replay_session(params, config.world_from_body, samples, models);
  EXPECT_TRUE(replay.identical) << replay.first_difference << ' ' << replay.reason;
  std::printf("%zu frames with force to %.2f N, the view moved by %.3f m and %.2f rad: replay %s\n",
              samples.size(), summary.force_max, last.device.camera.position.norm(),
              2.0 * std::asin(last.device.camera.orientation.z()),
              replay.identical ? "identical" : "differs");
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

}  // namespace
}  // namespace thigma
