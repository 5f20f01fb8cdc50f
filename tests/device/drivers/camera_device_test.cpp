// A second device that moves the view: what the hand holds and feels knows nothing of it.
#include "thigma/device/detail/camera_device.h"

#include <cmath>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

/// A handle that is where the test puts it.
struct Viewer final : HapticDevice {
  Viewer() { own.holds_person = false; }
  DeviceLimits own;
  DeviceState state;
  Wrench sent;
  const DeviceLimits& limits() const override { return own; }
  std::string name() const override { return "viewer"; }
  DeviceState read(double) THIGMA_RT override { return state; }
  void write(const Wrench& wrench) THIGMA_RT override { sent = wrench; }
  const char* trouble() const THIGMA_RT override {
    return state.status == DeviceStatus::lost ? "the viewer is gone" : "";
  }
};

TEST(CameraDevice, tells_where_the_second_handle_is_and_changes_nothing_else) {
  auto viewer = std::make_unique<Viewer>();
  Viewer& told = *viewer;
  told.state.motion.pose = {{0.1, -0.2, 0.3}, rotation_from_vector(Vec3(0.0, 0.0, 0.4))};
  const auto device = make_camera_device(open_device("hand:"), std::move(viewer));
  const auto alone = open_device("hand:");
  for (int i = 0; i < 200; ++i) {
    const DeviceState with = device->read(1e-3 * i), without = alone->read(1e-3 * i);
    device->write({Vec3::UnitZ(), Vec3::Zero()});
    alone->write({Vec3::UnitZ(), Vec3::Zero()});
    EXPECT_EQ(with.motion.pose.position, without.motion.pose.position);
    EXPECT_EQ(with.buttons, without.buttons);
    EXPECT_TRUE(with.has_camera);
    EXPECT_EQ(with.camera.position, Vec3(0.1, -0.2, 0.3));
    EXPECT_FALSE(without.has_camera);
  }
  EXPECT_EQ(told.sent.force, Vec3(Vec3::Zero()));
  EXPECT_EQ(device->limits().max_force, alone->limits().max_force);
}

TEST(CameraDevice, one_that_is_lost_or_tells_no_number_stays_where_it_was) {
  auto viewer = std::make_unique<Viewer>();
  DeviceState& told = viewer->state;
  told.motion.pose.position = Vec3(0.1, 0.0, 0.0);
  const auto device = make_camera_device(open_device("hand:"), std::move(viewer));
  EXPECT_EQ(device->read(0.0).camera.position.x(), 0.1);
  told.motion.pose.position.x() = std::nan("");
  EXPECT_EQ(device->read(0.001).camera.position.x(), 0.1);
  told.motion.pose.position.x() = 0.5;
  told.status = DeviceStatus::lost;
  const DeviceState state = device->read(0.002);
  EXPECT_EQ(state.camera.position.x(), 0.1);
  EXPECT_EQ(state.status, DeviceStatus::ok);
  EXPECT_STREQ(device->trouble(), "the viewer is gone");
}

TEST(CameraDevice, stands_last_in_an_address_and_has_no_motors) {
  const auto refusal = [](const std::string& address) {
    try {
      open_device(address);
    } catch (const DeviceAddressError& error) {
      return std::string(error.what());
    } catch (const DeviceUnavailable& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("hand:?dof=3&bubble=0.04&rotation=null:&camera=null:?clutch=0"), "");
  EXPECT_EQ(refusal("hand:?camera="), "camera= has no value, expected a device, as spacenav:");
  EXPECT_EQ(refusal("hand:?dof=3&rotation="),
            "rotation= has no value, expected a device, as spacenav:");
  EXPECT_NE(refusal("hand:?camera=nul:").find("nearest is 'null:'"), std::string::npos);
  auto held = std::make_unique<Viewer>();
  auto strong = std::make_unique<Viewer>();
  strong->own.holds_person = true;
  EXPECT_THROW(make_camera_device(std::move(held), std::move(strong)), DeviceAddressError);
}

TEST(CameraDevice, a_session_has_the_same_bits_with_it_and_without) {
  const auto hash = [](std::unique_ptr<HapticDevice> device) {
    SessionConfig config = test::plane_session();
    bool has_camera = false;
    const SessionSummary s =
        run_lockstep(config, *device,
                     {[&](const HapticSample& h) { has_camera = h.device.has_camera; }, {}, {}});
    return std::pair(s.state_hash, has_camera);
  };
  const HandParams hand = test::plane_hand(HandPath::press);
  const auto [with, has] = hash(make_camera_device(make_hand(hand), std::make_unique<Viewer>()));
  const auto [without, has_not] = hash(make_hand(hand));
  EXPECT_EQ(with, without);
  EXPECT_TRUE(has);
  EXPECT_FALSE(has_not);
}

}  // namespace
}  // namespace thigma::detail
