#include "thigma/dynamics/gains.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/dynamics/sampled_loop.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

/// A ball of 10 g on a device whose published stiffness is all that is known.
GainTask plain_task() {
  GainTask task;
  task.body = make_body(0.010, 1.6e-6 * Mat3::Identity());
  task.linear = {.max_effort = 8.5, .max_stiffness = 800.0};
  task.angular = {.max_effort = 0.188, .max_stiffness = 0.3};
  return task;
}

double limit_of(const GainChoice& choice, GainLimit which) {
  return choice.limits[static_cast<std::size_t>(which)];
}

Coupling coupling_of(const GainProposal& p, double factor) {
  Coupling c;
  c.linear_stiffness = factor * p.linear.stiffness;
  c.linear_damping = std::sqrt(factor) * p.linear.damping;
  c.angular_stiffness = factor * p.angular.stiffness;
  c.angular_damping = std::sqrt(factor) * p.angular.damping;
  return c;
}

std::vector<std::string> named(const std::vector<GainWarning>& warnings) {
  std::vector<std::string> names;
  for (const GainWarning& w : warnings) names.push_back(w.gain);
  return names;
}

TEST(Gains, TheDeviceBindsAndEverySpringIsCriticallyDamped) {
  const GainTask task = plain_task();
  const GainProposal p = propose_gains(task);
  EXPECT_EQ(p.linear.binds, GainLimit::device);
  EXPECT_DOUBLE_EQ(p.linear.limit, 800.0);
  EXPECT_DOUBLE_EQ(p.linear.stiffness, kGainMargin * 800.0);
  EXPECT_DOUBLE_EQ(p.linear.damping, 2.0 * std::sqrt(p.linear.stiffness * 0.010));
  EXPECT_EQ(p.angular.binds, GainLimit::device);
  EXPECT_DOUBLE_EQ(p.angular.damping, 2.0 * std::sqrt(p.angular.stiffness * 1.6e-6));
  EXPECT_EQ(p.contact.binds, GainLimit::frames);
  EXPECT_DOUBLE_EQ(p.contact.limit, 0.010 * 1e6);
  EXPECT_DOUBLE_EQ(p.max_force, 8.5);
  EXPECT_DOUBLE_EQ(p.max_torque, 0.188);
  // Without mass, friction and encoder of the handle, neither the loop nor friction is known to
  // limit.
  EXPECT_TRUE(std::isinf(limit_of(p.linear, GainLimit::loop)));
  EXPECT_TRUE(std::isinf(limit_of(p.linear, GainLimit::friction)));
}

TEST(Gains, PublishedStiffnessFallsWithDelayAndLowerRatesAndNeverRises) {
  GainTask task = plain_task();
  const auto device_limit = [&] { return limit_of(propose_gains(task).linear, GainLimit::device); };
  task.delay = 1e-3;
  EXPECT_NEAR(device_limit(), 800.0 / 3.0, 1e-9);
  task.delay = 0.0;
  task.rate = 500.0;
  EXPECT_NEAR(device_limit(), 400.0, 1e-9);
  task.rate = 10000.0;
  EXPECT_NEAR(device_limit(), 800.0, 1e-9);
}

TEST(Gains, FrictionAndEncoderLimitByTheStepTheySwallow) {
  GainTask task = plain_task();
  task.linear.max_stiffness = 1e5;
  task.linear.friction = 0.04;
  task.linear.encoder = 3e-5;
  const GainProposal p = propose_gains(task);
  EXPECT_EQ(p.linear.binds, GainLimit::friction);
  EXPECT_NEAR(p.linear.limit, 2.0 * 0.04 / 3e-5, 1e-9);
}

TEST(Gains, TheLoopLimitIsWhereTheLoopBeginsToSwing) {
  GainTask task = plain_task();
  task.linear.max_stiffness = 0.0;
  task.linear.mass = 0.075;
  task.linear.damping = 0.005;
  task.delay = 0.003;
  const GainProposal p = propose_gains(task);
  ASSERT_EQ(p.linear.binds, GainLimit::loop);
  // The worst arm is one of those of docs/sources.md, E3; beyond the limit at least one swings, in
  // the air or pressing.
  const auto worst = [&](double stiffness) {
    double growth = 0.0;
    for (const auto& arm : {std::array{100.0, 1.0}, {500.0, 5.0}, {1500.0, 15.0}}) {
      for (const double contact : {0.0, 6000.0}) {
        growth =
            std::max(growth, loop_growth({.delay = 0.003,
                                          .handle_mass = 0.075,
                                          .handle_damping = 0.005,
                                          .arm_stiffness = arm[0],
                                          .arm_damping = arm[1],
                                          .body_mass = 0.010,
                                          .coupling_stiffness = stiffness,
                                          .coupling_damping = 2.0 * std::sqrt(stiffness * 0.010),
                                          .contact_stiffness = contact,
                                          .contact_damping = 2.0 * std::sqrt(contact * 0.010)}));
      }
    }
    return growth;
  };
  EXPECT_LT(worst(0.6 * p.linear.limit), 1.0);
  EXPECT_GT(worst(1.1 * p.linear.limit), 1.0);
  // More delay, less stiffness.
  double before = p.linear.limit;
  for (const double delay : {0.005, 0.010, 0.015}) {
    task.delay = delay;
    const double now = propose_gains(task).linear.limit;
    EXPECT_LT(now, before) << delay;
    before = now;
  }
}

