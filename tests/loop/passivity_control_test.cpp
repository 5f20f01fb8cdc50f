#include "thigma/loop/passivity_control.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/device/hand.h"
#include "thigma/loop/passivity.h"
#include "thigma/math/elementary.h"

namespace thigma {
namespace {

constexpr double kTick = 1e-3;

enum class World { spring, wall };

/// A hand on a spring or at a wall that loses nothing, samples `delay` late, with the controller or
/// without; what the port gave.
struct Ran {
  EnergyObserver port;  // of the true motion
  PassivityControl control;
  double force_max = 0.0;  // [N]
};

Ran run(World world, double stiffness, double delay, bool is_controlled) {
  HandParams p;
  p.delay = delay;
  p.program.path = world == World::spring ? HandPath::circle : HandPath::demo;
  p.program.clearance = 0.01;
  p.program.slide_speed = 0.1;
  HandDevice hand(p);
  PassivityParams params = passivity_for(stiffness, 1e-3 * stiffness, kTick, delay);
  Ran ran;
  for (int i = 0; i < 4000; ++i) {
    const double now = i * kTick;
    const DeviceState state = hand.read(now);
    const Vec3& at = state.motion.pose.position;
    Wrench wrench;
    if (world == World::spring) wrench.force = -stiffness * at;
    if (world == World::wall) wrench.force.z() = std::max(0.0, -stiffness * (at.z() + 0.01));
    if (is_controlled) {
      observe_handle(params, state.motion, now, ran.control);
      wrench = passive_wrench(params, state.motion, wrench, now, ran.control);
    }
    hand.write(wrench);
    observe_motion(ran.port, hand.true_motion().pose);
    observe_wrench(ran.port, hand.applied_wrench());
    ran.force_max = std::max(ran.force_max, wrench.force.norm());
  }
  return ran;
}

TEST(PassivityControl, TakesBackWhatALateSpringGivesAway) {
  for (const double delay : {0.005, 0.015}) {
    const Ran free = run(World::spring, 480.0, delay, false);
    const Ran held = run(World::spring, 480.0, delay, true);
    EXPECT_LT(free.port.energy_min, -5e-4) << delay;
    EXPECT_GE(held.port.energy_min, free.port.energy_min / 20.0) << delay;
    EXPECT_GT(held.control.acted_frames, 100u);
    EXPECT_GT(held.force_max, 0.9 * free.force_max) << delay;
  }
}

// Pressed, rubbed, tapped at: late walls push on while the hand is leaving already.
TEST(PassivityControl, TakesBackWhatALateWallGivesAway) {
  struct Case {
    double stiffness, delay;
  };
  for (const Case& c : {Case{800.0, 0.005}, Case{300.0, 0.015}, Case{480.0, 0.015}}) {
    const Ran free = run(World::wall, c.stiffness, c.delay, false);
    const Ran held = run(World::wall, c.stiffness, c.delay, true);
    EXPECT_LT(free.port.energy_min, -2e-3) << c.stiffness << ' ' << c.delay;
    EXPECT_GE(held.port.energy_min, free.port.energy_min / 20.0) << c.stiffness << ' ' << c.delay;
    EXPECT_GE(held.port.energy_min, -1e-3) << c.stiffness << ' ' << c.delay;
    EXPECT_GT(held.force_max, 1.0) << c.stiffness << ' ' << c.delay;  // and the wall is there
  }
}

TEST(PassivityControl, LeavesAPassiveWorldAlone) {
  PassivityControl control;
  const PassivityParams params{.is_on = true, .delay = 0.0, .max_damping = 5.0};
  Motion handle;
  std::uint64_t changed = 0;
  for (int i = 0; i < 500; ++i) {
    handle.pose.position.x() = 0.01 * sine(0.02 * i);
    handle.twist.linear.x() = 0.01 * 0.02 / kTick * cosine(0.02 * i);
    observe_handle(params, handle, i * kTick, control);
    const Wrench drag{-2.0 * handle.twist.linear, Vec3::Zero()};
    const Wrench sent = passive_wrench(params, handle, drag, i * kTick, control);
    if (i >= 5) changed += sent.force != drag.force ? 1 : 0;  // before, nothing has been put in
  }
  EXPECT_EQ(changed, 0u);
  EXPECT_GT(control.energy, 0.0);
}

TEST(PassivityControl, ChargesEachMotionToTheWrenchThatDroveIt) {
  // Samples two frames late: the wrench of frame 3 is the one that acts on the step from sample 3
  // to 4, which arrive in frames 5 and 6. Late ticks change nothing in that.
  for (const bool is_late : {false, true}) {
    PassivityControl control;
    const PassivityParams params{
        .is_on = true, .delay = 2.0 * kTick, .max_damping = 0.0, .credit = 1e9};
    Motion handle;
    for (int frame = 0; frame < 10; ++frame) {
      if (is_late && frame == 4) continue;  // the wrench of frame 3 is held on
      if (frame == 6) handle.pose.position.x() = 0.5;
      observe_handle(params, handle, frame * kTick, control);
      const double force = frame == 3 ? -4.0 : -1.0;
      const Wrench sent = passive_wrench(params, handle, {Vec3(force, 0.0, 0.0), Vec3::Zero()},
                                         frame * kTick, control);
      ASSERT_EQ(sent.force.x(), force);
    }
    EXPECT_DOUBLE_EQ(control.energy, 4.0 * 0.5) << is_late;
  }
}

TEST(PassivityControl, ASpringHoldsNoMoreThanWasPutIn) {
  PassivityControl control;
  PassivityParams params = passivity_for(400.0, 0.2, kTick, 0.0);
  params.acceleration = params.angular_acceleration = 0.0;
  params.credit = 1e-4;
  const Wrench wanted{Vec3(0.0, 0.0, 2.0), Vec3(0.0, 0.01, 0.0)};
  Motion still;
  observe_handle(params, still, 0.0, control);
  const Wrench sent = passive_wrench(params, still, wanted, 0.0, control);
  const double held =
      0.5 * sent.force.squaredNorm() / 400.0 + 0.5 * sent.torque.squaredNorm() / 0.2;
  EXPECT_NEAR(held, 1e-4, 1e-12);
  EXPECT_NEAR(sent.force.z() * wanted.torque.y(), sent.torque.y() * wanted.force.z(), 1e-15);
}

TEST(PassivityControl, NeverMoreThanItsMostAndNothingOnAZeroWrench) {
  const PassivityParams params{.is_on = true, .max_damping = 3.0, .max_angular_damping = 0.3};
  PassivityControl control;
  Motion handle;
  handle.twist.linear.x() = 0.1;
  handle.twist.angular.y() = 2.0;
  control.energy = -1.0;  // far in debt: nothing of what is wanted goes out, and nothing pulls
  observe_handle(params, handle, 0.0, control);
  const Wrench wanted{Vec3(1.0, 0.0, 0.0), Vec3::Zero()};
  const Wrench sent = passive_wrench(params, handle, wanted, 0.0, control);
  EXPECT_EQ(sent.force, Vec3::Zero());
  EXPECT_NEAR(sent.torque.y(), -0.3 * 2.0, 1e-12);
  EXPECT_EQ(control.damping, 3.0);
  const Wrench zero = passive_wrench(params, handle, Wrench{}, kTick, control);
  EXPECT_EQ(zero.force, Vec3::Zero());
  EXPECT_EQ(zero.torque, Vec3::Zero());
}

}  // namespace
}  // namespace thigma
