#include "thigma/runtime/passivity_control.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/device/hand.h"
#include "thigma/math/elementary.h"
#include "thigma/runtime/passivity.h"

namespace thigma {
namespace {

constexpr double kTick = 1e-3;

/// A spring on a hand that rocks against it, samples `delay` late, with the controller or without; what the port gave.
struct Rocked {
  EnergyObserver port;  // of the true motion
  PassivityControl control;
};

Rocked rock(double stiffness, double delay, bool is_controlled) {
  HandParams p;
  p.program.path = HandPath::circle;
  p.program.slide_length = 0.01;
  p.program.slide_speed = 0.1;
  p.delay = delay;
  HandDevice hand(p);
  const PassivityParams params = passivity_for(stiffness, 1e-3 * stiffness, kTick, delay);
  PassiveDevice passive(hand, params);
  HapticDevice& device = is_controlled ? static_cast<HapticDevice&>(passive) : hand;
  Rocked rocked;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 at = device.read(i * kTick).motion.pose.position;
    device.write({-stiffness * at, Vec3::Zero()});
    observe_motion(rocked.port, hand.true_motion().pose);
    observe_wrench(rocked.port, hand.applied_wrench());
  }
  rocked.control = passive.control();
  return rocked;
}

TEST(PassivityControl, TakesBackWhatALateSpringGivesAway) {
  for (const double delay : {0.005, 0.015}) {
    const Rocked free = rock(300.0, delay, false);
    const Rocked held = rock(300.0, delay, true);
    EXPECT_LT(free.port.energy_min, -5e-4) << delay;
    EXPECT_GT(held.port.energy_min, 0.25 * free.port.energy_min) << delay;
    EXPECT_GT(held.control.damped_frames, 100u);
  }
}

TEST(PassivityControl, LeavesAPassiveWorldAlone) {
  PassivityControl control;
  const PassivityParams params{.period = kTick, .delay = 0.0, .max_damping = 5.0};
  Motion handle;
  for (int i = 0; i < 500; ++i) {
    handle.pose.position.x() = 0.01 * sine(0.02 * i);
    handle.twist.linear.x() = 0.01 * 0.02 / kTick * cosine(0.02 * i);
    observe_handle(params, handle, control);
    const Wrench drag{-2.0 * handle.twist.linear, Vec3::Zero()};
    const Wrench sent = passive_wrench(params, handle, drag, control);
    ASSERT_EQ(sent.force, drag.force) << i;
  }
  EXPECT_EQ(control.damped_frames, 0u);
  EXPECT_GT(control.energy, 0.0);
}

TEST(PassivityControl, ChargesEachMotionToTheWrenchThatDroveIt) {
  // Samples two frames late: the wrench of frame 3 is the one that acts on the step from sample 3 to 4, which arrive in
  // frames 5 and 6.
  PassivityControl control;
  const PassivityParams params{.period = kTick, .delay = 2.0 * kTick, .max_damping = 0.0};
  Motion handle;
  for (int frame = 0; frame < 10; ++frame) {
    if (frame == 6) handle.pose.position.x() = 0.5;
    observe_handle(params, handle, control);
    const double force = frame == 3 ? -4.0 : -1.0;
    passive_wrench(params, handle, {Vec3(force, 0.0, 0.0), Vec3::Zero()}, control);
  }
  EXPECT_DOUBLE_EQ(control.energy, 4.0 * 0.5);
}

TEST(PassivityControl, NeverMoreThanItsMostAndNothingOnAZeroWrench) {
  PassivityControl control;
  const PassivityParams params{.period = kTick, .max_damping = 3.0, .max_angular_damping = 0.3};
  Motion handle;
  handle.twist.linear.x() = 0.1;
  handle.twist.angular.y() = 2.0;
  control.energy = -1.0;  // far in debt
  observe_handle(params, handle, control);
  const Wrench sent = passive_wrench(params, handle, {Vec3(1.0, 0.0, 0.0), Vec3::Zero()}, control);
  EXPECT_NEAR(sent.force.x(), 1.0 - 3.0 * 0.1, 1e-12);
  EXPECT_NEAR(sent.torque.y(), -0.3 * 2.0, 1e-12);
  const Wrench zero = passive_wrench(params, handle, Wrench{}, control);
  EXPECT_EQ(zero.force, Vec3::Zero());
  EXPECT_EQ(zero.torque, Vec3::Zero());
}

TEST(PassivityControl, TheDevicesMaximaHoldBehindIt) {
  HandParams p;
  p.max_force = 2.0;
  p.senses_rotation = p.actuates_rotation = false;
  HandDevice hand(p);
  PassiveDevice passive(hand, {.max_damping = 1e4, .max_angular_damping = 1e2});
  passive.read(0.0);
  passive.write({Vec3(0.0, 0.0, 50.0), Vec3(0.0, 1.0, 0.0)});
  EXPECT_NEAR(passive.sent().force.norm(), 2.0, 1e-12);
  EXPECT_EQ(passive.sent().torque, Vec3::Zero());
}

}  // namespace
}  // namespace thigma
