#include "thigma/loop/haptic_step.h"

#include <cmath>
#include <limits>
#include <memory>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/loop/contact_step.h"
#include "thigma/math/elementary.h"
#include "thigma/math/infinity.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::HeldDevice;
using test::plane_session;

/// A step with everything it touches, ticked by hand.
struct Bench {
  SessionConfig config = plane_session(0.05);
  HeldDevice device;
  std::unique_ptr<Latest<LinearContactModel>> models =
      std::make_unique<Latest<LinearContactModel>>();
  std::unique_ptr<Latest<StampedBody>> bodies = std::make_unique<Latest<StampedBody>>();
  SpscRing<HapticSample> ring{1024};
  HapticState state;
  ContactScratch scratch;
  ContactSample contact;
  double now = 0.0;

  Bench() {
    config.haptic.safety.start_ramp = 0.0;
    config.haptic.safety.force_slew = 1e9;
    config.haptic.safety.torque_slew = 1e9;
    begin();
  }
  void begin() {
    config.haptic.device = device.device_limits;
    state = initial_state(config.haptic, config.world_from_body);
    reserve_contact_scratch(config.contact, scratch);
  }
  void press(bool is_pressed) { device.state.buttons = is_pressed ? kClutchButton : 0u; }
  HapticSample tick(double elapsed = 1e-3, bool has_fresh_model = true) {
    if (has_fresh_model) {
      contact_step(config.contact, {state.body, now, 0}, scratch, contact);
      models->publish(contact.model);
    }
    now += elapsed;
    return haptic_step(config.haptic, {&device, models.get(), bodies.get(), &ring},
                       {now, elapsed, Fault::none}, state);
  }
  HapticSample ticks(int count) {
    HapticSample s;
    for (int i = 0; i < count; ++i) s = tick();
    return s;
  }
};

TEST(HapticStep, AnObjectNobodyHoldsStaysWhereItIs) {
  Bench b;
  b.config.haptic.body.gravity = {0.0, 0.0, -9.81};
  b.begin();
  const HapticSample s = b.ticks(500);
  EXPECT_EQ(s.body.position, b.config.world_from_body.position);
  EXPECT_EQ(b.device.written.force, Vec3::Zero());
  EXPECT_FALSE(s.is_grasped);
  EXPECT_FALSE(s.is_armed);
}

TEST(HapticStep, ClutchTakesHoldWithoutAJerkFromAnywhere) {
  Bench b;
  b.device.state.motion.pose.position = {0.3, -0.2, 0.1};
  b.press(true);
  const HapticSample s = b.tick();
  EXPECT_TRUE(s.is_grasped);
  EXPECT_TRUE(s.is_armed);
  EXPECT_NEAR((s.handle.pose.position - b.config.world_from_body.position).norm(), 0.0, 1e-15);
  EXPECT_NEAR(s.command.force.norm(), 0.0, 1e-12);
  EXPECT_NEAR(s.stretch, 0.0, 1e-15);
}

TEST(HapticStep, GraspPointOfTheSceneIsWhereTheHandleGoes) {
  Bench b;
  b.config.haptic.grasp_point = {0.01, 0.0, 0.02};
  b.press(true);
  const HapticSample s = b.tick();
  EXPECT_NEAR(
      (s.handle.pose.position - b.config.world_from_body.position - Vec3(0.01, 0.0, 0.02)).norm(),
      0.0, 1e-15);
}

TEST(HapticStep, HoldingAtTheHandleKeepsTheDistance) {
  Bench b;
  b.config.haptic.grasp_place = GraspPlace::handle;
  b.device.state.motion.pose.position = {0.1, 0.0, 0.2};
  b.press(true);
  HapticSample s = b.tick();
  EXPECT_NEAR((s.handle.pose.position - Vec3(0.1, 0.0, 0.2)).norm(), 0.0, 1e-15);
  EXPECT_NEAR(s.stretch, 0.0, 1e-15);
  EXPECT_EQ(s.body.position, b.config.world_from_body.position);
}

