#include "thigma/device/hand.h"

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <vector>

#include "device/tick.h"
#include "support/plain_hands.h"
#include <gtest/gtest.h>

#include "thigma/device/detail/velocity_estimate.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::kTick;

using test::bare_mass;
using test::resting;

// Response of m x'' + b x' + k x to a load step, underdamped.
double step_response(double m, double b, double k, double load, double t) {
  const double decay = b / (2.0 * m);
  const double w = std::sqrt(k / m - decay * decay);
  return load / k * (1.0 - std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t)));
}

TEST(Hand, StepResponseIsThatOfMassSpringDamper) {
  HandParams p = resting();
  p.friction = p.angular_friction = 0.0;
  const auto hand = make_hand(p);
  hand->read(0.0);
  const Wrench load{{0.5, 0.0, 0.0}, {0.0, 0.0, 0.02}};
  hand->write(load);
  for (int i = 1; i <= 500; ++i) {
    const double t = i * kTick;
    hand->read(t);
    const Pose& pose = hand->true_motion().pose;
    const double x = step_response(p.mass + p.arm_mass, p.damping + p.arm_damping, p.arm_stiffness,
                                   load.force.x(), t);
    const double angle =
        step_response(p.inertia + p.arm_inertia, p.angular_damping + p.arm_angular_damping,
                      p.arm_angular_stiffness, load.torque.z(), t);
    EXPECT_NEAR(pose.position.x(), x, 2e-6 * load.force.x() / p.arm_stiffness) << t;
    EXPECT_NEAR(vector_from_rotation(pose.orientation).z(), angle,
                2e-6 * load.torque.z() / p.arm_angular_stiffness)
        << t;
  }
}

TEST(Hand, FreeMassUnderHeldForceIsExact) {
  const auto hand = make_hand(bare_mass(0.1));
  hand->read(0.0);
  hand->write({{0.0, 2.0, 0.0}, Vec3::Zero()});
  for (int i = 1; i <= 100; ++i) hand->read(i * kTick);
  // x = F t^2 / 2m, whatever the sub-steps: the port must not create or lose energy of its own.
  EXPECT_NEAR(hand->true_motion().pose.position.y(), 2.0 * 0.01 / (2.0 * 0.1), 1e-13);
  EXPECT_NEAR(hand->true_motion().twist.linear.y(), 2.0 * 0.1 / 0.1, 1e-12);
}

TEST(Hand, FrictionHoldsBelowItsLimitAndBrakesAbove) {
  HandParams p = bare_mass(0.1);
  p.friction = 0.04;
  p.angular_friction = 1e-3;
  const auto hand = make_hand(p);
  hand->read(0.0);
  hand->write({{0.0399, 0.0, 0.0}, {0.0, 0.9e-3, 0.0}});
  for (int i = 1; i <= 1000; ++i) hand->read(i * kTick);
  EXPECT_EQ(hand->true_motion().pose.position, Vec3::Zero());
  EXPECT_EQ(vector_from_rotation(hand->true_motion().pose.orientation), Vec3::Zero());
  hand->write({{0.14, 0.0, 0.0}, Vec3::Zero()});
  for (int i = 1001; i <= 1100; ++i) hand->read(i * kTick);
  EXPECT_NEAR(hand->true_motion().twist.linear.x(), (0.14 - 0.04) / 0.1 * 0.1, 1e-9);
  // Let go: v^2 / 2a = 0.01 / 0.8 m more, then exact rest.
  const double at = hand->true_motion().pose.position.x();
  hand->write({});
  for (int i = 1101; i <= 1600; ++i) hand->read(i * kTick);
  EXPECT_EQ(hand->true_motion().twist.linear, Vec3::Zero());
  EXPECT_NEAR(hand->true_motion().pose.position.x() - at, 0.01 / 0.8, 1e-5);
}

