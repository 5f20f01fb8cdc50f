#include "thigma/loop/safety.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr double kTick = 1e-3;

/// Armed long ago, out of contact, with a device of 3 N and 0.1 N m.
struct Armed {
  SafetyLimits limits;
  DeviceLimits device;
  SafetyState state;
  Armed() {
    device.max_force = 3.0;
    device.max_torque = 0.1;
    state.is_armed = true;
    state.armed_time = -10.0;
  }
  Wrench limit(const Wrench& wanted, double weight = 1.0, double now = 0.0) {
    return limit_wrench(limits, device, {wanted, weight}, {now, kTick}, state);
  }
  /// The limit of a wrench held long enough for the slew to have caught up.
  Wrench settle(const Wrench& wanted) {
    Wrench w;
    for (int i = 0; i < 200; ++i) w = limit(wanted);
    return w;
  }
};

DeviceState at(const Vec3& position) {
  DeviceState d;
  d.motion.pose.position = position;
  return d;
}

TEST(Safety, ClampsByNormAndKeepsTheDirection) {
  Armed a;
  const Vec3 force(3.0, -4.0, 12.0), torque(0.3, 0.4, 0.0);
  const Wrench w = a.settle({force, torque});
  EXPECT_NEAR(w.force.norm(), 3.0, 1e-12);
  EXPECT_LE(w.force.norm(), 3.0 * (1.0 + 1e-15));
  EXPECT_NEAR(w.force.cross(force).norm(), 0.0, 1e-12);
  EXPECT_GT(w.force.dot(force), 0.0);
  EXPECT_NEAR(w.torque.norm(), 0.1, 1e-12);
  EXPECT_NEAR(w.torque.cross(torque).norm(), 0.0, 1e-12);
}

TEST(Safety, ConfiguredLimitBelowTheDevicesHolds) {
  Armed a;
  a.limits.max_force = 1.25;
  EXPECT_NEAR(a.settle({Vec3(0, 0, 5), Vec3::Zero()}).force.z(), 1.25, 1e-12);
}

TEST(Safety, SlewIsLimitedOutsideContactOnset) {
  Armed a;
  Wrench last;
  for (int i = 0; i < 20; ++i) {
    const Wrench w = a.limit({Vec3(0, 0, 3), Vec3(0.1, 0, 0)});
    EXPECT_LE((w.force - last.force).norm(), 200.0 * kTick * (1.0 + 1e-9));
    EXPECT_LE((w.torque - last.torque).norm(), a.limits.torque_slew * kTick * (1.0 + 1e-9));
    last = w;
  }
  EXPECT_NEAR(last.force.z(), 3.0, 1e-12);
}

TEST(Safety, ContactOnsetIsNotSlowedDown) {
  Armed a;
  update_arming(a.limits, true, true, 1.0, a.state);
  EXPECT_NEAR(a.limit({Vec3(0, 0, 2), Vec3::Zero()}, 1.0, 1.001).force.z(), 2.0, 1e-12);
  // Contact that lasts is no onset.
  update_arming(a.limits, true, true, 1.1, a.state);
  EXPECT_NEAR(a.limit({Vec3(0, 0, 3), Vec3::Zero()}, 1.0, 1.1).force.z(), 2.2, 1e-12);
}

TEST(Safety, ContactThatChattersStaysUnderTheSlewLimit) {
  Armed a;
  double last = 0.0;
  for (int i = 0; i < 100; ++i) {  // two of three ticks without contact
    const double now = 1.0 + i * kTick;
    const bool is_touching = i % 3 == 0;
    update_arming(a.limits, true, is_touching, now, a.state);
    const double force =
        a.limit({Vec3(0, 0, is_touching ? 2 : 0), Vec3::Zero()}, 1.0, now).force.z();
    if (i > 10) {
      EXPECT_LE(std::abs(force - last), a.limits.force_slew * kTick * (1.0 + 1e-9)) << i;
    }
    last = force;
  }
  update_arming(a.limits, true, false, 1.1, a.state);
  // After a free time a touch is crisp again.
  const double later = 1.1 + 2.1 * a.limits.onset_window;
  update_arming(a.limits, true, true, later, a.state);
  EXPECT_EQ(a.limit({Vec3(0, 0, 2), Vec3::Zero()}, 1.0, later).force.z(), 2.0);
}

