#include "thigma/session/world_session.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using namespace test;

/// A device with motors.
class PersonsDevice final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "motors"; }
  DeviceState read(double) THIGMA_RT override { return {}; }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  DeviceLimits limits_;
};

TEST(WorldSession, PushesBlocksTheSameWayTwice) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  WorldSummary runs[2];
  double way = 0.0;
  for (WorldSummary& run : runs) {
    const auto device = push_device();
    run = run_one(config, device.get(),
                  [&](const WorldFrame& frame) { way = frame.bodies[3].position.x() - 0.041; });
  }
  EXPECT_EQ(runs[0].frames, 500u);
  EXPECT_EQ(runs[0].state_hash, runs[1].state_hash);
  EXPECT_GT(way, 0.01);
  EXPECT_GT(runs[0].force_max, 0.3);
  EXPECT_EQ(runs[0].waited, 0.0);
  EXPECT_EQ(runs[0].not_whole, 0u);
  EXPECT_EQ(runs[0].largest_island, 3);
  EXPECT_GE(runs[0].port_energy_min, -1e-6);
}

TEST(WorldSession, OtherInputOtherHash) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  const auto first = push_device(), second = push_device();
  const std::uint64_t before = run_one(config, first.get()).state_hash;
  config.start.bodies[2].position.y() += 1e-12;
  EXPECT_NE(run_one(config, second.get()).state_hash, before);
}

TEST(WorldSession, RefusesDevicesThatHoldAPerson) {
  WorldBench bench;
  const WorldSessionConfig config = pushing(bench);
  PersonsDevice device;
  EXPECT_THROW(run_one(config, &device), std::invalid_argument);
}

TEST(WorldSession, TwoHandsPushTheSameWayTwiceAndBearTheSame) {
  for (const bool same_body : {true, false}) {
    WorldBench bench;
    const WorldSessionConfig config = with_two_hands(bench, same_body);
    WorldSummary runs[2];
    for (WorldSummary& run : runs) {
      BadDevice left(0.05, BadDevice::Trouble::none, 0.0),
          right(0.05, BadDevice::Trouble::none, 0.0);
      HapticDevice* devices[] = {&left, &right};
      run = run_world(config, devices);
      EXPECT_EQ(left.last.force.norm(), 0.0);  // at the end
      EXPECT_EQ(right.last.force.norm(), 0.0);
    }
    EXPECT_EQ(runs[0].state_hash, runs[1].state_hash);
    EXPECT_FALSE(runs[0].has_fault());
    ASSERT_EQ(runs[0].hands.size(), 2u);
    for (const WorldHandSummary& hand : runs[0].hands) {
      EXPECT_GT(hand.force_max, 0.1);
      EXPECT_GE(hand.port_energy_min, -1e-3);
    }
    EXPECT_LE(runs[0].energy_made, 1e-5);  // a port's work is summed at the ends of steps
    if (same_body) {
      EXPECT_NEAR(runs[0].hands[0].force_max, runs[0].hands[1].force_max, 1e-3);
    }
  }
}

TEST(WorldSession, AFaultOfOneHandLeavesBothAtZeroForce) {
  const struct {
    BadDevice::Trouble trouble;
    Fault fault;
  } cases[] = {{BadDevice::Trouble::lost, Fault::device_lost},
               {BadDevice::Trouble::nan, Fault::not_finite},
               {BadDevice::Trouble::jump, Fault::pose_jump}};
  for (const auto& c : cases) {
    for (const bool is_left : {true, false}) {
      WorldBench bench;
      const WorldSessionConfig config = with_two_hands(bench, false);
      BadDevice bad(0.05, c.trouble, 0.3), good(0.05, BadDevice::Trouble::none, 0.0);
      HapticDevice* devices[] = {is_left ? &bad : &good, is_left ? &good : &bad};
      const WorldSummary run = run_world(config, devices);
      EXPECT_TRUE(run.has_fault());
      EXPECT_EQ(run.fault, c.fault) << fault_name(run.fault);
      EXPECT_EQ(run.frames, 300u);
      EXPECT_EQ(run.hands[is_left ? 0 : 1].fault, c.fault) << fault_name(c.fault);
      EXPECT_EQ(run.hands[is_left ? 1 : 0].fault, Fault::none);
      for (const BadDevice* device : {&bad, &good}) {
        EXPECT_GT(device->most, 0.05);
        expect_let_go(*device);
      }
    }
  }
}