TEST(Hand, LosesEnergyWithoutInput) {
  for (const double friction : {0.0, 0.04}) {
    HandParams p = resting();
    p.friction = friction;
    p.angular_friction = friction * 0.01;
    p.arm_damping = 0.5;
    p.arm_angular_damping = 1e-3;
    const auto hand = make_hand(p);
    hand->read(0.0);
    hand->write({{2.0, -1.0, 0.5}, {0.02, 0.05, -0.03}});
    for (int i = 1; i <= 300; ++i) hand->read(i * kTick);
    hand->write({});
    double energy = hand->stored_energy();
    const double first = energy;
    ASSERT_GT(first, 1e-4);
    for (int i = 301; i <= 3000; ++i) {
      hand->read(i * kTick);
      const double next = hand->stored_energy();
      EXPECT_LE(next, energy + 1e-9 * first) << i;
      energy = next;
    }
    EXPECT_LT(energy, 0.05 * first);
  }
}

TEST(Hand, EnergyOfTheUndampedArmStays) {
  HandParams p = bare_mass(0.2);
  p.arm_stiffness = 400.0;
  const auto hand = make_hand(p);
  hand->read(0.0);
  hand->write({{1.0, 0.0, 0.0}, Vec3::Zero()});
  for (int i = 1; i <= 50; ++i) hand->read(i * kTick);
  hand->write({});
  const double energy = hand->stored_energy();
  for (int i = 51; i <= 5000; ++i) hand->read(i * kTick);
  EXPECT_NEAR(hand->stored_energy(), energy, 1e-9 * energy);
}

TEST(Hand, EncodersRoundToTheirStep) {
  HandParams p;
  p.program.path = HandPath::circle;
  p.program.approach = Vec3(1.0, -2.0, 0.5);
  p.angular_tremor = 0.05;
  const auto hand = make_hand(p);
  bool has_moved = false;
  for (int i = 0; i <= 3000; ++i) {
    const DeviceState state = hand->read(i * kTick);
    const Pose& truth = hand->true_motion().pose;
    for (int k = 0; k < 3; ++k) {
      const double steps = state.motion.pose.position[k] / p.encoder;
      EXPECT_NEAR(steps, std::round(steps), 1e-9);
      EXPECT_LE(std::fabs(state.motion.pose.position[k] - truth.position[k]),
                0.5 * p.encoder * (1 + 1e-9));
    }
    const Vec3 off =
        vector_from_rotation(state.motion.pose.orientation * truth.orientation.conjugate());
    EXPECT_LE(off.norm(), p.angular_encoder);
    has_moved = has_moved || truth.position.norm() > 5e-3;
  }
  EXPECT_TRUE(has_moved);
}

std::vector<DeviceState> run_in_air(const HandParams& p, int ticks) {
  const auto hand = make_hand(p);
  std::vector<DeviceState> states;
  for (int i = 0; i < ticks; ++i) states.push_back(hand->read(i * kTick));
  return states;
}

bool same_bits(const DeviceState& a, const DeviceState& b) {
  return std::memcmp(&a.motion.pose.position, &b.motion.pose.position, sizeof(Vec3)) == 0 &&
         std::memcmp(&a.motion.pose.orientation, &b.motion.pose.orientation, sizeof(Quat)) == 0 &&
         std::memcmp(&a.motion.twist.linear, &b.motion.twist.linear, sizeof(Vec3)) == 0 &&
         std::memcmp(&a.motion.twist.angular, &b.motion.twist.angular, sizeof(Vec3)) == 0;
}

TEST(Hand, DelayIsExactInSamples) {
  HandParams p;
  p.program.path = HandPath::circle;
  const auto prompt = run_in_air(p, 1500);
  for (const int ticks : {1, 5, 40}) {
    p.delay = ticks * kTick;
    const auto late = run_in_air(p, 1500);
    for (int i = 700; i < 1500; ++i) {
      EXPECT_EQ(late[i].motion.pose.position, prompt[i - ticks].motion.pose.position) << i;
      EXPECT_EQ(late[i].time, i * kTick);
    }
    EXPECT_NE(late[1400].motion.pose.position, prompt[1400].motion.pose.position);
  }
}