TEST(HapticStep, HeldObjectFollowsAndTheHandFeelsTheSpring) {
  Bench b;
  b.press(true);
  b.ticks(5);
  b.device.state.motion.pose.position.x() = 0.004;
  const HapticSample pulled = b.tick();
  EXPECT_LT(pulled.command.force.x(), -0.1);  // back towards the object
  const HapticSample s = b.ticks(2000);
  EXPECT_NEAR(s.body.position.x(), 0.004, 1e-6);
  EXPECT_NEAR(s.command.force.norm(), 0.0, 1e-3);
}

TEST(HapticStep, WeightIsFeltInTheHand) {
  Bench b;
  b.config.haptic.body.gravity = {0.0, 0.0, -9.81};
  b.begin();
  b.press(true);
  const HapticSample s = b.ticks(3000);
  EXPECT_NEAR(s.command.force.z(), -0.0981, 1e-5);
  EXPECT_NEAR(s.command.force.head<2>().norm(), 0.0, 1e-9);
}

TEST(HapticStep, ReleaseStopsAndRegraspStartsAtRestElsewhere) {
  Bench b;
  b.press(true);
  b.ticks(10);
  b.device.state.motion.pose.position.x() = 0.004;
  b.ticks(3);
  b.press(false);
  const HapticSample released = b.tick();
  EXPECT_FALSE(released.is_grasped);
  EXPECT_EQ(released.command.force, Vec3::Zero());
  EXPECT_EQ(released.body.linear_momentum, Vec3::Zero());
  const Vec3 left_at = released.body.position;
  b.device.state.motion.pose.position = {0.008, 0.002, 0.0};
  EXPECT_EQ(b.ticks(50).body.position, left_at);
  b.press(true);
  const HapticSample again = b.tick();
  EXPECT_TRUE(again.is_grasped);
  EXPECT_NEAR(again.stretch, 0.0, 1e-15);
  EXPECT_NEAR((again.handle.pose.position - left_at).norm(), 0.0, 1e-15);
}

TEST(HapticStep, ArmingNeverHappensInsideAContact) {
  Bench b;
  b.config.world_from_body.position.z() = test::kCubeHalf - 1e-4;  // in the plane
  b.begin();
  b.press(true);
  HapticSample s = b.ticks(200);
  EXPECT_TRUE(s.is_grasped);
  EXPECT_GT(s.touching, 0);
  EXPECT_FALSE(s.is_armed);
  EXPECT_EQ(b.device.written.force, Vec3::Zero());
  for (int i = 0; i < 100; ++i) {  // lifted out, with the hand
    b.device.state.motion.pose.position.z() += 1e-4;
    s = b.tick();
  }
  s = b.ticks(60);
  EXPECT_EQ(s.touching, 0);
  EXPECT_TRUE(s.is_armed);
}

TEST(HapticStep, PressingIsFeltAlongTheNormal) {
  Bench b;
  b.config.world_from_body.position.z() = test::kCubeHalf + 1e-3;
  b.begin();
  b.press(true);
  b.ticks(5);
  for (int i = 0; i < 50; ++i) {
    b.device.state.motion.pose.position.z() -= 1e-4;
    b.tick();
  }
  const HapticSample s = b.ticks(2000);
  // Handle 4 mm below touch: springs of 300 and 2000 N/m in series, the contact's starting at its
  // tolerance.
  const double expected = (0.004 + b.config.contact.tolerance) * 300.0 * 2000.0 / 2300.0;
  EXPECT_NEAR(s.command.force.z(), expected, 0.02 * expected);
  EXPECT_NEAR(s.command.force.head<2>().norm(), 0.0, 1e-3);
  EXPECT_NEAR(s.contact.force.z(), expected, 0.02 * expected);
  EXPECT_GT(s.touching, 0);
}

