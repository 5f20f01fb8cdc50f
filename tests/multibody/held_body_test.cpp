// A hand that holds a body among others: what it feels of them.

#include <cmath>
#include <numbers>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/math/rotation.h"
#include "thigma/multibody/step_world.h"

namespace thigma {
namespace {

using test::WorldBench;

constexpr double kGravity = 9.81;
constexpr double kDt = 1e-3;

Coupling coupling_for(double mass) {
  Coupling coupling;
  coupling.linear_stiffness = 1000.0;
  coupling.linear_damping = 2.0 * std::sqrt(1000.0 * mass);
  coupling.angular_stiffness = 2.0;
  coupling.angular_damping = 0.02;
  return coupling;
}

/// A block in the hand behind blocks on a floor, in a row along x.
struct Row {
  WorldBench bench;
  HandHold hand;
  double feel = 0.0;    // force on the hand along x, against its push [N]
  double energy = 0.0;  // that the hand has put in [J]
  double least = 0.0;   // of it
  WorldStep step;

  Row(int blocks, double mu, const Vec3& gravity) {
    test::add_floor(bench, 3.0);
    const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
    const double gap = 5e-6;
    WorldBody& pusher = bench.add(block, BodyKind::held, Vec3(-0.041, 0.0, 0.021));
    pusher.friction = {0.0, 0.0};
    for (int i = 0; i < blocks; ++i)
      bench.add(block, BodyKind::moving, Vec3((0.04 + gap) * i, 0.0, 0.02 + gap)).friction = {mu,
                                                                                              mu};
    bench.bodies[0].friction = {mu, mu};
    bench.make(gravity);
    bench.world.sleeps = false;
    hand.body = 1;
    hand.coupling = coupling_for(bench.bodies[1].mass);
    hand.handle.pose = {bench.bodies[1].start.position, Quat::Identity()};
    // Carried: the spring bears the weight where the block is.
    hand.handle.pose.position.z() -=
        bench.bodies[1].mass * gravity.z() / hand.coupling.linear_stiffness;
  }

  /// The hand at a place along x and a speed.
  void move(double x, double speed) {
    const double before = hand.handle.pose.position.x();
    hand.handle.pose.position.x() = x;
    hand.handle.twist.linear.x() = speed;
    step = bench.step(kDt, {.hands = {&hand, 1}});
    const Wrench reaction =
        coupling_reaction(hand.coupling, hand.handle, bench.world.rigid[1], bench.state.bodies[1]);
    feel = -reaction.force.x();
    energy += feel * (x - before);
    least = std::min(least, energy);
  }
};

TEST(HeldBody, FeelsTheMassItAccelerates) {
  Row row(1, 0.0, Vec3::Zero());
  const double a = 0.5, start = -0.041;
  double sum = 0.0;
  int count = 0;
  for (int i = 1; i <= 1500; ++i) {
    const double t = kDt * i;
    row.move(start + 0.5 * a * t * t, a * t);
    if (i <= 1000) continue;
    sum += row.feel;
    ++count;
  }
  const double mass = row.bench.bodies[1].mass + row.bench.bodies[2].mass;
  EXPECT_NEAR(sum / count, mass * a, 0.02 * mass * a);
  EXPECT_GT(row.bench.state.bodies[2].position.x(), 0.1);
}

TEST(HeldBody, FeelsTheFrictionOfWhatItPushes) {
  for (const int blocks : {1, 10}) {
    const double mu = 0.3;
    Row row(blocks, mu, Vec3(0.0, 0.0, -kGravity));
    const double speed = 0.05, start = -0.041;
    double sum = 0.0, least = 1e9, most = 0.0;
    int count = 0;
    for (int i = 1; i <= 900; ++i) {
      row.move(start + speed * kDt * i, speed);
      ASSERT_TRUE(row.step.is_whole);
      ASSERT_EQ(row.step.waited, 0.0);
      if (i <= 600) continue;
      sum += row.feel;
      least = std::min(least, row.feel);
      most = std::max(most, row.feel);
      ++count;
    }
    const double expected = blocks * mu * row.bench.bodies[2].mass * kGravity;
    EXPECT_NEAR(sum / count, expected, 0.02 * expected);
    EXPECT_GT(least, 0.9 * expected);
    EXPECT_LT(most, 1.1 * expected);
    EXPECT_EQ(row.step.largest_island, blocks + 1);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(blocks); ++k) {
      EXPECT_GT(row.bench.distance(k, k + 1), 0.0) << k;
      EXPECT_GT(row.bench.distance(0, k + 1), 0.0) << k;
    }
  }
}

TEST(HeldBody, GivesTheHandNoEnergy) {
  Row row(3, 0.3, Vec3(0.0, 0.0, -kGravity));
  // To and fro, striking the row again and again.
  for (int i = 1; i <= 1500; ++i) {
    const double t = kDt * i, rate = 2.0 * std::numbers::pi, reach = 0.03;
    row.move(-0.041 - reach + reach * std::cos(rate * t) + 0.02 * t,
             -reach * rate * std::sin(rate * t) + 0.02);
    ASSERT_TRUE(row.step.is_whole) << i;
  }
  EXPECT_GE(row.least, -1e-6);
  EXPECT_GT(row.energy, 0.0);
}

/// A square peg in the hand and a block with a square hole, 0.4 mm wider, that lies on a floor.
struct PegInHole {
  WorldBench bench;
  HandHold hand;

