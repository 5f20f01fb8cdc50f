#include "viewer/server/tuning.h"

#include <bit>
#include <cmath>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/contact/error_metric.h"

namespace thigma::live {
namespace {

SessionConfig config() {
  SessionConfig c = test::plane_session();
  c.haptic.coupling.linear_saturation = make_saturation(300.0, 0.01, 4.0);
  return c;
}

double damping_ratio(double b, double k, double m) { return b / (2.0 * std::sqrt(k * m)); }

TEST(Tuning, UntouchedParametersChangeNothingToTheLastBit) {
  const SessionConfig before = config();
  SessionConfig after = before;
  Tuner(before).apply_to(after);
  const auto same = [](double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  };
  EXPECT_TRUE(same(after.haptic.body.mass, before.haptic.body.mass));
  EXPECT_EQ(after.haptic.body.inverse_inertia, before.haptic.body.inverse_inertia);
  const Coupling &a = after.haptic.coupling, &b = before.haptic.coupling;
  EXPECT_TRUE(same(a.linear_stiffness, b.linear_stiffness));
  EXPECT_TRUE(same(a.linear_damping, b.linear_damping));
  EXPECT_TRUE(same(a.angular_damping, b.angular_damping));
  EXPECT_TRUE(same(a.linear_saturation->linear_range, b.linear_saturation->linear_range));
  EXPECT_TRUE(same(a.linear_saturation->full_range, b.linear_saturation->full_range));
  EXPECT_TRUE(same(after.contact.response.damping, before.contact.response.damping));
}

TEST(Tuning, DampingRatiosStay) {
  const SessionConfig c = config();
  Tuner tuner(c);
  EXPECT_EQ(tuner.set("coupling_stiffness", 600.0), "");
  EXPECT_EQ(tuner.set("contact_stiffness", 900.0), "");
  EXPECT_EQ(tuner.set("mass", 0.02), "");
  const HapticTuning h = tuner.haptic();
  EXPECT_EQ(h.coupling.linear_stiffness, 600.0);
  EXPECT_NEAR(damping_ratio(h.coupling.linear_damping, 600.0, 0.02),
              damping_ratio(c.haptic.coupling.linear_damping, 300.0, 0.01), 1e-12);
  EXPECT_EQ(h.coupling.linear_saturation->stiffness, 600.0);
  EXPECT_EQ(h.coupling.linear_saturation->max_force, 4.0);
  EXPECT_TRUE(is_monotone(*h.coupling.linear_saturation));
  EXPECT_EQ(h.body.mass, 0.02);
  EXPECT_NEAR(h.body.inertia(0, 0), 2.0 * c.haptic.body.inertia(0, 0), 1e-20);
  const ContactTuning contact = tuner.contact();
  EXPECT_EQ(contact.response.stiffness, 900.0);
  EXPECT_NEAR(damping_ratio(contact.response.damping, 900.0, 0.02),
              damping_ratio(c.contact.response.damping, 2000.0, 0.01), 1e-12);
}

TEST(Tuning, UnderConstraintsTheCouplingIsSetAndThereIsNoContactStiffness) {
  SessionConfig c = config();
  c.haptic.response = ResponseKind::constrained;
  Tuner tuner(c);
  EXPECT_EQ(tuner.find("contact_stiffness"), nullptr);
  EXPECT_NE(tuner.set("contact_stiffness", 900.0), "");
  EXPECT_EQ(tuner.set("coupling_stiffness", 600.0), "");
  EXPECT_EQ(tuner.set("mass", 0.02), "");
  EXPECT_EQ(tuner.haptic().coupling.linear_stiffness, 600.0);
  EXPECT_EQ(tuner.contact().response.damping, c.contact.response.damping);  // as it was
  // 600 N/m on 0.4 g would swing faster than the frames; the contact law's 2000 N/m bind nothing.
  EXPECT_EQ(tuner.set("mass", 0.0011), "");
}

TEST(Tuning, UnsafeValuesAreRefusedWithWhatWouldBeAllowed) {
  Tuner tuner(config());
  // 2000 N/m on less than 2 g swings faster than 1 kHz frames follow.
  const std::string light = tuner.set("mass", 0.001);
  EXPECT_NE(light.find("at least 0.002 kg"), std::string::npos) << light;
  EXPECT_EQ(tuner.find("mass")->value, 0.01);
  // The device holds 1000 N/m.
  const std::string stiff = tuner.set("coupling_stiffness", 1100.0);
  EXPECT_NE(stiff.find("at most 1000 N/m"), std::string::npos) << stiff;
  EXPECT_EQ(tuner.set("coupling_stiffness", 1000.0), "");
  EXPECT_EQ(tuner.set("mass", 0.002), "");
  const std::string both = tuner.set("contact_stiffness", 4000.0);
  EXPECT_NE(both.find("at most 2000 N/m"), std::string::npos) << both;
  EXPECT_NE(tuner.set("mass", -1.0), "");
  EXPECT_NE(tuner.set("mass", std::nan("")), "");
  EXPECT_NE(tuner.set("mass", 1e30), "");
  EXPECT_NE(tuner.set("no_such", 1.0), "");
}

TEST(Tuning, RecordingsLockWhatTheirReplayDependsOn) {
  Tuner tuner(config());
  tuner.lock("recording", "");
  EXPECT_EQ(tuner.set("mass", 0.02), "recording");
  EXPECT_EQ(tuner.set("coupling_stiffness", 310.0), "recording");
  EXPECT_EQ(tuner.set("contact_stiffness", 1000.0), "");  // recorded as contact models
  tuner.lock("", "lockstep");
  EXPECT_EQ(tuner.set("contact_stiffness", 2000.0), "lockstep");
  tuner.lock("", "");
  EXPECT_EQ(tuner.set("mass", 0.02), "");
}

TEST(Tuning, ThresholdIsThereOnlyWithLevelsOfDetail) {
  SessionConfig c = config();
  EXPECT_EQ(Tuner(c).find("threshold"), nullptr);
  c.contact.resolution.is_exact = false;
  Tuner tuner(c);
  ASSERT_NE(tuner.find("threshold"), nullptr);
  EXPECT_EQ(tuner.set("threshold", 0.05), "");
  tuner.apply_to(c);
  EXPECT_EQ(c.contact.resolution.metric.haptic, 0.05);
}

TEST(Tuning, MetricsCapAndBudgetReachTheQueryAndMayBeOff) {
  SessionConfig c = config();
  c.contact.resolution = {.is_exact = false};
  c.contact.resolution.budget_cpu = 1.0 / 3.0 * 1e-3;
  Tuner tuner(c);
  const Resolution untouched = tuner.contact().resolution;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(untouched.budget_cpu),
            std::bit_cast<std::uint64_t>(c.contact.resolution.budget_cpu));
  EXPECT_EQ(untouched.deviation_cap, kNoCap);
  EXPECT_EQ(untouched.metric.view.pixels, 0.0);