TEST(HapticStep, StepLengthIsAnArgument) {
  for (const double elapsed : {1e-4, 3e-3, 1e-2}) {
    Bench b;
    b.press(true);
    b.tick(elapsed);
    b.device.state.motion.pose.position.y() = 0.003;
    HapticSample s;
    for (double t = 0.0; t < 2.0; t += elapsed) s = b.tick(elapsed);
    EXPECT_NEAR(s.body.position.y(), 0.003, 1e-6) << elapsed;
  }
}

TEST(HapticStep, StaleModelFadesBothSidesAndLatches) {
  Bench b;
  b.config.world_from_body.position.z() = test::kCubeHalf + 1e-3;
  b.begin();
  b.press(true);
  b.ticks(5);
  for (int i = 0; i < 30; ++i) {
    b.device.state.motion.pose.position.z() -= 1e-4;
    b.tick();
  }
  const HapticSample full = b.ticks(1000);
  ASSERT_GT(full.command.force.z(), 0.3);
  double last = full.command.force.z();
  int frames_to_zero = 0;
  bool is_fading = true, ever_pulled = false;
  for (int i = 1; i <= 80; ++i) {
    const HapticSample s = b.tick(1e-3, false);
    const double force = s.command.force.z();
    if (s.model_age <= 0.025) {
      EXPECT_NEAR(force, full.command.force.z(), 1e-3);
    }
    is_fading = is_fading && force <= last + 1e-9;
    ever_pulled = ever_pulled || s.contact.force.z() < 0.0 || force < 0.0;
    if (force > 0.0) frames_to_zero = i;
    last = force;
  }
  EXPECT_TRUE(is_fading);
  EXPECT_FALSE(ever_pulled);
  EXPECT_LE(frames_to_zero, 50);
  EXPECT_GE(frames_to_zero, 45);
  EXPECT_EQ(b.state.safety.fault, Fault::contact_stale);
  EXPECT_EQ(b.device.written.force, Vec3::Zero());
  // A fresh model does not bring the force back.
  EXPECT_EQ(b.ticks(100).command.force, Vec3::Zero());
}

TEST(HapticStep, FaultsSendZeroInTheSameTickAndStay) {
  const auto faulty = [](void (*break_it)(HeldDevice&), Fault expected) {
    Bench b;
    b.config.haptic.body.gravity = {0.0, 0.0, -9.81};
    b.begin();
    b.press(true);
    ASSERT_GT(b.ticks(500).command.force.norm(), 0.09);
    const DeviceState good = b.device.state;
    break_it(b.device);
    HapticSample s = b.tick();
    EXPECT_EQ(s.fault, expected);
    EXPECT_EQ(b.device.written.force, Vec3::Zero());
    EXPECT_EQ(b.device.written.torque, Vec3::Zero());
    b.device.state = good;
    s = b.ticks(100);
    EXPECT_EQ(s.fault, expected);
    EXPECT_EQ(b.device.written.force, Vec3::Zero());
    EXPECT_TRUE(s.body.position.allFinite());
    clear_fault(b.state.safety);
    EXPECT_FALSE(b.ticks(100).is_armed);  // the clutch has to be let go first
    b.press(false);
    b.tick();
    b.press(true);
    EXPECT_TRUE(b.ticks(2).is_armed);
  };
  faulty([](HeldDevice& d) { d.state.status = DeviceStatus::lost; }, Fault::device_lost);
  faulty(
      [](HeldDevice& d) {
        d.state.motion.pose.position.y() = std::numeric_limits<double>::quiet_NaN();
      },
      Fault::not_finite);
  faulty([](HeldDevice& d) { d.state.motion.pose.orientation.coeffs().setZero(); },
         Fault::not_finite);
  faulty([](HeldDevice& d) { d.state.motion.pose.position.z() += 0.006; }, Fault::pose_jump);
  faulty([](HeldDevice& d) { d.state.motion.twist.linear.x() = 1.6; }, Fault::too_fast);
  faulty(
      [](HeldDevice& d) {
        const double half = std::sqrt(0.5);
        d.state.motion.pose.orientation =
            Quat(half, half, 0.0, 0.0) * d.state.motion.pose.orientation;
      },
      Fault::orientation_jump);
  faulty([](HeldDevice& d) { d.state.motion.twist.angular.y() = 25.1; }, Fault::turned_too_fast);
}