TEST(WorldSession, AMotionThatIsNoNumberEndsAtZeroForceAndSaysSo) {
  WorldBench bench;
  WorldSessionConfig config = with_two_hands(bench, true);
  config.start.bodies[3].linear_momentum.x() = std::nan("");
  BadDevice left(0.05, BadDevice::Trouble::none, 0.0), right(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&left, &right};
  const WorldSummary run = run_world(config, devices);
  EXPECT_TRUE(run.has_fault());
  EXPECT_EQ(run.fault, Fault::not_finite);
  EXPECT_EQ(run.frames, 0u);
  EXPECT_EQ(left.most, 0.0);
  EXPECT_EQ(right.most, 0.0);
}

TEST(WorldSession, ARecordingThatFailsLeavesAllHandsAtZeroForce) {
  WorldBench bench;
  const WorldSessionConfig config = with_two_hands(bench, true);
  BadDevice left(0.05, BadDevice::Trouble::none, 0.0), right(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&left, &right};
  const auto full_disk = [](const WorldFrame& frame) {
    if (frame.frame == 350) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(run_world(config, devices, full_disk), std::runtime_error);
  for (const BadDevice* device : {&left, &right}) {
    EXPECT_GT(device->most, 0.05);
    expect_let_go(*device);
  }
}

TEST(WorldSession, EachHandHasItsLimits) {
  WorldBench bench;
  WorldSessionConfig config = with_two_hands(bench, true);
  config.hands[1].limits.max_force = 0.05;
  BadDevice left(0.05, BadDevice::Trouble::none, 0.0), right(0.05, BadDevice::Trouble::none, 0.0);
  HapticDevice* devices[] = {&left, &right};
  run_world(config, devices);
  EXPECT_GT(left.most, 0.1);
  EXPECT_LE(right.most, 0.05 * (1.0 + 1e-15));
  EXPECT_THROW(run_world(config, {devices, 1}), std::invalid_argument);
}

TEST(WorldSession, RunsWithoutADevice) {
  WorldBench bench;
  WorldSessionConfig config = pushing(bench);
  config.hands.clear();
  config.duration = 1.5;
  const WorldSummary run = run_world(config, {});
  EXPECT_EQ(run.frames, 1500u);
  EXPECT_LE(run.energy_end, run.energy_start);
  EXPECT_EQ(run.force_max, 0.0);
}

/// A page's hand as a script: its clutch is closed between two times, it is lifted meanwhile.
class PageHand final : public HapticDevice {
 public:
  double closes = 0.2, opens = 0.5, lost_at = 1e9, speed = 0.1;
  PageHand() { limits_.holds_person = false; }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "page"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    const bool is_closed = now >= closes && now < opens;
    state.buttons = is_closed ? kClutchButton : 0;
    const double lifted = std::clamp(now, closes, opens) - closes;
    state.motion.pose.position.z() = speed * lifted;
    if (is_closed) state.motion.twist.linear.z() = speed;
    if (now >= lost_at) state.status = DeviceStatus::lost;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override { sent.push_back(wrench.force.norm()); }
  std::vector<double> sent;

 private:
  DeviceLimits limits_;
};

/// Two blocks on a floor that nobody holds, and a hand that may take hold of either.
WorldSessionConfig with_free_hand(WorldBench& bench) {
  test::add_floor(bench, 1.0);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  for (int i = 0; i < 2; ++i) bench.add(block, BodyKind::moving, Vec3(0.1 * i, 0.0, 0.02 + 3e-6));
  bench.make();
  WorldSessionConfig config = test::free_handed(bench);
  config.hands[0].body = 2;
  config.duration = 1.0;
  return config;
}

TEST(WorldSession, AFreeHandTakesHoldWithoutAJumpAndLetsGo) {
  WorldBench bench;
  WorldSessionConfig config = with_free_hand(bench);
  PageHand hand;
  hand.closes = 0.7;  // both blocks are asleep by then
  hand.opens = 0.9;
  std::vector<double> heights;
  std::vector<std::int32_t> held;
  std::int32_t awake_before = -1;
  run_one(config, &hand, [&](const WorldFrame& frame) {
    heights.push_back(frame.bodies[2].position.z());
    held.push_back(frame.grips[0].body);
    if (frame.frame == 650) awake_before = frame.step.awake;
  });
  EXPECT_EQ(awake_before, 0);
  ASSERT_EQ(held.size(), 1000u);
  EXPECT_EQ(held[699], -1);
  EXPECT_EQ(held[700], 2);
  EXPECT_EQ(held[899], 2);
  EXPECT_EQ(held[900], -1);
  const double weight = bench.bodies[2].mass * 9.81;
  // It begins with what the damper makes of the hand's speed, never with a spring's stretch.
  EXPECT_LE(hand.sent[700], 16.0 * hand.speed + 0.1 * weight);
  EXPECT_GT(hand.sent[880], 0.9 * weight);
  EXPECT_EQ(hand.sent[905], 0.0);
  EXPECT_GT(heights[899], heights[699] + 0.015);
  // Let go it flies on as any free body: its speed, then gravity.
  const double v = (heights[901] - heights[900]) / 1e-3;
  EXPECT_NEAR(heights[921] - heights[901], 0.02 * v - 0.5 * 9.81 * 0.02 * 0.02, 2e-5 + 9.81e-5);
  EXPECT_EQ(hand.sent.back(), 0.0);
}

TEST(WorldSession, AHandThatHoldsNothingChangesNoBit) {
  WorldBench bench;
  WorldSessionConfig config = with_free_hand(bench);
  PageHand hand;
  hand.closes = hand.opens = 0.5;
  const std::uint64_t watched = run_one(config, &hand).state_hash;
  config.hands.clear();
  EXPECT_EQ(run_world(config, {}).state_hash, watched);
}

TEST(WorldSession, AimedAnewAHandChangesItsBody) {
  WorldBench bench;
  WorldSessionConfig config = with_free_hand(bench);
  PageHand hand;
  hand.speed = 0.0;
  HapticDevice* device = &hand;
  WorldRun run(config, {&device, 1});
  std::vector<std::int32_t> held;
  for (int i = 0; i < 450; ++i) {
    if (i == 300) run.aim({1, Vec3(0.01, 0.0, 0.0)});
    if (i == 350) run.aim({0, Vec3::Zero()});   // the floor: nothing moves it
    if (i == 400) run.aim({77, Vec3::Zero()});  // there is none
    const WorldFrame* frame = run.make_frame();
    ASSERT_NE(frame, nullptr);
    held.push_back(frame->grips[0].body);
    // Both rest: neither taking hold nor letting go is felt.
    EXPECT_LE(hand.sent.back(), 1e-3);
  }
  EXPECT_EQ(held[299], 2);
  EXPECT_EQ(held[300], 1);
  EXPECT_EQ(held[350], -1);
  EXPECT_EQ(held[400], -1);
}

TEST(WorldSession, AWorldGoesOnWithABodyLessAndItsHandsHoldWhatTheyHeld) {
  WorldBench bench;
  const WorldSessionConfig config = with_free_hand(bench);
  bench.bodies.erase(bench.bodies.begin() + 1);  // the block that the hand does not hold
  bench.make();
  WorldSessionConfig next = config;
  next.world = bench.world;
  next.start = bench.state;
  next.hands[0].couplings.pop_back();
  WorldSessionConfig none = next;
  PageHand hand;
  hand.closes = 0.1;
  hand.opens = 0.9;
  HapticDevice* device = &hand;
  WorldRun run(config, {&device, 1});
  for (int i = 0; i < 300; ++i) ASSERT_NE(run.make_frame(), nullptr);
  WorldState state = next.start;
  state.bodies = {run.state().bodies[0], run.state().bodies[2]};
  const double before = hand.sent.back();
  run.go_on(next, state, std::vector<std::int32_t>{0, 2});
  const WorldFrame* frame = run.make_frame();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->frame, 300u);  // session time goes on
  EXPECT_EQ(frame->bodies.size(), 2u);
  EXPECT_EQ(frame->grips[0].body, 1);
  EXPECT_NEAR(hand.sent.back(), before, 1e-2 * before);  // no jump in the hand
  for (int i = 0; i < 50; ++i) ASSERT_NE(run.make_frame(), nullptr);
  // What it holds goes as well.
  state = run.state();
  run.go_on(none, state, std::vector<std::int32_t>{0, -1});
  frame = run.make_frame();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->grips[0].body, -1);
  EXPECT_EQ(hand.sent.back(), 0.0);
  const WorldSummary summary = run.end();
  // What the body that went had is not missed: as if it had never been there.
  EXPECT_NEAR(summary.energy_start, mechanical_energy(next.world, next.start), 1e-6);
  EXPECT_LE(summary.energy_made, 2e-5);
}

TEST(WorldSession, ALostPageLetsGoAndTheWorldGoesOn) {
  WorldBench bench;
  WorldSessionConfig config = with_free_hand(bench);
  PageHand hand;
  hand.closes = 0.1;
  hand.opens = 0.8;
  hand.lost_at = 0.3;
  std::vector<std::int32_t> held;
  const WorldSummary run =
      run_one(config, &hand, [&](const WorldFrame& frame) { held.push_back(frame.grips[0].body); });
  EXPECT_FALSE(run.has_fault());
  ASSERT_EQ(run.frames, 1000u);
  EXPECT_EQ(held[299], 2);
  EXPECT_EQ(held[300], -1);
  EXPECT_GT(hand.sent[299], 0.1);
  EXPECT_EQ(hand.sent[300], 0.0);
}

}  // namespace
}  // namespace thigma