  EXPECT_EQ(tuner.set("threshold", 0.0), "");
  EXPECT_EQ(tuner.set("velocity_metric", 0.02), "");
  EXPECT_EQ(tuner.set("view_metric", 2.0), "");
  EXPECT_EQ(tuner.set("deviation_cap", 0.02), "");
  EXPECT_EQ(tuner.contact().resolution.deviation_cap, 0.02);
  EXPECT_EQ(tuner.set("deviation_cap", 0.0), "");
  EXPECT_EQ(tuner.set("budget_us", 200.0), "");
  const Resolution r = tuner.contact().resolution;
  EXPECT_EQ(r.metric.haptic, 0.0);
  EXPECT_EQ(r.metric.velocity, 0.02);
  EXPECT_GT(view_threshold(r.metric.view), 0.0);
  EXPECT_EQ(r.deviation_cap, kNoCap);
  EXPECT_DOUBLE_EQ(r.budget_cpu, 200e-6);
  EXPECT_NE(tuner.set("budget_us", 1.0), "");  // neither off nor within
  EXPECT_NE(tuner.set("budget_us", -1.0), "");
  EXPECT_EQ(tuner.set("budget_us", 0.0), "");
  EXPECT_EQ(tuner.contact().resolution.budget_cpu, 0.0);
  EXPECT_NE(tuner.set("mass", 0.0), "");  // is never off
}

TEST(Tuning, FrictionIsSetWhereItIsLargestAndTheOthersKeepTheirShare) {
  SessionConfig c = config();
  c.contact.friction = {{0.2, 0.3}, {0.4, 0.6}};
  Tuner tuner(c);
  EXPECT_EQ(tuner.find("friction")->value, 0.4);
  EXPECT_FALSE(tuner.contact().most_friction.has_value());
  EXPECT_EQ(friction_on(c.contact, 1), (Friction{0.4, 0.6}));
  EXPECT_EQ(tuner.set("friction", 0.8), "");
  tuner.apply_to(c);
  EXPECT_NEAR(friction_on(c.contact, 0).kinetic, 0.4, 1e-15);
  EXPECT_NEAR(friction_on(c.contact, 1).at_rest, 1.2, 1e-15);
  EXPECT_EQ(Tuner(c).find("friction")->value, 0.8);  // begun again
  EXPECT_EQ(tuner.set("friction", 0.0), "");         // off
  tuner.apply_to(c);
  EXPECT_EQ(friction_on(c.contact, 1), Friction{});
  EXPECT_NE(tuner.set("friction", -0.1), "");
  EXPECT_NE(tuner.set("friction", std::nan("")), "");
  EXPECT_NE(tuner.set("friction", 50.0), "");

  SessionConfig plain = config();  // none anywhere: all get the same
  Tuner first(plain);
  EXPECT_EQ(first.find("friction")->value, 0.0);
  EXPECT_EQ(first.set("friction", 0.5), "");
  first.apply_to(plain);
  EXPECT_EQ(friction_on(plain.contact, 0), (Friction{0.5, 0.5}));
}

TEST(Tuning, WhatIsOutsideTheLimitsOfTheDeviceGetsAWarning) {
  Tuner tuner(config());
  EXPECT_EQ(tuner.set("coupling_stiffness", 600.0), "");
  EXPECT_EQ(tuner.find("coupling_stiffness")->warning, "");  // nothing to judge by
  GainTask task;
  task.linear.max_stiffness = 500.0;  // as published: 1 kHz, no delay
  tuner.judge_for(task);
  EXPECT_NE(tuner.find("coupling_stiffness")->warning.find("500"), std::string::npos);
  EXPECT_EQ(tuner.find("mass")->warning, "");
  EXPECT_EQ(tuner.set("coupling_stiffness", 400.0), "");
  EXPECT_EQ(tuner.find("coupling_stiffness")->warning, "");
  tuner.judge_for(std::nullopt);
  EXPECT_EQ(tuner.set("coupling_stiffness", 600.0), "");
  EXPECT_EQ(tuner.find("coupling_stiffness")->warning, "");
}

}  // namespace
}  // namespace thigma::live