/// Pressed into the plane, with limits that ride out what is late.
struct RidingBench : Bench {
  RidingBench(bool holds_person) {
    config.haptic.safety.rides_out_gaps = true;
    config.haptic.safety.start_ramp = 0.1;
    config.haptic.safety.force_slew = 200.0;
    config.world_from_body.position.z() = test::kCubeHalf + 1e-3;
    begin();
    device.device_limits.holds_person = holds_person;
    use_device_limits(device.device_limits, config.haptic);
    press(true);
    ticks(200);
    for (int i = 0; i < 30; ++i) {
      device.state.motion.pose.position.z() -= 1e-4;
      tick();
    }
  }
  HapticSample late_tick() {
    contact_step(config.contact, {state.body, now, 0}, scratch, contact);
    models->publish(contact.model);
    now += 0.3;
    device.state.motion.pose.position.z() -= 0.02;  // farther than any tick may go
    HapticState before = state;
    const HapticPorts ports{&device, models.get(), bodies.get(), &ring};
    const HapticSample s = haptic_step(config.haptic, ports, {now, 0.01, Fault::watchdog}, state);
    // It is a function of what is recorded.
    const HapticSample again =
        haptic_step(config.haptic, ports, {s.time, s.elapsed, s.external_fault}, before);
    EXPECT_EQ(again.command.force, s.command.force);
    EXPECT_EQ(again.body.position, s.body.position);
    EXPECT_EQ(again.input_digest, s.input_digest);
    return s;
  }
};

TEST(HapticStep, ALateFrameIsRiddenOutWhereNobodyIsHeld) {
  RidingBench b(false);
  ASSERT_GT(b.ticks(500).command.force.z(), 0.3);
  const HapticSample late = b.late_tick();
  EXPECT_EQ(late.fault, Fault::none);
  EXPECT_TRUE(late.is_grasped);
  EXPECT_TRUE(late.is_armed);
  EXPECT_EQ(late.command.force, Vec3::Zero());
  EXPECT_EQ(late.command.torque, Vec3::Zero());
  double last = 0.0;
  for (int i = 0; i < 300; ++i) {
    const HapticSample s = b.tick();
    ASSERT_EQ(s.fault, Fault::none);
    // Over the ramp, and never faster than the slew limit.
    EXPECT_LE(s.command.force.norm(),
              b.device.device_limits.max_force * std::min(1.0, 1e-3 * (i + 1) / 0.1) + 1e-9);
    EXPECT_LE(s.command.force.norm(), last + 200.0 * 1e-3 + 1e-9);
    last = s.command.force.norm();
  }
  EXPECT_GT(last, 0.3);  // it came back, inside the contact
}

TEST(HapticStep, AnOldModelIsRiddenOutWhereNobodyIsHeld) {
  RidingBench b(false);
  ASSERT_GT(b.ticks(500).command.force.z(), 0.3);
  HapticSample s;
  for (int i = 0; i < 80; ++i) s = b.tick(1e-3, false);
  EXPECT_EQ(s.fault, Fault::none);
  EXPECT_TRUE(s.is_armed);
  EXPECT_EQ(s.command.force, Vec3::Zero());
  double last = 0.0;
  for (int i = 0; i < 300; ++i) {
    s = b.tick();
    EXPECT_LE(s.command.force.norm(), last + 200.0 * 1e-3 + 1e-9);
    last = s.command.force.norm();
  }
  EXPECT_EQ(s.fault, Fault::none);
  EXPECT_GT(last, 0.3);
}

