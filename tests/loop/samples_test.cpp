#include "thigma/loop/samples.h"

#include <bit>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace thigma {
namespace {

void flip_last_bit(double& x) { x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1u); }

TEST(StateHash, EveryBitOfEveryNumberCounts) {
  BodyState body;
  body.position = {1.0, 2.0, 3.0};
  Wrench command{Vec3(0.1, 0.2, 0.3), Vec3(4.0, 5.0, 6.0)};
  std::set<std::uint64_t> seen;
  const auto add = [&] {
    StateHash hash;
    add_frame(hash, body, command);
    EXPECT_TRUE(seen.insert(hash.value).second);
  };
  add();
  double* const numbers[] = {
      &body.position.x(),         &body.position.y(),         &body.position.z(),
      &body.orientation.x(),      &body.orientation.y(),      &body.orientation.z(),
      &body.orientation.w(),      &body.linear_momentum.x(),  &body.linear_momentum.y(),
      &body.linear_momentum.z(),  &body.angular_momentum.x(), &body.angular_momentum.y(),
      &body.angular_momentum.z(), &command.force.x(),         &command.force.y(),
      &command.force.z(),         &command.torque.x(),        &command.torque.y(),
      &command.torque.z()};
  for (double* number : numbers) {
    flip_last_bit(*number);
    add();
    flip_last_bit(*number);
  }
  EXPECT_EQ(seen.size(), 20u);
}

TEST(StateHash, OrderOfFramesCounts) {
  BodyState a, b;
  b.position.x() = 1.0;
  StateHash ab, ba;
  add_frame(ab, a, {});
  add_frame(ab, b, {});
  add_frame(ba, b, {});
  add_frame(ba, a, {});
  EXPECT_NE(ab.value, ba.value);
}

TEST(InputDigest, EveryNumberCounts) {
  const HapticSample base;
  const std::uint64_t digest = input_digest(base);
  HapticSample s = base;
  const auto differs = [&](auto change) {
    s = base;
    change();
    return input_digest(s) != digest;
  };
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(differs([&] { flip_last_bit(s.device.motion.pose.position[i]); }));
    EXPECT_TRUE(differs([&] { flip_last_bit(s.device.motion.twist.linear[i]); }));
    EXPECT_TRUE(differs([&] { flip_last_bit(s.device.motion.twist.angular[i]); }));
  }
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(differs([&] { flip_last_bit(s.device.motion.pose.orientation.coeffs()[i]); }));
  }
  EXPECT_TRUE(differs([&] { flip_last_bit(s.time); }));
  EXPECT_TRUE(differs([&] { flip_last_bit(s.elapsed); }));
  EXPECT_TRUE(differs([&] { flip_last_bit(s.device.time); }));
  EXPECT_TRUE(differs([&] { s.device.buttons ^= 1u; }));
  EXPECT_TRUE(differs([&] { s.device.weight = 0.5; }));
  EXPECT_TRUE(differs([&] { s.model_sequence ^= 1u; }));
  EXPECT_TRUE(differs([&] { s.external_fault = Fault::watchdog; }));
  EXPECT_FALSE(differs([&] { s.step_cpu = 1.0f; }));
}

TEST(InputDigest, WhatIsNotFiniteIsOneValue) {
  HapticSample a, b;
  a.device.motion.pose.position.x() = std::numeric_limits<double>::quiet_NaN();
  b.device.motion.pose.position.x() = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(input_digest(a), input_digest(b));
  EXPECT_NE(input_digest(a), input_digest(HapticSample{}));
}

TEST(InputDigest, SeesWhatAStepRead) {
  HapticSample sample;
  const std::uint64_t before = input_digest(sample);
  sample.body.position.x() = 1.0;  // came out, not in
  EXPECT_EQ(input_digest(sample), before);
  HapticSample other = sample;
  other.device.buttons = 1;
  EXPECT_NE(input_digest(other), before);
  other = sample;
  flip_last_bit(other.device.motion.twist.linear.z());
  EXPECT_NE(input_digest(other), before);
  other = sample;
  other.model_sequence = 1;
  EXPECT_NE(input_digest(other), before);
  other = sample;
  other.external_fault = Fault::watchdog;
  EXPECT_NE(input_digest(other), before);
}

TEST(ModelDigest, SeesEveryTerm) {
  LinearContactModel model;
  const std::uint64_t empty = model_digest(model);
  model.planes.push_back(PlaneTerm{});
  const std::uint64_t one = model_digest(model);
  EXPECT_NE(one, empty);
  flip_last_bit(model.planes[0].tolerance);
  EXPECT_NE(model_digest(model), one);
  const std::uint64_t plain = model_digest(model);
  model.planes[0].friction.at_rest = 0.5;
  const std::uint64_t rough = model_digest(model);
  EXPECT_NE(rough, plain);
  model.planes[0].friction.kinetic = 0.5;
  EXPECT_NE(model_digest(model), rough);
  model.depths.push_back(DepthTerm{});
  const std::uint64_t deep = model_digest(model);
  EXPECT_NE(deep, one);
  flip_last_bit(model.depths[0].tolerance);
  EXPECT_NE(model_digest(model), deep);
}

}  // namespace
}  // namespace thigma