TEST(Safety, NothingThatIsNotFiniteIsSent) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Wrench wanted{Vec3(0, 0, 1), Vec3(0.01, 0, 0)};
  const auto expect_zero = [](const Armed& a, const Wrench& w) {
    EXPECT_EQ(w.force, Vec3::Zero());
    EXPECT_EQ(w.torque, Vec3::Zero());
    EXPECT_EQ(a.state.fault, Fault::not_finite);
    EXPECT_FALSE(a.state.is_armed);
  };
  Armed step, weight, device;
  expect_zero(step, limit_wrench(step.limits, step.device, {wanted, 1.0}, {0.0, nan}, step.state));
  expect_zero(weight, weight.limit(wanted, nan));
  device.device.max_force = nan;
  device.limits.max_force = nan;
  expect_zero(device, device.limit(wanted));
}

TEST(Safety, RampsFromArmingOn) {
  Armed a;
  a.state.is_armed = false;
  EXPECT_EQ(a.limit({Vec3(0, 0, 1), Vec3::Zero()}).force.norm(), 0.0);
  update_arming(a.limits, true, false, 2.0, a.state);
  ASSERT_TRUE(a.state.is_armed);
  for (int k = 0; k <= 500; ++k) {
    const double now = 2.0 + k * kTick;
    const double force = a.limit({Vec3(0, 0, 1), Vec3::Zero()}, 1.0, now).force.z();
    EXPECT_NEAR(force, k / 500.0, 1e-9);
  }
}

TEST(Safety, ArmingNeedsTheHandAndNoContactForAWhile) {
  const SafetyLimits limits;
  SafetyState s;
  update_arming(limits, false, false, 0.0, s);
  EXPECT_FALSE(s.is_armed);
  update_arming(limits, true, true, 0.1, s);
  EXPECT_FALSE(s.is_armed);
  update_arming(limits, true, false, 0.11, s);  // bounced
  EXPECT_FALSE(s.is_armed);
  update_arming(limits, true, true, 0.12, s);
  update_arming(limits, true, false, 0.12 + 0.99 * limits.clear_before_arming, s);
  EXPECT_FALSE(s.is_armed);
  update_arming(limits, true, false, 0.12 + 1.01 * limits.clear_before_arming, s);
  EXPECT_TRUE(s.is_armed);
  update_arming(limits, true, true, 0.3, s);
  EXPECT_TRUE(s.is_armed);
  update_arming(limits, false, true, 0.4, s);
  EXPECT_FALSE(s.is_armed);
  latch_fault(s, Fault::pose_jump, 0.5);
  update_arming(limits, true, false, 0.6, s);
  EXPECT_FALSE(s.is_armed);
}

TEST(Safety, NotANumberStopsAndLatches) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Armed a;
    a.settle({Vec3(0, 0, 1), Vec3::Zero()});
    EXPECT_EQ(a.limit({Vec3(0, bad, 0), Vec3::Zero()}, 1.0, 3.0).force, Vec3::Zero());
    EXPECT_EQ(a.state.fault, Fault::not_finite);
    EXPECT_EQ(a.state.fault_time, 3.0);
    EXPECT_EQ(a.limit({Vec3(0, 0, 1), Vec3::Zero()}, 1.0, 4.0).force, Vec3::Zero());
    SafetyState s;
    DeviceState d = at(Vec3::Zero());
    d.motion.twist.angular.x() = bad;
    EXPECT_FALSE(check_device(a.limits, d, 0.0, kTick, s));
    EXPECT_EQ(s.fault, Fault::not_finite);
  }
}

TEST(Safety, SpeedAndJumpsAreFaults) {
  const SafetyLimits limits;
  SafetyState s;
  DeviceState d = at(Vec3::Zero());
  d.motion.twist.linear = {0.0, 1.49, 0.0};
  EXPECT_TRUE(check_device(limits, d, 0.0, kTick, s));
  d.motion.pose.position.x() = 0.0049;
  EXPECT_TRUE(check_device(limits, d, kTick, kTick, s));
  d.motion.twist.linear = {0.0, 1.51, 0.0};
  EXPECT_FALSE(check_device(limits, d, 2 * kTick, kTick, s));
  EXPECT_EQ(s.fault, Fault::too_fast);

  SafetyState jumping;
  EXPECT_TRUE(check_device(limits, at(Vec3::Zero()), 0.0, kTick, jumping));
  EXPECT_FALSE(check_device(limits, at({0.0, 0.0, 0.0051}), kTick, kTick, jumping));
  EXPECT_EQ(jumping.fault, Fault::pose_jump);
  EXPECT_EQ(jumping.fault_time, kTick);
}

