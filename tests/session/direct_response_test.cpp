// The direct response through the whole loop: the object is where the hand has it, the force is
// that of the contacts.

#include <memory>
#include <stdexcept>

#include "support/mesh_session.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/loop/contact_step.h"
#include "thigma/recording/replay_session.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

using test::HeldDevice;
using test::kCubeHalf;

DeviceLimits soft_device() {
  DeviceLimits d;
  d.max_force = 2.0;
  d.max_stiffness = 500.0;
  return d;
}

SessionConfig direct_plane(const DeviceLimits& limits) {
  SessionConfig config = test::plane_session(0.05);
  use_direct_response(limits, config);
  return config;
}

/// The step with a device in the test's hand; one contact frame before each haptic one.
struct DirectBench {
  HeldDevice device;
  SessionConfig config;
  std::unique_ptr<Latest<LinearContactModel>> models =
      std::make_unique<Latest<LinearContactModel>>();
  HapticState state;
  ContactScratch scratch;
  ContactSample contact;
  double now = 0.0;

  DirectBench() {
    device.device_limits = soft_device();
    config = direct_plane(device.device_limits);
    config.haptic.safety.start_ramp = 0.0;
    config.haptic.safety.force_slew = 1e9;
    config.haptic.safety.torque_slew = 1e9;
    config.haptic.grasp_point = {0.010, 0.0, 0.020};
    config.haptic.device = device.device_limits;
    state = initial_state(config.haptic, config.world_from_body);
    reserve_contact_scratch(config.contact, scratch);
    device.state.buttons = kClutchButton;
  }
  HapticSample tick(bool has_fresh_model = true) {
    if (has_fresh_model) {
      contact_step(config.contact, {state.body, now, 0}, scratch, contact);
      models->publish(contact.model);
    }
    now += 1e-3;
    return haptic_step(config.haptic, {&device, models.get(), nullptr, nullptr},
                       {now, 1e-3, Fault::none}, state);
  }
  /// Moves the hand down at 0.5 m/s until the underside of the cube is `gap` above the plane.
  HapticSample lower_to(double gap) {
    HapticSample s;
    for (int i = 0; i < 120; ++i) s = tick();  // held, and clear long enough to be armed
    const double start = s.body.position.z();
    const double way = start - (kCubeHalf + gap);
    const double from = device.state.motion.pose.position.z();
    const int steps = std::max(1, static_cast<int>(way / 5e-4));
    for (int i = 1; i <= steps; ++i) {
      device.state.motion.pose.position.z() = from - way * i / steps;
      s = tick();
    }
    return tick();  // the model of this very pose
  }
};

TEST(DirectSession, ToleranceIsWhereTheBestStiffnessMeetsTheGreatestForce) {
  const SessionConfig config = direct_plane(soft_device());
  EXPECT_EQ(config.haptic.response, ResponseKind::direct);
  EXPECT_DOUBLE_EQ(config.contact.response.stiffness, 500.0);
  EXPECT_DOUBLE_EQ(config.contact.tolerance, 2.0 / 500.0);
  EXPECT_EQ(config.contact.response.damping, 0.0);
  DeviceLimits limp = soft_device();
  limp.max_force = 0.0;
  SessionConfig other = test::plane_session();
  EXPECT_THROW(use_direct_response(limp, other), std::invalid_argument);
}

TEST(DirectSession, ASafetyLimitBelowTheDevicesCounts) {
  SessionConfig config = test::plane_session();
  config.haptic.safety.max_force = 1.0;
  use_direct_response(soft_device(), config);
  EXPECT_DOUBLE_EQ(config.contact.tolerance, 1.0 / 500.0);
}

TEST(DirectSession, ForceIsStiffnessTimesWhatIsLeftOfTheTolerance) {
  for (const double gap : {0.0038, 0.003, 0.002, 0.001, 1e-5}) {
    SCOPED_TRACE(gap);
    DirectBench b;
    const HapticSample s = b.lower_to(gap);
    ASSERT_TRUE(s.is_armed);
    EXPECT_NEAR(s.command.force.z(), 500.0 * (0.004 - gap), 1e-6);
    EXPECT_NEAR(s.command.force.x(), 0.0, 1e-9);
    // About the handle, which holds the cube 10 mm beside its middle.
    const double lever = s.body.position.x() - s.handle.pose.position.x();
    EXPECT_NEAR(lever, -0.010, 1e-12);
    EXPECT_NEAR(s.command.torque.y(), -lever * s.command.force.z(), 1e-9);
    EXPECT_EQ(s.coupling.force, Vec3::Zero());
    EXPECT_NEAR(s.stretch, 0.0, 1e-12);
  }
}

TEST(DirectSession, TheObjectFollowsTheHandExactlyAndThroughTheSurface) {
  DirectBench b;
  const HapticSample s = b.lower_to(-0.003);
  EXPECT_NEAR(s.penetration, 0.003, 1e-9);
  EXPECT_NEAR(s.command.force.norm(), 2.0, 1e-9);  // no more than the device has
  const Vec3 held =
      transform_point({s.body.position, s.body.orientation}, b.config.haptic.grasp_point);
  EXPECT_NEAR((held - s.handle.pose.position).norm(), 0.0, 1e-12);
}

TEST(DirectSession, AStaleModelFadesToZeroAndLatches) {
  DirectBench b;
  HapticSample s = b.lower_to(0.001);
  const double full = s.command.force.z();
  double before = full;
  for (int age = 1; age < 60 && s.fault == Fault::none; ++age) {
    s = b.tick(false);
    EXPECT_LE(s.command.force.z(), before + 1e-12);
    if (age < 24) {
      EXPECT_NEAR(s.command.force.z(), full, 1e-9);
    }
    before = s.command.force.z();
  }
  EXPECT_EQ(s.fault, Fault::contact_stale);
  EXPECT_EQ(s.command.force, Vec3::Zero());
  EXPECT_EQ(b.device.written.force, Vec3::Zero());
}

TEST(DirectSession, ALostDeviceGetsZeroAndTheObjectStays) {
  DirectBench b;
  const HapticSample before = b.lower_to(0.001);
  b.device.state.status = DeviceStatus::lost;
  const HapticSample s = b.tick();
  EXPECT_EQ(s.fault, Fault::device_lost);
  EXPECT_EQ(b.device.written.force, Vec3::Zero());
  EXPECT_EQ(s.body.position, before.body.position);
}

TEST(DirectSession, AHandPressesOnMeshesAndTheSessionReplays) {
  test::MeshSession mesh(300.0, make_ball(0.015, 6));
  use_direct_response(make_hand(mesh.hand(HandPath::press))->limits(), mesh.config);
  mesh.start = find_start(mesh.config.contact, mesh.config.world_from_body);
  mesh.config.world_from_body = mesh.start.world_from_body;
  mesh.config.duration = 3.0;
  const HandParams params = mesh.hand(HandPath::press);
  const std::unique_ptr<HapticDevice> hand = make_hand(params);
  const test::Kept kept(mesh.config, *hand);
  EXPECT_TRUE(kept.summary.safety_events.empty());
  EXPECT_GT(kept.summary.force_max, 0.3);
  EXPECT_LE(kept.summary.force_max, hand->limits().max_force * (1.0 + 1e-12));
  EXPECT_LT(kept.summary.stretch_max, 1e-9);
  HapticParams recorded = mesh.config.haptic;
  recorded.device = hand->limits();
  const ReplayReport report =
      replay_session(recorded, mesh.config.world_from_body, kept.samples, kept.models);
  EXPECT_TRUE(report.identical) << report.reason;
}

}  // namespace
}  // namespace thigma