TEST(HapticStep, NothingIsRiddenOutWhereTheDeviceHoldsAPerson) {
  RidingBench b(true);
  EXPECT_FALSE(b.config.haptic.safety.rides_out_gaps);
  ASSERT_GT(b.ticks(500).command.force.z(), 0.3);
  EXPECT_EQ(b.late_tick().fault, Fault::watchdog);
  for (int i = 0; i < 300; ++i) EXPECT_EQ(b.tick().command.force, Vec3::Zero());
  EXPECT_FALSE(b.state.safety.is_armed);
}

TEST(HapticStep, AStepWithoutATimeOrALengthIsAFault) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const HapticTick ticks[] = {{1.0, 0.0, Fault::none},
                              {1.0, -1e-3, Fault::none},
                              {1.0, kNan, Fault::none},
                              {kNan, 1e-3, Fault::none},
                              {1.0, kInfinity, Fault::none},
                              {0.45, 1e-3, Fault::none}};  // before the last: it would be new again
  for (const HapticTick& bad : ticks) {
    Bench b;
    b.config.haptic.body.gravity = {0.0, 0.0, -9.81};
    b.begin();
    b.press(true);
    ASSERT_GT(b.ticks(500).command.force.norm(), 0.09);
    const HapticState before = b.state;
    const HapticPorts ports{&b.device, b.models.get(), b.bodies.get(), nullptr};
    const HapticSample s = haptic_step(b.config.haptic, ports, bad, b.state);
    EXPECT_EQ(s.fault, Fault::not_finite);
    EXPECT_FALSE(s.is_armed);
    EXPECT_EQ(b.device.written.force, Vec3::Zero());
    EXPECT_EQ(b.device.written.torque, Vec3::Zero());
    EXPECT_TRUE(s.body.position.allFinite());
    EXPECT_TRUE(std::isfinite(s.time));
    EXPECT_EQ(s.time, before.time);
    // What is recorded of it replays to the same.
    HapticState again = before;
    const HapticSample replayed =
        haptic_step(b.config.haptic, ports, {s.time, s.elapsed, s.external_fault}, again);
    EXPECT_EQ(replayed.input_digest, s.input_digest);
    EXPECT_EQ(replayed.fault, s.fault);
    EXPECT_EQ(b.ticks(100).command.force, Vec3::Zero());
  }
}

TEST(HapticStep, ThreeAxisDevicesFeelTheSameForceAndNoTorque) {
  Bench six, three;
  three.device.device_limits.actuates_rotation = false;
  three.device.device_limits.max_torque = 0.0;
  three.begin();
  for (Bench* b : {&six, &three}) {
    b->config.haptic.grasp_point = {0.01, 0.0, 0.0};
    b->config.haptic.body.gravity = {0.0, 0.0, -9.81};
    b->begin();
    b->press(true);
  }
  const HapticSample a = six.ticks(300), c = three.ticks(300);
  EXPECT_EQ(a.command.force, c.command.force);
  EXPECT_GT(a.command.torque.norm(), 1e-4);
  EXPECT_EQ(c.command.torque, Vec3::Zero());
  EXPECT_EQ(c.feedback.torque, a.feedback.torque);  // computed and recorded all the same
}

TEST(HapticStep, WithoutSensedRotationButtonsTurnTheObject) {
  Bench b;
  b.device.device_limits.senses_rotation = false;
  b.begin();
  b.press(true);
  // nonsense that such a device may answer
  b.device.state.motion.pose.orientation = Quat(0.6, 0.8, 0.0, 0.0);
  HapticSample s = b.ticks(200);
  EXPECT_NEAR(std::abs(s.body.orientation.w()), 1.0, 1e-9);
  b.device.state.buttons |= kTurnButtons[4];
  s = b.ticks(1000);
  const double angle = 2.0 * arc_tangent2(s.body.orientation.z(), s.body.orientation.w());
  EXPECT_NEAR(angle, kButtonTurnRate * 1.0, 0.02);
}