TEST(Safety, AHandleThatIsTooFastCannotHideBehindAReportOfZero) {
  const SafetyLimits limits;
  const auto seconds_to_fault = [&](double speed, int every, SafetyState& s) {
    for (int i = 0; i < 1000; ++i) {
      const double x = speed * kTick * (i - i % every);  // the device has a new pose now and then
      DeviceState d = at({x, 0.0, 0.0});
      d.time = i * kTick;
      check_device(limits, d, d.time, kTick, s);
      if (s.fault != Fault::none) return i * kTick;
    }
    return 1e300;
  };
  SafetyState fast, faster, shaking, honest, slow_device;
  EXPECT_LE(seconds_to_fault(4.9, 1, fast), 0.002);
  EXPECT_EQ(fast.fault, Fault::too_fast);
  EXPECT_LE(seconds_to_fault(1.7, 1, faster), 0.030);
  EXPECT_EQ(faster.fault, Fault::too_fast);
  EXPECT_EQ(seconds_to_fault(1.49, 1, honest), 1e300);
  EXPECT_EQ(seconds_to_fault(1.2, 4, slow_device), 1e300);  // 4.8 mm at a time
  for (int i = 0; i < 5; ++i)
    check_device(limits, at({i % 2 * 0.0049, 0, 0}), i * kTick, kTick, shaking);
  EXPECT_EQ(shaking.fault, Fault::too_fast);
}

DeviceState turned(double angle, const Vec3& axis = Vec3::UnitY()) {
  DeviceState d = at(Vec3::Zero());
  d.motion.pose.orientation = rotation_from_vector(angle * axis);
  return d;
}

TEST(Safety, AnOrientationThatJumpsIsAFault) {
  const SafetyLimits limits;
  const double right_angle = 0.5 * std::numbers::pi;
  for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0.0, 0.8)}) {
    SafetyState s;
    EXPECT_TRUE(check_device(limits, turned(0.3, axis), 0.0, kTick, s));
    EXPECT_FALSE(check_device(limits, turned(0.3 + right_angle, axis), kTick, kTick, s));
    EXPECT_EQ(s.fault, Fault::orientation_jump);
    EXPECT_EQ(s.fault_time, kTick);
    EXPECT_STREQ(fault_name(s.fault), "orientation_jump");
    clear_fault(s);  // and is not seen again
    EXPECT_TRUE(check_device(limits, turned(0.3 + right_angle, axis), 2 * kTick, kTick, s));
  }
  SafetyState small;
  check_device(limits, turned(0.0), 0.0, kTick, small);
  EXPECT_TRUE(check_device(limits, turned(0.099), kTick, kTick, small));
  SafetyState slow_rate;  // 100 Hz: as far as the speed limit allows in a tick
  check_device(limits, turned(0.0), 0.0, 0.010, slow_rate);
  EXPECT_TRUE(check_device(limits, turned(0.24), 0.010, 0.010, slow_rate));
  EXPECT_FALSE(check_device(limits, turned(0.52), 0.020, 0.010, slow_rate));
}

TEST(Safety, TheOtherSignOfAQuaternionIsNoJump) {
  const SafetyLimits limits;
  SafetyState s;
  for (int i = 0; i < 100; ++i) {
    DeviceState d = turned(0.01 * i, Vec3(0.6, 0.0, 0.8));
    d.time = i * kTick;
    if (i % 2 == 1) d.motion.pose.orientation.coeffs() *= -1.0;
    if (i % 3 == 1) d.motion.pose.orientation.coeffs() *= 0.8;  // nor is another length
    EXPECT_TRUE(check_device(limits, d, d.time, kTick, s)) << i;
  }
}

TEST(Safety, TurningIsAFaultOnlyFasterThanAHandTurns) {
  const SafetyLimits limits;
  const auto seconds_to_fault = [&](double rate, int every, Fault expected) {
    SafetyState s;
    for (int i = 0; i < 2000; ++i) {
      DeviceState d = turned(rate * kTick * (i - i % every));
      d.time = i * kTick;
      check_device(limits, d, d.time, kTick, s);
      if (s.fault == Fault::none) continue;
      EXPECT_EQ(s.fault, expected);
      return i * kTick;
    }
    return 1e300;
  };
  EXPECT_EQ(seconds_to_fault(3.0, 1, Fault::none), 1e300);
  EXPECT_EQ(seconds_to_fault(24.8, 1, Fault::none), 1e300);  // many times around
  EXPECT_EQ(seconds_to_fault(20.0, 4, Fault::none), 1e300);  // 0.08 rad at a time
  EXPECT_LE(seconds_to_fault(90.0, 1, Fault::turned_too_fast), 0.003);
  EXPECT_LE(seconds_to_fault(30.0, 1, Fault::turned_too_fast), 0.025);
  SafetyState told;
  DeviceState d = turned(0.0);
  d.motion.twist.angular = {0.0, 0.0, -25.1};
  EXPECT_FALSE(check_device(limits, d, 0.0, kTick, told));
  EXPECT_EQ(told.fault, Fault::turned_too_fast);
}

