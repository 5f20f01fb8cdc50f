// The closed loop of simulated hand and sampled wall, against the stability bounds of Protocol E3
// (docs/sources.md).
#include <algorithm>
#include <cmath>

#include "device/tick.h"
#include "support/plain_hands.h"
#include <gtest/gtest.h>

#include "thigma/device/hand.h"

namespace thigma {
namespace {

using test::kTick;

using test::bare_mass;
using test::resting;

// A one-sided wall of stiffness k and damping b along -z at depth `wall`, sampled once a tick.
struct Wall {
  double stiffness, damping, depth;
  double last = 0.0;
  double force(double z) {
    const double into = -z - depth;
    const double rate = (into - last) / kTick;
    last = into;
    return into > 0.0 ? std::max(0.0, stiffness * into + damping * rate) : 0.0;
  }
};

TEST(HandStability, PressesWithTheForceAskedFor) {
  for (const double stiffness : {200.0, 500.0, 2000.0}) {
    for (const double force : {0.5, 2.0}) {
      HandParams p;
      p.program.path = HandPath::press;
      p.program.force = force;
      const auto hand = make_hand(p);
      Wall wall{stiffness, 0.0, 0.02};
      double worst = 0.0;
      for (int i = 0; i < 3000; ++i) {
        const DeviceState state = hand->read(i * kTick);
        const double f = wall.force(state.motion.pose.position.z());
        hand->write({{0.0, 0.0, f}, Vec3::Zero()});
        if (i > 2700) worst = std::max(worst, std::fabs(f - force));
      }
      // One encoder step of the wall is the finest force there is.
      EXPECT_LE(worst, 0.05 * force + stiffness * p.encoder) << stiffness << " " << force;
    }
  }
}

struct Swing {
  double early, late;  // largest |x| in the first and last tenth
};

// Device A of docs/sources.md, E3 with b = 0 against a wall on both sides, `late` ticks of delay.
Swing swing_against_wall(double mass, double stiffness, double damping, int late, int ticks) {
  HandParams p = bare_mass(mass);
  p.delay = late * kTick;
  const auto hand = make_hand(p);
  Swing swing{0.0, 0.0};
  double before = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double x = hand->read(i * kTick).motion.pose.position.x();
    const double force = i == 0 ? 0.01 : -(stiffness * x + damping * (x - before) / kTick);
    before = x;
    hand->write({{force, 0.0, 0.0}, Vec3::Zero()});
    if (10 * i < ticks && i > 0) swing.early = std::max(swing.early, std::fabs(x));
    if (10 * i >= 9 * ticks) swing.late = std::max(swing.late, std::fabs(x));
  }
  return swing;
}

TEST(HandStability, SampledWallIsStableExactlyWithinTheClosedFormBound) {
  // E3 (docs/sources.md), check 1: stable iff 0 < alpha < 2 beta (2 - beta) / (2 + beta), from the
  // characteristic polynomial.
  const double mass = 0.1;
  for (const double beta : {0.2, 0.5, 0.828, 1.2, 1.7}) {
    const double bound = 2.0 * beta * (2.0 - beta) / (2.0 + beta);
    const auto run = [&](double alpha) {
      return swing_against_wall(mass, alpha * mass / (kTick * kTick), beta * mass / kTick, 0, 3000);
    };
    const Swing inside = run(0.97 * bound);
    const Swing outside = run(1.03 * bound);
    EXPECT_LT(inside.late, 0.5 * inside.early) << beta;
    EXPECT_GT(outside.late, 2.0 * outside.early) << beta;
  }
}

TEST(HandStability, OneSampleOfDelayShrinksTheStableRange) {
  // docs/sources.md, E3: largest stable alpha 0.145 near beta 0.42 with one sample of delay.
  const double mass = 0.1;
  const auto run = [&](double alpha) {
    return swing_against_wall(mass, alpha * mass / (kTick * kTick), 0.42 * mass / kTick, 1, 3000);
  };
  const Swing inside = run(0.145 * 0.96);
  const Swing outside = run(0.145 * 1.04);
  EXPECT_LT(inside.late, 0.5 * inside.early);
  EXPECT_GT(outside.late, 2.0 * outside.early);
}

double rest_amplitude_in_wall(double stiffness, double device_damping) {
  HandParams p = bare_mass(0.1);
  p.damping = device_damping;
  const auto hand = make_hand(p);
  double low = 1e9;
  double high = -1e9;
  for (int i = 0; i < 10000; ++i) {
    const double x = hand->read(i * kTick).motion.pose.position.x();
    // Pushed into the wall by a constant 2 N.
    hand->write({{2.0 - (x > 0.0 ? stiffness * x : 0.0), 0.0, 0.0}, Vec3::Zero()});
    if (i >= 9000) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  return high - low;
}

TEST(HandStability, InstabilityIsVisibleBeyondTheZWidth) {
  // b > K T / 2: with b = 1 N s/m and 1 ms the bound is 2 kN/m.
  EXPECT_LT(rest_amplitude_in_wall(1500.0, 1.0), 1e-6);
  EXPECT_GT(rest_amplitude_in_wall(20000.0, 1.0), 1e-4);
}

double press_amplitude(double stiffness, double delay) {
  HandParams p;
  p.program.path = HandPath::press;
  p.delay = delay;
  const auto hand = make_hand(p);
  Wall wall{stiffness, 0.0, 0.02};
  double low = 1e9;
  double high = -1e9;
  for (int i = 0; i < 4000; ++i) {
    const double z = hand->read(i * kTick).motion.pose.position.z();
    hand->write({{0.0, 0.0, wall.force(z)}, Vec3::Zero()});
    if (i >= 3000) {
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  return high - low;
}

TEST(HandStability, PressesWithoutHuntingUntilDelayMakesItUnstable) {
  // E3 (docs/sources.md), check 4: K < (b + B) / (T / 2 + delay). The arm's 8 N s/m at 500 N/m
  // allow about 15 ms.
  const HandParams p;
  EXPECT_LE(press_amplitude(500.0, 0.0), p.encoder * 1.001);
  EXPECT_LE(press_amplitude(500.0, 0.010), p.encoder * 1.001);
  EXPECT_GT(press_amplitude(500.0, 0.030), 1e-3);
  EXPECT_GT(press_amplitude(2000.0, 0.010), 1e-3);
}

}  // namespace
}  // namespace thigma