TEST(HapticStep, PublishesTheStateAndTheSample) {
  Bench b;
  b.press(true);
  const HapticSample s = b.tick();
  ASSERT_TRUE(b.bodies->fetch());
  EXPECT_EQ(b.bodies->value().state.position, s.body.position);
  EXPECT_EQ(b.bodies->value().time, b.now);
  ASSERT_NE(b.ring.front(), nullptr);
  EXPECT_EQ(b.ring.front()->frame, 0u);
  EXPECT_EQ(b.ring.front()->input_digest, input_digest(s));
}

TEST(HapticStep, TheDevicesOwnClockMayTickItAtAnyPace) {
  // Uneven ticks with a clock of the device's: nothing but `now` and `elapsed` tells the time.
  Bench b;
  b.now = 1e6;
  b.press(true);
  b.tick();
  HapticSample s;
  for (int i = 0; i < 3000; ++i) {
    if (b.device.state.motion.pose.position.x() < 0.02)
      b.device.state.motion.pose.position.x() += 1e-5;
    s = b.tick(i % 3 == 0 ? 4e-4 : 1.1e-3);
    ASSERT_EQ(s.fault, Fault::none);
  }
  EXPECT_NEAR(s.body.position.x(), 0.02, 1e-5);
}

/// Grasped, armed, then without a device for a while.
void lose_the_device(Bench& b, bool resumes) {
  b.config.haptic.resumes_lost_device = resumes;
  b.press(true);
  b.ticks(10);
  b.device.state.motion.pose.position.x() = 0.004;
  EXPECT_GT(b.ticks(3).command.force.norm(), 0.0);
  b.device.state.status = DeviceStatus::lost;
  const HapticSample lost = b.tick();
  EXPECT_EQ(lost.fault, Fault::device_lost);
  EXPECT_EQ(lost.command.force, Vec3::Zero());
  b.ticks(20);
  b.device.state.status = DeviceStatus::ok;
}

TEST(HapticStep, LostDeviceIsTakenUpAgainByANewPressOfTheClutch) {
  Bench b;
  lose_the_device(b, true);
  b.device.state.motion.pose.position = {0.3, 0.1, -0.2};  // wherever it comes back
  EXPECT_EQ(b.ticks(20).fault, Fault::device_lost);        // still pressed: no new press
  b.press(false);
  EXPECT_EQ(b.ticks(20).fault, Fault::device_lost);
  b.press(true);
  HapticSample s = b.ticks(2);
  EXPECT_EQ(s.fault, Fault::none);
  EXPECT_TRUE(s.is_grasped);
  EXPECT_NEAR(s.command.force.norm(), 0.0, 1e-9);  // held anew, from rest
  b.device.state.motion.pose.position.x() += 0.002;
  EXPECT_GT(b.ticks(2).command.force.norm(), 0.0);
}

TEST(HapticStep, OtherFaultsAndOtherSessionsStayLatched) {
  Bench plain;
  lose_the_device(plain, false);
  plain.press(false);
  plain.ticks(3);
  plain.press(true);
  EXPECT_EQ(plain.ticks(3).fault, Fault::device_lost);

  Bench b;
  b.config.haptic.resumes_lost_device = true;
  b.press(true);
  b.ticks(5);
  b.device.state.motion.twist.linear.x() = std::numeric_limits<double>::quiet_NaN();
  b.tick();
  b.device.state.motion.twist.linear.x() = 0.0;
  b.press(false);
  b.ticks(3);
  b.press(true);
  EXPECT_EQ(b.ticks(3).fault, Fault::not_finite);
}