TEST(Safety, AfterAClearedFaultTheOldPoseIsForgotten) {
  const SafetyLimits limits;
  SafetyState s;
  check_device(limits, at(Vec3::Zero()), 0.0, kTick, s);
  check_device(limits, at({0.1, 0.0, 0.0}), kTick, kTick, s);
  ASSERT_EQ(s.fault, Fault::pose_jump);
  latch_fault(s, Fault::watchdog, 5.0);  // the first one stays
  EXPECT_EQ(s.fault, Fault::pose_jump);
  clear_fault(s);
  EXPECT_TRUE(check_device(limits, at({0.1, 0.0, 0.0}), 2 * kTick, kTick, s));
  EXPECT_FALSE(s.is_armed);
}

TEST(Safety, LostAndSilentDevicesAreFaults) {
  const SafetyLimits limits;
  SafetyState lost;
  DeviceState d = at(Vec3::Zero());
  d.status = DeviceStatus::lost;
  EXPECT_FALSE(check_device(limits, d, 0.0, kTick, lost));
  EXPECT_EQ(lost.fault, Fault::device_lost);

  SafetyState silent;
  d.status = DeviceStatus::not_ready;
  EXPECT_FALSE(check_device(limits, d, 0.0, kTick, silent));  // nothing yet, and no fault
  EXPECT_EQ(silent.fault, Fault::none);
  d.status = DeviceStatus::ok;
  EXPECT_TRUE(check_device(limits, d, 1.0, kTick, silent));
  d.status = DeviceStatus::not_ready;
  EXPECT_TRUE(check_device(limits, d, 1.0 + 0.9 * limits.silent_device, kTick, silent));
  EXPECT_FALSE(check_device(limits, d, 1.0 + 1.1 * limits.silent_device, kTick, silent));
  EXPECT_EQ(silent.fault, Fault::device_lost);
}

TEST(Safety, ADeviceThatRepeatsItselfIsSilent) {
  const SafetyLimits limits;
  SafetyState stuck, slow, finished, stampless;
  DeviceState d = at(Vec3::Zero());
  d.time = 1.0;
  EXPECT_TRUE(check_device(limits, d, 1.0, kTick, stuck));
  EXPECT_TRUE(check_device(limits, d, 1.0 + 0.9 * limits.silent_device, kTick, stuck));
  EXPECT_FALSE(check_device(limits, d, 1.0 + 1.1 * limits.silent_device, kTick, stuck));
  EXPECT_EQ(stuck.fault, Fault::device_lost);
  for (int i = 0; i < 500; ++i) {  // a new sample each 20 ms, whatever its clock counts from
    d.time = 1e4 + i / 20;
    EXPECT_TRUE(check_device(limits, d, i * kTick, kTick, slow)) << i;
  }
  d.status = DeviceStatus::finished;  // has nothing more to say
  for (int i = 0; i < 500; ++i)
    EXPECT_TRUE(check_device(limits, d, i * kTick, kTick, finished)) << i;
  d.status = DeviceStatus::ok;
  d.time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(check_device(limits, d, 0.0, kTick, stampless));
  EXPECT_EQ(stampless.fault, Fault::not_finite);
}

TEST(Safety, OldModelsFadeTogetherWithTheWrenchAndLatchAtTheEnd) {
  Armed a;
  EXPECT_EQ(model_weight(a.limits, {0.025}, 0.0, kTick, a.state), 1.0);
  EXPECT_NEAR(model_weight(a.limits, {0.0375}, 0.0, kTick, a.state), 0.5, 1e-12);
  EXPECT_NEAR(model_weight(a.limits, {0.04999}, 0.0, kTick, a.state), 0.0, 1e-3);
  EXPECT_EQ(a.state.fault, Fault::none);
  const double full = a.settle({Vec3(0, 0, 2), Vec3(0.05, 0, 0)}).force.z();
  const Wrench faded = a.limit({Vec3(0, 0, 2), Vec3(0.05, 0, 0)}, 0.25);
  EXPECT_NEAR(faded.force.z(), 0.25 * full, 1e-12);
  EXPECT_NEAR(faded.torque.x(), 0.25 * 0.05, 1e-12);
  EXPECT_EQ(model_weight(a.limits, {0.050}, 7.0, kTick, a.state), 0.0);
  EXPECT_EQ(a.state.fault, Fault::contact_stale);
  EXPECT_EQ(a.state.fault_time, 7.0);
  EXPECT_EQ(a.limit({Vec3(0, 0, 2), Vec3::Zero()}).force, Vec3::Zero());
  SafetyState idle;  // an unarmed session waits for its first model without a fault
  EXPECT_EQ(model_weight(a.limits, {std::numeric_limits<double>::infinity()}, 0.0, kTick, idle),
            0.0);
  EXPECT_EQ(idle.fault, Fault::none);
}