TEST(Gains, UnderConstraintsTheCouplingAloneIsLimitedByTheLoopWithTheObjectHeldStill) {
  GainTask task = plain_task();
  task.linear = {.max_effort = 8.5, .mass = 0.075, .damping = 0.005};
  task.delay = 0.003;
  task.is_constrained = true;
  const GainProposal p = propose_gains(task);
  EXPECT_EQ(p.contact.stiffness, 0.0);
  EXPECT_TRUE(std::isinf(p.contact.limit));
  ASSERT_EQ(p.linear.binds, GainLimit::loop);
  const auto worst = [&](double stiffness) {
    double growth = 0.0;
    for (const double body : {0.010, std::numeric_limits<double>::infinity()}) {
      for (const auto& arm : {std::array{0.0, 100.0, 1.0},
                              {0.0, 500.0, 5.0},
                              {0.0, 1500.0, 15.0},
                              {0.15, 400.0, 8.0}})
        growth =
            std::max(growth, loop_growth({.delay = 0.003,
                                          .handle_mass = 0.075,
                                          .handle_damping = 0.005,
                                          .arm_mass = arm[0],
                                          .arm_stiffness = arm[1],
                                          .arm_damping = arm[2],
                                          .body_mass = body,
                                          .coupling_stiffness = stiffness,
                                          .coupling_damping = 2.0 * std::sqrt(stiffness * 0.010)}));
    }
    return growth;
  };
  EXPECT_LT(worst(0.95 * p.linear.limit), 1.0);
  EXPECT_GT(worst(1.05 * p.linear.limit), 1.0);
  // More delay and lower rates, less stiffness.
  double before = p.linear.limit;
  for (const double delay : {0.005, 0.010, 0.015}) {
    task.delay = delay;
    const double now = propose_gains(task).linear.limit;
    EXPECT_LT(now, before) << delay;
    before = now;
  }
}

TEST(Gains, UnderConstraintsNothingIsSaidOfContactGainsThatAreNotThere) {
  GainTask task = plain_task();
  const GainProposal penalty = propose_gains(task);
  const double soft = 1e9, undamped = 0.0;  // no contact law could have these
  EXPECT_FALSE(check_gains(task, penalty, coupling_of(penalty, 1.0), soft, undamped).empty());
  task.is_constrained = true;
  const GainProposal p = propose_gains(task);
  EXPECT_TRUE(check_gains(task, p, coupling_of(p, 1.0), soft, undamped).empty());
  EXPECT_FALSE(check_gains(task, p, coupling_of(p, 2.0), soft, undamped).empty());
}

TEST(Gains, ScalesMoveBetweenDeviceAndVirtualStiffness) {
  GainTask task = plain_task();
  const GainProposal plain = propose_gains(task);
  // The same stiffness felt: f = 1 / s. Torques go with s^2.
  task.motion_scale = 0.4;
  task.force_scale = 2.5;
  GainProposal scaled = propose_gains(task);
  EXPECT_NEAR(scaled.linear.stiffness, plain.linear.stiffness, 1e-9);
  EXPECT_NEAR(limit_of(scaled.angular, GainLimit::device), 0.3 * 0.16, 1e-12);
  EXPECT_NEAR(scaled.max_force, 8.5 / 2.5, 1e-12);
  EXPECT_NEAR(scaled.max_torque, 0.188 * 0.16, 1e-12);
  // Twice the force felt for the same motion: half the stiffness in the scene.
  task.motion_scale = 1.0;
  task.force_scale = 2.0;
  scaled = propose_gains(task);
  EXPECT_NEAR(scaled.linear.stiffness, 0.5 * plain.linear.stiffness, 1e-9);
  // The object's own limit is none of the device's.
  EXPECT_NEAR(scaled.contact.limit, plain.contact.limit, 1e-9);
}