TEST(Hand, JitterAgesSamplesWithinItsBoundAndNeverTurnsTimeBack) {
  HandParams p;
  p.program.path = HandPath::demo;  // approaches along -z
  p.encoder = 0.0;
  const auto prompt = run_in_air(p, 1000);
  p.delay = 2.0 * kTick;
  p.jitter = 3.0 * kTick;
  const auto late = run_in_air(p, 1000);
  int off_grid = 0;
  for (int i = 800; i < 1000; ++i) {
    const double z = late[i].motion.pose.position.z();
    EXPECT_LE(z,
              prompt[i - 5].motion.pose.position.z() + 4e-6);  // one sub-step of 62.5 us at 50 mm/s
    EXPECT_GE(z, prompt[i - 2].motion.pose.position.z());
    EXPECT_LE(z, late[i - 1].motion.pose.position.z());
    off_grid += z != prompt[i - 2].motion.pose.position.z() ? 1 : 0;
  }
  EXPECT_GT(off_grid, 100);
}

TEST(Hand, SlowSamplingRepeatsSamples) {
  HandParams p;
  p.encoder = 0.0;
  p.sampling = 250.0;
  const auto states = run_in_air(p, 1000);
  int changes = 0;
  for (int i = 800; i < 1000; ++i) {
    changes += states[i].motion.pose.position != states[i - 1].motion.pose.position ? 1 : 0;
  }
  EXPECT_EQ(changes, 50);
  // 50 mm/s toward the scene, seen at the true rate although most reads bring nothing new.
  EXPECT_NEAR(states[999].motion.twist.linear.z(), -0.05, 2e-3);
}

// As a server's wall clock is set while the handle moves, which then stops.
TEST(Hand, VelocityEstimateBeginsAnewWhereTimeGoesBack) {
  detail::VelocityEstimate estimate(1e-5, 1e-4, 0.015, 0.015);
  Pose pose;
  for (int i = 0; i <= 20; ++i) {
    pose.position.x() = 3e-4 * i;
    estimate.update(10.0 + 1e-3 * i, pose);
  }
  EXPECT_NEAR(estimate.update(10.02, pose).linear.x(), 0.3, 1e-2);
  EXPECT_EQ(estimate.update(9.02, pose).linear, Vec3::Zero());
  for (int i = 1; i <= 20; ++i)
    EXPECT_EQ(estimate.update(9.02 + 1e-3 * i, pose).linear, Vec3::Zero()) << i;
}

TEST(Hand, VelocityEstimateFollowsAndIsZeroAtRest) {
  HandParams p;
  const auto states = run_in_air(p, 1000);
  EXPECT_EQ(states[500].motion.twist.linear, Vec3::Zero());
  EXPECT_NEAR(states[999].motion.twist.linear.z(), -0.05, 4e-3);
}

TEST(Hand, SameSeedSameBitsOtherSeedOtherBits) {
  HandParams p;
  p.tremor = 2e-4;
  p.angular_tremor = 2e-3;
  p.jitter = 1e-3;
  const auto once = run_in_air(p, 1200);
  const auto again = run_in_air(p, 1200);
  p.seed = 2;
  const auto other = run_in_air(p, 1200);
  int different = 0;
  for (int i = 0; i < 1200; ++i) {
    EXPECT_TRUE(same_bits(once[i], again[i])) << i;
    different += same_bits(once[i], other[i]) ? 0 : 1;
  }
  EXPECT_GT(different, 1000);
}

TEST(Hand, TremorHasItsSizeAndBand) {
  HandParams p = resting();
  p.tremor = 1e-3;
  const auto hand = make_hand(p);
  double square = 0.0;
  int crossings = 0;
  double before = 0.0;
  const int ticks = 40000;
  for (int i = 0; i < ticks; ++i) {
    hand->read(i * kTick);
    const double x = hand->target_motion().pose.position.x();
    square += x * x;
    crossings += i > 0 && (x > 0.0) != (before > 0.0) ? 1 : 0;
    before = x;
  }
  EXPECT_NEAR(std::sqrt(square / ticks), p.tremor, 0.1 * p.tremor);
  const double frequency = 0.5 * crossings / (ticks * kTick);
  EXPECT_GT(frequency, 8.0);
  EXPECT_LT(frequency, 12.0);
}

