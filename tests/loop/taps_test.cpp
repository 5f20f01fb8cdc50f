// Taps as the hand gets them, through the haptic step.

#include <cmath>
#include <memory>
#include <vector>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/loop/haptic_step.h"
#include "thigma/loop/samples.h"

namespace thigma {
namespace {

constexpr double kStep = 1e-3, kBall = 0.01;

/// A ball of 30 g over the plane z = 0 under constraints, in a hand that the test moves.
struct Held {
  HapticParams params;
  test::HeldDevice device;
  std::unique_ptr<Latest<LinearContactModel>> models =
      std::make_unique<Latest<LinearContactModel>>();
  HapticState state;
  double now = 0.0;

  explicit Held(const std::vector<ImpactPair>& impacts, double height = 0.005) {
    params.response = ResponseKind::constrained;
    params.body = make_body(0.030, 1e-6 * Mat3::Identity());
    params.coupling.linear_stiffness = 500.0;
    params.coupling.linear_damping = 4.0;
    params.coupling.angular_stiffness = 0.3;
    params.coupling.angular_damping = 1e-3;
    params.constraint.slop = 1e-6;
    params.safety.start_ramp = 0.0;
    params.safety.clear_before_arming = 0.0;
    params.impacts = impacts;
    params.device = device.device_limits;
    state = initial_state(params, {Vec3(0.0, 0.0, kBall + height), Quat::Identity()});
    LinearContactModel model;
    model.sequence = 1;
    model.constraints.travel = 1.0;
    model.constraints.reach = kBall;
    model.constraints.state = state.body;
    ContactRow row = make_row(RowKind::scene_plane);
    row.id = 7;
    row.object_point = {0.0, 0.0, -kBall};
    row.scene_direction = -Vec3::UnitZ();
    model.constraints.rows.push_back(row);
    models->publish(model);
    models->fetch();
    device.state.buttons = kClutchButton;
  }
  HapticSample tick(Fault fault = Fault::none) {
    LinearContactModel fresh = models->value();
    fresh.time = now;
    fresh.sequence = state.frame + 1;
    models->publish(fresh);
    now += kStep;
    return haptic_step(params, {&device, models.get(), nullptr, nullptr}, {now, kStep, fault},
                       state);
  }
  /// Down at a speed to a depth, then still.
  HapticSample press(double speed, double depth) {
    double& z = device.state.motion.pose.position.z();
    const bool is_down = z <= -depth;
    if (!is_down) z -= speed * kStep;
    device.state.motion.twist.linear.z() = is_down ? 0.0 : -speed;
    return tick();
  }
};

/// Of the ball, upwards [m/s].
double state_speed(const Held& held) {
  return held.state.body.linear_momentum.z() / held.params.body.mass;
}

std::vector<ImpactPair> steel(double amplitude, double frequency, double decay) {
  return {{0.0, {amplitude, frequency, decay}}};
}

TEST(Taps, RingAsAsked) {
  struct Case {
    double amplitude, frequency, decay, speed;
  };
  for (const Case& c :
       {Case{5.0, 150.0, 0.015, 0.1}, Case{2.0, 80.0, 0.03, 0.05}, Case{8.0, 300.0, 0.008, 0.2}}) {
    Held held(steel(c.amplitude, c.frequency, c.decay));
    std::vector<double> force;
    double speed = 0.0;
    for (int k = 0; k < 400; ++k) {
      const double before = -state_speed(held);
      const HapticSample s = held.press(c.speed, 0.007);
      if (force.empty() && s.tap.force.norm() == 0.0) continue;
      if (force.empty()) speed = before;
      EXPECT_NEAR(s.tap.force.head<2>().norm(), 0.0, 1e-12);
      force.push_back(s.tap.force.z());
    }
    ASSERT_GT(force.size(), 20u);
    EXPECT_NEAR(speed, c.speed, 0.2 * c.speed);  // the coupling lags
    // The impact is in the step that ends at the first force.
    double worst = 0.0;
    for (std::size_t k = 0; k < force.size(); ++k) {
      const double t = kStep * static_cast<double>(k + 1);
      const double expected = t > 7.0 * c.decay ? 0.0
                                                : c.amplitude * speed * std::exp(-t / c.decay) *
                                                      std::sin(2.0 * M_PI * c.frequency * t);
      worst = std::max(worst, std::fabs(force[k] - expected));
    }
    // of the speed within the step of the impact
    EXPECT_LE(worst, 0.03 * c.amplitude * speed) << c.frequency;
  }
}

TEST(Taps, OffIsBitForBitAsBefore) {
  Held without({}), silent(steel(0.0, 150.0, 0.015));
  for (int k = 0; k < 300; ++k) {
    const HapticSample a = without.press(0.1, 0.008), b = silent.press(0.1, 0.008);
    StateHash first, second;
    add_frame(first, a.body, a.command);
    add_frame(second, b.body, b.command);
    ASSERT_EQ(first.value, second.value) << k;
    EXPECT_EQ(b.tap.force, Vec3::Zero());
  }
}

TEST(Taps, StayWithinTheLimits) {
  Held held(steel(50.0, 150.0, 0.015));
  held.params.safety.max_force = 2.0;
  held.params.device.max_force = 1.5;
  double most = 0.0, asked = 0.0;
  for (int k = 0; k < 300; ++k) {
    const HapticSample s = held.press(0.1, 0.008);
    most = std::max(most, s.command.force.norm());
    asked = std::max(asked, s.tap.force.norm());
  }
  EXPECT_GT(asked, 2.5);
  EXPECT_LE(most, 1.5 * (1.0 + 1e-12));
  EXPECT_GT(most, 1.4);
}

TEST(Taps, OnlyTheirOwnChangeIsNotSlowedDown) {
  Held held(steel(5.0, 150.0, 0.015));
  held.params.safety.force_slew = 50.0;
  Vec3 sent = Vec3::Zero(), tap = Vec3::Zero();
  double fastest = 0.0;
  for (int k = 0; k < 300; ++k) {
    const HapticSample s = held.press(0.1, 0.008);
    const double changed = (s.command.force - sent).norm();
    EXPECT_LE(changed, 50.0 * kStep + (s.tap.force - tap).norm() + 1e-12) << k;
    fastest = std::max(fastest, changed);
    sent = s.command.force;
    tap = s.tap.force;
  }
  EXPECT_GT(fastest, 2.0 * 50.0 * kStep);
}

TEST(Taps, NothingRingsAfterAFaultNorOnAReleasedObject) {
  for (const bool is_fault : {true, false}) {
    Held held(steel(5.0, 150.0, 0.05));
    HapticSample s;
    for (int k = 0; k < 300 && s.tap.force.norm() < 0.1; ++k) s = held.press(0.1, 0.008);
    ASSERT_GT(s.tap.force.norm(), 0.1);
    if (!is_fault) held.device.state.buttons = 0;
    for (int k = 0; k < 20; ++k) {
      s = held.tick(is_fault && k == 0 ? Fault::watchdog : Fault::none);
      EXPECT_EQ(s.command.force, Vec3::Zero());
      EXPECT_EQ(s.command.torque, Vec3::Zero());
    }
    EXPECT_TRUE(held.state.taps.voices.empty());
    EXPECT_EQ(held.state.taps.store, 0.0);
  }
}

/// Energy of taps that a hand of this mass, pushed down, is handed [J].
struct HandedOut {
  double most = 0.0;     // by taps alone, since the first impact
  double impacts = 0.0;  // that the body has lost in impacts
  double at_port = 0.0;  // what the observer missed of the outside account
  double step = 0.0;     // the most that a tap handed out in one step
  int taps = 0;
};

HandedOut tap_a_free_hand(double mass, double amplitude) {
  Held held(steel(amplitude, 150.0, 0.02));
  HandedOut out;
  double speed = -0.15, taps = 0.0, port = 0.0;
  Wrench last_tap, last_sent;
  for (int k = 0; k < 600; ++k) {
    double& z = held.device.state.motion.pose.position.z();
    const double force = -0.5 - 0.5 * speed + last_sent.force.z();
    speed += kStep * force / mass;
    z += kStep * speed;
    held.device.state.motion.twist.linear.z() = speed;
    taps += last_tap.force.z() * kStep * speed;
    out.step = std::max(out.step, last_tap.force.z() * kStep * speed);
    port -= last_sent.force.z() * kStep * speed;
    const double before = -state_speed(held);
    const HapticSample s = held.tick();
    const double after = -state_speed(held);
    if (s.touching > 0 && before > after && held.state.taps.voices.size() > 0 && before > 2e-3)
      out.impacts += 0.5 * held.params.body.mass * before * before;
    out.most = std::max(out.most, taps);
    out.at_port = std::max(out.at_port, std::fabs(s.energy - port));
    out.taps = std::max(out.taps, static_cast<int>(held.state.taps.voices.size()));
    last_tap = s.tap;
    last_sent = s.command;
  }
  return out;
}

TEST(Taps, HandOutNoMoreThanImpactsTake) {
  for (const double mass : {0.02, 0.1, 0.5}) {
    for (const double amplitude : {5.0, 40.0}) {
      const HandedOut out = tap_a_free_hand(mass, amplitude);
      ASSERT_GT(out.taps, 0);
      EXPECT_LE(out.at_port, 1e-12) << mass;  // the account at the port has them
      // and a step's worth, as the motion of the next step is only guessed
      EXPECT_LE(out.most, 1.1 * out.impacts + out.step) << mass << " kg, " << amplitude;
      RecordProperty("uj_" + std::to_string(static_cast<int>(1000 * mass)) + "g_" +
                         std::to_string(static_cast<int>(amplitude)),
                     std::to_string(1e6 * out.most) + " of " + std::to_string(1e6 * out.impacts));
    }
  }
}

}  // namespace
}  // namespace thigma