TEST(Gains, ADeviceWithoutRotationLeavesTheAngularSpringToTheObject) {
  GainTask task = plain_task();
  task.has_device_rotation = false;
  const GainProposal p = propose_gains(task);
  EXPECT_EQ(p.angular.binds, GainLimit::frames);
  EXPECT_NEAR(p.angular.limit, 1.6e-6 * 1e6, 1e-12);
  EXPECT_EQ(p.max_torque, 0.0);
}

TEST(Gains, ProposalsPassTheirOwnCheckAndDoubledOnesAreFlagged) {
  Random random(5);
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, random.uniform());
  };
  for (int i = 0; i < 12; ++i) {
    GainTask task;
    const double mass = between(1e-3, 0.5), radius = between(0.005, 0.1);
    const Vec3 moments = mass * radius * radius * Vec3(0.4, 0.3, 0.15);
    task.body = make_body(mass, moments.asDiagonal());
    task.rate = between(500.0, 10000.0);
    task.delay = i % 3 == 0 ? between(1e-4, 0.015) : 0.0;
    task.motion_scale = between(0.2, 5.0);
    task.force_scale = 1.0 / task.motion_scale;
    task.linear = {between(2.0, 20.0),  between(300.0, 8000.0), between(0.03, 2.0),
                   between(0.003, 2.0), between(0.01, 0.5),     between(5e-6, 5e-5)};
    task.angular = {between(0.05, 0.5),  between(0.1, 2.0),   between(1e-5, 1e-3),
                    between(1e-6, 1e-3), between(1e-4, 1e-2), between(1e-5, 1e-4)};
    task.has_device_rotation = i % 2 == 0;
    const GainProposal p = propose_gains(task);
    for (const GainChoice* c : {&p.linear, &p.angular, &p.contact}) {
      for (const double limit : c->limits)
        EXPECT_LE(c->stiffness, kGainMargin * limit * (1 + 1e-9));
      EXPECT_EQ(c->limit, limit_of(*c, c->binds));
    }
    EXPECT_TRUE(
        check_gains(task, p, coupling_of(p, 1.0), p.contact.stiffness, p.contact.damping).empty());
    const auto doubled = named(check_gains(task, p, coupling_of(p, 2.0), 2.0 * p.contact.stiffness,
                                           std::sqrt(2.0) * p.contact.damping));
    EXPECT_EQ(doubled,
              (std::vector<std::string>{"linear_stiffness", "angular_stiffness", "stiffness"}));
  }
}

TEST(Gains, DampingAndSaturationOutsideAreNamed) {
  const GainTask task = plain_task();
  const GainProposal p = propose_gains(task);
  const auto warned = [&](const Coupling& c, double contact_damping) {
    return named(check_gains(task, p, c, p.contact.stiffness, contact_damping));
  };
  Coupling c = coupling_of(p, 1.0);
  c.linear_damping *= 0.2;
  c.angular_damping *= 2.0;
  EXPECT_EQ(warned(c, 0.1 * p.contact.damping),
            (std::vector<std::string>{"linear_damping", "angular_damping", "damping"}));
  c = coupling_of(p, 1.0);
  c.linear_saturation = make_saturation(c.linear_stiffness, 0.001, 9.0);
  c.angular_saturation = make_saturation(c.angular_stiffness, 0.001, 0.18);
  EXPECT_EQ(warned(c, p.contact.damping), (std::vector<std::string>{"max_force"}));
}

TEST(Gains, AHeavyDampingOnALateLoopIsFlaggedThoughTheStiffnessIsWithin) {
  GainTask task = plain_task();
  task.linear.mass = 0.075;
  task.delay = 0.005;
  const GainProposal p = propose_gains(task);
  Coupling c = coupling_of(p, 1.0);
  c.linear_stiffness = 0.9 * p.linear.limit;
  c.linear_damping = 1.7 * 2.0 * std::sqrt(c.linear_stiffness * task.body.mass);
  const auto all = check_gains(task, p, c, p.contact.stiffness, p.contact.damping);
  c.linear_damping = 40.0 * c.linear_damping;
  const auto heavy = check_gains(task, p, c, p.contact.stiffness, p.contact.damping);
  EXPECT_GT(heavy.size(), all.size());
}

TEST(Gains, RefusesWhatIsNotPositive) {
  GainTask task = plain_task();
  task.rate = 0.0;
  EXPECT_THROW(propose_gains(task), InputError);
  task = plain_task();
  task.delay = -1e-3;
  EXPECT_THROW(propose_gains(task), InputError);
  task = plain_task();
  task.motion_scale = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(propose_gains(task), InputError);
}

}  // namespace
}  // namespace thigma