  PegInHole() {
    test::add_floor(bench, 1.0);
    const double hole = 0.0082, out = 0.03;
    const double xs[] = {-out, -hole, hole, out}, zs[] = {0.0, 0.03};
    bench.add(test::body_mesh(
                  make_blocks(xs, xs, zs, [](int i, int k, int) { return i != 1 || k != 1; })),
              BodyKind::moving, Vec3(0.0, 0.0, 0.015 + 5e-6), Quat::Identity(), 2000.0);
    bench.add(test::body_mesh(make_box(Vec3(0.016, 0.016, 0.05))), BodyKind::held,
              Vec3(0.0, 0.0, 0.06), Quat::Identity(), 2000.0);
    for (WorldBody& body : bench.bodies) body.friction = {0.4, 0.4};
    bench.make();
    hand.body = 2;
    hand.coupling = coupling_for(bench.bodies[2].mass);
    hand.handle.pose = {bench.bodies[2].start.position, Quat::Identity()};
  }
  Wrench step() {
    bench.step(kDt, {.hands = {&hand, 1}});
    return coupling_reaction(hand.coupling, hand.handle, bench.world.rigid[2],
                             bench.state.bodies[2]);
  }
};

TEST(HeldBody, JammedPegDoesNotChatter) {
  PegInHole peg;
  // Down askew, sideways and turned, until it jams; then slowly to and fro, so that it works loose
  // and jams again.
  const int down = 800, held = 1000;
  std::vector<Vec3> forces;
  for (int i = 1; i <= down + held; ++i) {
    const double share = std::min(1.0, static_cast<double>(i) / down);
    peg.hand.handle.pose.position = Vec3(0.004 * share, 0.001 * share, 0.06 - 0.03 * share);
    peg.hand.handle.pose.orientation = rotation_from_vector(share * Vec3(0.03, 0.25, 0.0));
    peg.hand.handle.twist = {};
    if (i < down) peg.hand.handle.twist.linear = Vec3(0.004, 0.001, -0.03) / (kDt * down);
    if (i >= down) {
      const double t = kDt * (i - down), rate = std::numbers::pi, reach = 1e-3;
      peg.hand.handle.pose.position += reach * std::sin(rate * t) * Vec3(0.0, 0.5, 1.0);
      peg.hand.handle.twist.linear = reach * rate * std::cos(rate * t) * Vec3(0.0, 0.5, 1.0);
    }
    const Wrench w = peg.step();
    if (i > down + 200) forces.push_back(w.force);
  }
  double least = 1e9, most = 0.0;
  for (const Vec3& force : forces) {
    least = std::min(least, force.norm());
    most = std::max(most, force.norm());
  }
  EXPECT_GT(least, 0.5);  // it does jam
  EXPECT_GT(most, least + 0.2);
  EXPECT_GT(peg.bench.distance(1, 2), 0.0);
  // Above 50 Hz: what a mean over a period of it does not follow.
  const int window = 20;
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = window; i + window < forces.size(); ++i, ++count) {
    Vec3 mean = Vec3::Zero();
    for (std::size_t k = i - window / 2; k < i + window / 2; ++k) mean += forces[k] / window;
    sum += (forces[i] - mean).squaredNorm();
  }
  const double rms = std::sqrt(sum / count);
  RecordProperty("rms_mN", std::to_string(1e3 * rms));
  EXPECT_LE(rms, 2e-3);
}