// Models every `interval` for a second, then none for `pause`: the weight at the end of it.
double weight_after_pause(bool has_rows, double interval, double pause) {
  Armed a;
  double now = 0.0, made = 0.0, weight = 0.0;
  std::uint64_t sequence = 1;
  for (; now < 1.0 + pause; now += kTick) {
    if (now < 1.0 && now - made >= interval) {
      made = now;
      ++sequence;
    }
    weight = model_weight(a.limits, {now - made, made, sequence, has_rows}, now, kTick, a.state);
    if (has_rows && now > 0.2 && now < 1.0) {  // the first late one is not expected
      EXPECT_EQ(weight, 1.0) << now;
    }
  }
  return weight;
}

TEST(Safety, RowsThatComeSlowlyCountLonger) {
  EXPECT_EQ(weight_after_pause(true, 0.001, 0.060), 0.0);  // a thread that hangs is a fault as ever
  EXPECT_EQ(weight_after_pause(true, 0.033, 0.060), 1.0);  // one that is slow is not
  EXPECT_EQ(weight_after_pause(true, 0.033, 0.250), 0.0);  // but then it hangs
  EXPECT_EQ(weight_after_pause(false, 0.020, 0.060), 0.0);  // springs of old contacts are wrong
}

TEST(Safety, AFreshModelBringsTheWrenchBackAsGentlyAsItLeft) {
  Armed a;
  a.device.max_force = 30.0;  // so much that the weight alone would be faster than the slew limit
  a.device.max_torque = 1.0;
  const Wrench wanted{Vec3(0, 0, 20), Vec3(0.8, 0, 0)};
  const Wrench full = a.settle(wanted);
  const double fade = kTick / (a.limits.model_stale_age - a.limits.model_full_age);
  double weight = model_weight(a.limits, {0.049}, 0.0, kTick, a.state);
  EXPECT_NEAR(weight, fade, 1e-12);  // down at once
  Wrench last = a.limit(wanted, weight);
  EXPECT_NEAR(last.force.z(), fade * full.force.z(), 1e-12);
  for (int i = 0; i < 200; ++i) {
    const double now_weight = model_weight(a.limits, {0.001}, 0.0, kTick, a.state);
    EXPECT_LE(now_weight, weight + fade * (1.0 + 1e-9));
    const Wrench w = a.limit(wanted, now_weight);
    EXPECT_LE((w.force - last.force).norm(), a.limits.force_slew * kTick * (1.0 + 1e-9));
    EXPECT_LE((w.torque - last.torque).norm(), a.limits.torque_slew * kTick * (1.0 + 1e-9));
    EXPECT_GE(w.force.z(), last.force.z());
    weight = now_weight;
    last = w;
  }
  EXPECT_EQ(weight, 1.0);
  EXPECT_EQ(last.force, full.force);
  a.state.is_armed = false;  // unarmed there is nothing to feel
  a.state.weight = 0.0;
  EXPECT_EQ(model_weight(a.limits, {0.001}, 0.0, kTick, a.state), 1.0);
}

TEST(Safety, TorqueOfADeviceWithoutItIsStillComputed) {
  Armed a;
  a.device.actuates_rotation = false;
  a.device.max_torque = 0.0;
  EXPECT_NEAR(a.settle({Vec3::Zero(), Vec3(0, 0.02, 0)}).torque.y(), 0.02, 1e-12);
}

TEST(Safety, EveryFaultHasItsOwnName) {
  for (int i = 0; i <= static_cast<int>(Fault::watchdog); ++i) {
    for (int j = 0; j < i; ++j)
      EXPECT_STRNE(fault_name(static_cast<Fault>(i)), fault_name(static_cast<Fault>(j)));
  }
}

}  // namespace
}  // namespace thigma
