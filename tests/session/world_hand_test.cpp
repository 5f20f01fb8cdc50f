// A hand of a world on both sides: what the world gets of it where it is late.

#include "thigma/session/world_hand.h"

#include <memory>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using namespace test;

constexpr double kStep = 1e-3;

/// A hand at a speed, with the world's side of it.
struct Hand {
  BadDevice device;
  WorldHand config;
  WorldHandLoop loop;
  HandRelay relay;
  std::uint64_t ticks = 0;

  explicit Hand(double speed, bool is_free = false)
      : device(speed, BadDevice::Trouble::none, 0.0),
        config([&] {
          WorldHand made;
          made.is_free = is_free;
          return made;
        }()),
        loop(config, device, 1.0 / kStep),
        relay(loop, kStep) {}
  /// The world's next sample, after so many haptic steps.
  DeviceState read(int steps) {
    for (int i = 0; i < steps; ++i)
      step_world_hand(loop, {kStep * static_cast<double>(ticks++), kStep});
    return relay.read(0.0);
  }
  /// The same after a single one that came so many ticks late.
  DeviceState read_late(std::uint64_t skipped) {
    ticks += skipped;
    return read(1);
  }
};

TEST(WorldHand, WhereTheWorldKeepsUpSamplesAreThoseOfTheDeviceBitForBit) {
  Hand hand(1.4);  // as fast as may be
  for (int i = 0; i < 50; ++i) {
    const DeviceState sample = hand.read(1), own = hand.device.read(kStep * i);
    EXPECT_EQ(sample.motion.pose.position, own.motion.pose.position);
    EXPECT_EQ(sample.motion.twist.linear, own.motion.twist.linear);
    EXPECT_EQ(sample.time, own.time);
  }
}

TEST(WorldHand, BeforeItsFirstStepThereIsNoSample) {
  Hand hand(0.1);
  EXPECT_EQ(hand.read(0).status, DeviceStatus::not_ready);
}

TEST(WorldHand, ALateWorldComesAfterNoFasterThanItMayAndComesThere) {
  Hand hand(0.05);
  hand.relay.border.is_held = true;
  hand.relay.border.stiffness = 1.0;  // so soft that energy is no bound
  Vec3 last = hand.read(1).motion.pose.position;
  for (int i = 0; i < 20; ++i) {
    const DeviceState sample = hand.read(i == 3 ? 138 : 1);
    const double way = (sample.motion.pose.position - last).norm();
    EXPECT_LE(way, kCatchUp * kStep * (1.0 + 1e-9)) << i;
    if (i >= 3 && i < 8) {
      EXPECT_NEAR(way, kCatchUp * kStep, 1e-9) << i;
      EXPECT_NEAR(sample.motion.twist.linear.x(), kCatchUp, 1e-6) << i;
    }
    last = sample.motion.pose.position;
  }
  EXPECT_EQ(last, hand.loop.notes.value().device.motion.pose.position);
}

TEST(WorldHand, TicksThatTheHandItselfMissedAreNoJumpForTheWorld) {
  Hand hand(0.45);
  hand.relay.border.is_held = true;
  hand.relay.border.stiffness = 1.0;
  Vec3 last = hand.read(1).motion.pose.position;
  last = hand.read(1).motion.pose.position;
  const double way = (hand.read_late(40).motion.pose.position - last).norm();
  EXPECT_NEAR(way, kCatchUp * kStep, 1e-9);
}

TEST(WorldHand, ALateWorldComesAfterNoFasterThanTheDeviceMayGo) {
  Hand hand(0.05);
  hand.loop.params.safety.max_speed = 0.5;
  hand.relay.border.is_held = true;
  hand.relay.border.stiffness = 1.0;
  hand.read(1);
  const DeviceState sample = hand.read(138);
  EXPECT_GT(sample.motion.twist.linear.norm(), 0.4);
  EXPECT_LT(sample.motion.twist.linear.norm(), 0.5);
}

TEST(WorldHand, ALateWorldGetsNoMoreWorkThanTheHandHasDone) {
  Hand hand(0.05);
  hand.read(1);
  HandBorder& border = hand.relay.border;
  border.is_held = true;
  border.stiffness = 1.7e4;
  Vec3 last = hand.read(1).motion.pose.position;
  // The hand has felt nothing: a reaction may grow by what the credit lasts.
  const double way = (hand.read(40).motion.pose.position - last).norm();
  EXPECT_NEAR(border.stiffness * way * way, kBorderCredit, 1e-6 * kBorderCredit);
  border.energy = kBorderCredit;
  last = hand.read(1).motion.pose.position;
  EXPECT_EQ((hand.read(40).motion.pose.position - last).norm(), 0.0);
  // What pulls it on its way does work on it.
  border.springs.force.x() = 1.0;
  const double pulled = (hand.read(1).motion.pose.position - last).norm();
  EXPECT_NEAR(border.stiffness * pulled, 1.0, 1e-9);
}

}  // namespace
}  // namespace thigma