TEST(HapticStep, AHandThatFadesNeverPullsAndComesBackWithoutAJump) {
  Bench b;
  b.config.haptic.safety.force_slew = SafetyLimits{}.force_slew;
  b.press(true);
  b.ticks(1000);
  b.device.state.motion.pose.position.x() = 0.004;
  HapticSample s = b.ticks(300);
  b.device.state.motion.pose.position.x() = 0.008;
  s = b.ticks(3);  // stretched: the spring is on its way
  ASSERT_GT(s.command.force.norm(), 0.3);
  for (int i = 0; i < 200; ++i) {  // fades faster than the object follows
    b.device.state.weight = std::max(0.0, b.device.state.weight - 0.02);
    s = b.tick();
    ASSERT_EQ(s.fault, Fault::none);
    ASSERT_TRUE(s.is_grasped && s.is_armed);
  }
  EXPECT_EQ(s.command.force, Vec3::Zero());
  EXPECT_EQ(s.command.torque, Vec3::Zero());
  const Vec3 rest = b.state.body.position;
  b.device.state.motion.pose.position.x() = 0.012;  // where a late page would have it
  s = b.ticks(500);
  EXPECT_LT((s.body.position - rest).norm(), 1e-6);  // nothing pulls
  EXPECT_EQ(s.command.force, Vec3::Zero());

  Vec3 force = s.command.force, place = s.body.position;
  const double slew = b.config.haptic.safety.force_slew, speed = b.config.haptic.safety.max_speed;
  for (int i = 0; i < 600; ++i) {
    b.device.state.weight = std::min(1.0, b.device.state.weight + 1e-3 / 0.3);
    s = b.tick();
    ASSERT_LE((s.command.force - force).norm(), 1.001e-3 * slew) << i;
    ASSERT_LE((s.body.position - place).norm(), 1e-3 * speed) << i;
    force = s.command.force;
    place = s.body.position;
  }
  EXPECT_NEAR(s.body.position.x(), s.handle.pose.position.x(), 1e-3);
}

TEST(HapticStep, ATimeThatStandsStillIsNone) {
  Bench b;
  b.press(true);
  b.ticks(100);
  b.now -= 1e-3;  // the time of the step before once more
  EXPECT_EQ(b.tick(1e-3, false).fault, Fault::none);
}

// Damping for what the device has no motor for would be booked as given.
TEST(HapticStep, PassivityAsksNothingOfAxesWithoutAMotor) {
  Bench b;
  b.config.world_from_body.position.z() = test::kCubeHalf + 1e-3;
  b.device.device_limits.actuates_rotation = false;
  b.device.device_limits.max_torque = 0.1;  // that of a unit not confirmed yet
  b.config.haptic.passivity = passivity_for(30.0, 0.3, 1e-3, 0.0);  // holds ten times the energy
  b.begin();
  b.press(true);
  b.ticks(200);
  int damped = 0;
  for (int i = 0; i < 200; ++i) {
    Motion& handle = b.device.state.motion;
    handle.pose.position.z() -= 5e-5;
    handle.pose.orientation = rotation_from_vector(Vec3(0.0, 0.0, 5e-3 * i));
    handle.twist.angular = Vec3(0.0, 0.0, 5.0);
    const HapticSample s = b.tick();
    ASSERT_EQ(s.fault, Fault::none);
    ASSERT_EQ(s.command.torque, Vec3::Zero());
    const PassivityControl& control = b.state.passivity;
    ASSERT_EQ(control.sent[(control.count - 1) % PassivityControl::kMostFrames].wrench.torque,
              Vec3::Zero());
    damped += s.command.force != s.feedback.force ? 1 : 0;
  }
  EXPECT_GT(damped, 0);
}

TEST(HapticStep, AWeightThatIsNoShareIsAFault) {
  for (const double wrong : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    Bench b;
    b.press(true);
    b.ticks(10);
    b.device.state.weight = wrong;
    const HapticSample s = b.tick();
    EXPECT_EQ(s.fault, Fault::not_finite) << wrong;
    EXPECT_EQ(s.command.force, Vec3::Zero());
  }
}

}  // namespace
}  // namespace thigma