TEST(Hand, ThreeDegreesOfFreedomNeitherSenseNorFeelRotation) {
  HandParams p = resting();
  p.senses_rotation = p.actuates_rotation = false;
  p.angular_tremor = 0.01;
  const auto hand = make_hand(p);
  EXPECT_FALSE(hand->limits().senses_rotation);
  EXPECT_FALSE(hand->limits().actuates_rotation);
  EXPECT_EQ(hand->limits().max_torque, 0.0);
  for (int i = 0; i < 1000; ++i) {
    const DeviceState state = hand->read(i * kTick);
    EXPECT_EQ(state.motion.pose.orientation.coeffs(), Quat::Identity().coeffs());
    EXPECT_EQ(state.motion.twist.angular, Vec3::Zero());
    hand->write({{0.3, 0.0, 0.0}, {0.1, 0.1, 0.1}});
  }
  EXPECT_EQ(hand->applied_wrench().torque, Vec3::Zero());
  EXPECT_NEAR(hand->true_motion().pose.position.x(), 0.3 / p.arm_stiffness, 0.15 * 0.3 / 400.0);
}

TEST(Hand, ActuatorsSaturateByNormAndRefuseNonsense) {
  HandParams p = resting();
  p.max_force = 2.0;
  p.max_torque = 0.1;
  const auto hand = make_hand(p);
  hand->write({{30.0, 40.0, 0.0}, {0.0, 0.0, -5.0}});
  EXPECT_LT((hand->applied_wrench().force - Vec3(1.2, 1.6, 0.0)).norm(), 1e-14);
  EXPECT_LT((hand->applied_wrench().torque - Vec3(0.0, 0.0, -0.1)).norm(), 1e-15);
  hand->write({{std::nan(""), 0.0, 0.0}, {0.0, INFINITY, 0.0}});
  EXPECT_EQ(hand->applied_wrench().force, Vec3::Zero());
  EXPECT_EQ(hand->applied_wrench().torque, Vec3::Zero());
}

TEST(Hand, StallsAndClocksThatStandStillAreSurvived) {
  HandParams p = resting();
  p.friction = 0.0;
  const auto hand = make_hand(p);
  hand->read(5.0);  // time starts at the first read
  hand->write({{0.4, 0.0, 0.0}, Vec3::Zero()});
  hand->read(25.0);
  EXPECT_NEAR(hand->true_motion().pose.position.x(), 0.4 / p.arm_stiffness, 1e-9);
  const Vec3 at = hand->true_motion().pose.position;
  hand->read(25.0);
  hand->read(24.0);
  hand->read(std::nan(""));
  EXPECT_EQ(hand->true_motion().pose.position, at);
}

TEST(Hand, BadParametersAreNamed) {
  HandParams p;
  p.delay = 1.0;
  EXPECT_EQ(what_is_wrong(p), "delay = 1, expected from 0 to 0.1 s");
  EXPECT_THROW(make_hand(p), std::invalid_argument);
  p = {};
  p.arm_stiffness = std::nan("");
  EXPECT_NE(what_is_wrong(p).find("arm_stiffness"), std::string::npos);
  p = {};
  p.mass = p.arm_mass = 0.0;
  EXPECT_NE(what_is_wrong(p).find("mass + arm_mass"), std::string::npos);
  p = {};
  p.program.slide = 3.0 * p.program.approach;
  EXPECT_NE(what_is_wrong(p).find("not parallel"), std::string::npos);
  EXPECT_EQ(what_is_wrong({}), "");
}

}  // namespace
}  // namespace thigma