TEST(HeldBody, TwoHandsMayHoldOneBody) {
  WorldBench bench;
  bench.add(test::body_mesh(make_box(Vec3(0.1, 0.02, 0.02))), BodyKind::held, Vec3::Zero());
  bench.make();
  HandHold hands[2];
  for (int k = 0; k < 2; ++k) {
    const double side = k == 0 ? -1.0 : 1.0;
    hands[k].body = 0;
    hands[k].coupling = coupling_for(bench.bodies[0].mass);
    hands[k].coupling.body_from_grasp.position = Vec3(0.05 * side, 0.0, 0.0);
    hands[k].handle.pose.position = Vec3(0.05 * side, 0.0, 0.0);
  }
  for (int i = 0; i < 3000; ++i) bench.step(kDt, {.hands = hands});
  Vec3 sum = Vec3::Zero();
  for (const HandHold& hand : hands) {
    const Wrench w =
        coupling_reaction(hand.coupling, hand.handle, bench.world.rigid[0], bench.state.bodies[0]);
    EXPECT_NEAR(w.force.z(), -0.5 * kGravity * bench.bodies[0].mass, 1e-6);
    sum += w.force;
  }
  EXPECT_NEAR(sum.z(), -kGravity * bench.bodies[0].mass, 1e-6);
}

TEST(HeldBody, AMovingBodyInAHandGoesAsAHeldOneBitForBit) {
  BodyState ends[2];
  for (const bool is_moving : {false, true}) {
    WorldBench bench;
    test::add_floor(bench);
    const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
    bench.add(block, is_moving ? BodyKind::moving : BodyKind::held, Vec3(0.0, 0.0, 0.02 + 3e-6));
    bench.add(block, BodyKind::moving, Vec3(0.041, 0.0, 0.02 + 3e-6));
    bench.make();
    HandHold hand;
    hand.body = 1;
    hand.coupling = coupling_for(bench.bodies[1].mass);
    for (int i = 0; i < 200; ++i) {
      hand.handle.pose.position = Vec3(1e-4 * i, 0.0, 0.02 + 2e-4 * i);
      hand.handle.twist.linear = Vec3(0.1, 0.0, 0.2);
      bench.step(kDt, {.hands = {&hand, 1}});
    }
    ends[is_moving ? 1 : 0] = bench.state.bodies[1];
  }
  EXPECT_EQ(ends[0].position, ends[1].position);
  EXPECT_EQ(ends[0].orientation.coeffs(), ends[1].orientation.coeffs());
  EXPECT_EQ(ends[0].linear_momentum, ends[1].linear_momentum);
  EXPECT_EQ(ends[0].angular_momentum, ends[1].angular_momentum);
  EXPECT_GT(ends[1].position.z(), 0.05);
}

TEST(HeldBody, TakenHoldOfAsleepItWakesWithAllThatRestsOnIt) {
  WorldBench bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.02)));
  for (int i = 0; i < 3; ++i)
    bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.01 + 2e-6 + 0.020002 * i));
  bench.make();
  for (int i = 0; i < 800; ++i) bench.step();
  ASSERT_EQ(bench.step().awake, 0);
  HandHold hand;
  hand.body = 1;  // the lowest
  hand.coupling = coupling_for(3.0 * bench.bodies[1].mass);
  hand.handle.pose.position = bench.state.bodies[1].position;
  grasp(hand.coupling, bench.state.bodies[1], hand.handle.pose);
  const double top = bench.state.bodies[3].position.z();
  EXPECT_EQ(bench.step(kDt, {.hands = {&hand, 1}}).awake, 3);
  for (int i = 0; i < 400; ++i) {
    hand.handle.pose.position.z() += 5e-5;
    hand.handle.twist.linear.z() = 0.05;
    bench.step(kDt, {.hands = {&hand, 1}});
  }
  EXPECT_NEAR(bench.state.bodies[3].position.z() - top, 0.02, 1e-3);  // carried up
  const double high = bench.state.bodies[1].position.z();
  for (int i = 0; i < 100; ++i) bench.step();  // let go
  EXPECT_LT(bench.state.bodies[1].position.z(), high - 5e-3);
  for (int i = 0; i < 1200; ++i) bench.step();
  EXPECT_EQ(bench.step().awake, 0);
}

}  // namespace
}  // namespace thigma
