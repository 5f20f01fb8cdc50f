// Worlds with joints: drift, energy, momentum, limits, motors, springs.

#include <cmath>
#include <numbers>

#include "multibody/world_bench.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/multibody/detail/jointed_island.h"

namespace thigma {
namespace {

using test::WorldBench;

constexpr double kGravity = 9.81;
const Vec3 kDown(0.0, 0.0, -kGravity);

struct JointBench : WorldBench {
  std::vector<WorldJoint> joints;

  WorldJoint& tie(JointKind kind, std::int32_t a, std::int32_t b, const Vec3& place,
                  const Vec3& axis = Vec3::UnitY()) {
    WorldJoint joint{{.kind = kind, .a = a, .b = b}, "joint " + std::to_string(joints.size())};
    std::vector<BodyState> start;
    for (const WorldBody& body : bodies) start.push_back(body.start);
    place_joint(joint, joint_frame(place, axis), start);
    joints.push_back(joint);
    return joints.back();
  }
  void tie_all(const Vec3& gravity) {
    world = make_world(bodies, gravity, joints);
    state = start_state(world);
    scratch = reserve_world(world);
    world.sleeps = false;
  }
  JointReading read(std::int32_t joint, double dt = 1e-3) const {
    return read_joint(world, state, *scratch, joint, dt);
  }
};

/// What a world without friction did over some steps.
struct Course {
  double grown = 0.0, lost = 0.0;  // of the energy, against the start [J]
  double error = 0.0;              // of joints [m]
  double waited = 0.0;
  int not_whole = 0, most_parts = 0;
  std::int64_t newton = 0;
};
Course run(JointBench& bench, int steps, double dt = 1e-3) {
  Course out;
  const double start = bench.energy();
  for (int i = 0; i < steps; ++i) {
    const WorldStep step = bench.step(dt);
    out.grown = std::max(out.grown, bench.energy() - start);
    out.error = std::max(out.error, step.joint_error);
    out.waited += step.waited;
    out.not_whole += step.is_whole ? 0 : 1;
    out.most_parts = std::max(out.most_parts, step.parts);
    out.newton += step.newton;
  }
  out.lost = start - bench.energy();
  return out;
}

/// A bar that hangs by its end, held out level: its energy is that of its fall, m g l / 2.
JointBench pendulum(double length, JointKind kind = JointKind::hinge) {
  JointBench bench;
  const auto bar = test::body_mesh(make_box(Vec3(length, 0.01, 0.006)));
  bench.add(bar, BodyKind::moving, Vec3(0.5 * length, 0.0, 0.0));
  bench.tie(kind, 0, -1, Vec3::Zero());
  bench.tie_all(kDown);
  return bench;
}

TEST(JointedWorld, HingeSwingsWithoutDriftAndWithoutGainingEnergy) {
  const double length = 0.1;
  JointBench bench = pendulum(length);
  const double fall = bench.bodies[0].mass * kGravity * 0.5 * length;
  const Course out = run(bench, test::is_full() ? 60000 : 6000);
  EXPECT_LE(out.error, 1e-6 * length);
  EXPECT_LE(out.grown, 1e-6 * fall);
  EXPECT_LE(std::fabs(out.lost), 1e-3 * fall);
  EXPECT_EQ(out.not_whole, 0);
  EXPECT_EQ(out.most_parts, 1);
  RecordProperty("error_of_length", std::to_string(out.error / length * 1e12) + "e-12");
  RecordProperty("grown", std::to_string(out.grown / fall * 1e12) + "e-12");
  RecordProperty("lost", std::to_string(out.lost / fall * 1e6) + "e-6");
  RecordProperty("newton", std::to_string(out.newton));
}

TEST(JointedWorld, HingeSwingsAsFastAsAPendulum) {
  // Small swings of a bar of length l about its end: w^2 = m g (l/2) / I about the end.
  const double length = 0.1, angle = 0.01;
  JointBench bench = pendulum(length);
  const Quat turn = rotation_from_vector((0.5 * std::numbers::pi - angle) * Vec3::UnitY());
  bench.state.bodies[0].orientation = turn;
  bench.state.bodies[0].position = turn * Vec3(0.5 * length, 0.0, 0.0);
  const double m = bench.bodies[0].mass, inertia = bench.bodies[0].inertia(1, 1);
  const double rate =
      std::sqrt(m * kGravity * 0.5 * length / (inertia + 0.25 * m * length * length));
  const double period = 2.0 * std::numbers::pi / rate;
  const int steps = static_cast<int>(std::lround(10.0 * period / 1e-3));
  const double start = bench.read(0).coordinate;
  for (int i = 0; i < steps; ++i) bench.step();
  const double swung = bench.read(0).coordinate - 0.5 * std::numbers::pi;
  const double expected = (start - 0.5 * std::numbers::pi) * std::cos(rate * 1e-3 * steps);
  EXPECT_NEAR(swung, expected, 3e-3 * angle);
}

TEST(JointedWorld, ChainSwingsWithoutDriftAndWithoutGainingEnergy) {
  JointBench bench;
  const auto link = test::body_mesh(make_box(Vec3(0.03, 0.008, 0.005)));
  const int links = 10;
  for (int i = 0; i < links; ++i)
    bench.add(link, BodyKind::moving, Vec3(0.03 * (i + 0.5), 0.0, 0.0));
  for (int i = 0; i < links; ++i) bench.tie(JointKind::ball, i, i - 1, Vec3(0.03 * i, 0.0, 0.0));
  for (WorldJoint& joint : bench.joints) joint.touches = false;
  bench.tie_all(kDown);
  // Out of the plane as well.
  bench.state.bodies[9].linear_momentum = bench.bodies[9].mass * Vec3(0.0, 0.3, 0.0);
  // Links that are not next to each other must not meet here: only joints are looked at.
  for (std::int32_t a = 0; a < links; ++a)
    for (std::int32_t b = a + 1; b < links; ++b) bench.world.never_touch.push_back(a * links + b);
  std::sort(bench.world.never_touch.begin(), bench.world.never_touch.end());
  const double fall = links * bench.bodies[0].mass * kGravity * 0.5 * 0.3;
  const Course out = run(bench, test::is_full() ? 60000 : 3000);
  EXPECT_LE(out.error, 1e-6 * 0.015);
  EXPECT_LE(out.grown, 1e-6 * fall);
  EXPECT_EQ(out.not_whole, 0);
  EXPECT_EQ(out.waited, 0.0);
  RecordProperty("error_of_reach", std::to_string(out.error / 0.015 * 1e12) + "e-12");
  RecordProperty("grown", std::to_string(out.grown / fall * 1e12) + "e-12");
  RecordProperty("lost", std::to_string(out.lost / fall * 1e6) + "e-6");
  RecordProperty("parts", out.most_parts);
  RecordProperty("newton", std::to_string(out.newton));
}

TEST(JointedWorld, FreePairsKeepMomentumAndEnergy) {
  for (const JointKind kind : {JointKind::fixed, JointKind::hinge, JointKind::slider,
                               JointKind::ball, JointKind::spring}) {
    JointBench bench;
    Random random(8);
    const auto block = test::body_mesh(make_box(Vec3(0.03, 0.02, 0.04)));
    for (int i = 0; i < 2; ++i) {
      WorldBody& body = bench.add(block, BodyKind::moving, Vec3(0.05 * i, 0.01 * i, 0.0),
                                  random.orientation(), 500.0 + 1000.0 * i);
      body.start.linear_momentum = body.mass * random.in_cube(0.3);
      body.start.angular_momentum = body.inertia * random.in_cube(10.0);
    }
    WorldJoint& joint = bench.tie(kind, 0, 1, Vec3(0.025, 0.0, 0.01), random.direction());
    if (kind == JointKind::spring) {
      joint.b_from_joint.position += Vec3(0.0, 0.03, 0.0);
      joint.stiffness = 20.0;
      joint.rest = 0.03;
    } else if (has_coordinate(kind)) {
      joint.stiffness = kind == JointKind::hinge ? 0.01 : 20.0;
    }
    bench.tie_all(Vec3::Zero());
    bench.step();  // takes up speeds that the joint does not allow
    const double energy = bench.energy();
    const WorldMomentum start = momentum(bench.world, bench.state);
    const Course out = run(bench, 3000);
    const WorldMomentum end = momentum(bench.world, bench.state);
    const double turn = bench.bodies[0].mass * 0.3 * 0.05;
    EXPECT_LE((end.linear - start.linear).norm(), 1e-13 * bench.bodies[0].mass) << out.error;
    EXPECT_LE((end.angular - start.angular).norm(), 1e-9 * turn) << static_cast<int>(kind);
    EXPECT_LE(out.grown, 1e-6 * energy) << static_cast<int>(kind);
    EXPECT_LE(std::fabs(out.lost), 1e-3 * energy) << static_cast<int>(kind);
    EXPECT_LE(out.error, 1e-6 * 0.025);
    EXPECT_EQ(out.not_whole, 0);
  }
}

TEST(JointedWorld, LimitsStopAndDoNotBounce) {
  const double length = 0.1;
  JointBench bench;
  bench.add(test::body_mesh(make_box(Vec3(length, 0.01, 0.006))), BodyKind::moving,
            Vec3(0.5 * length, 0.0, 0.0));
  bench.tie(JointKind::hinge, 0, -1, Vec3::Zero()).upper = 0.7;
  bench.tie_all(kDown);
  double most = 0.0, back = 0.0, energy = bench.energy();
  bool has_met = false;
  for (int i = 0; i < 2000; ++i) {
    bench.step();
    const double x = bench.read(0).coordinate;
    most = std::max(most, x);
    has_met = has_met || x > 0.7 - 1e-9;
    if (has_met) back = std::max(back, 0.7 - x);
    EXPECT_LE(bench.energy(), energy + 1e-12);
    energy = bench.energy();
  }
  EXPECT_TRUE(has_met);
  EXPECT_LE(most, 0.7 + 1e-9);
  EXPECT_LE(back, 1e-9);
  // It rests on it with its weight.
  const double torque = bench.bodies[0].mass * kGravity * 0.5 * length * std::cos(0.7);
  EXPECT_NEAR(bench.read(0).limit, -torque, 1e-6 * torque);
}

TEST(JointedWorld, SliderGoesAlongItsAxisBetweenItsLimits) {
  JointBench bench;
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.03, 0.02)));
  bench.add(block, BodyKind::moving, Vec3::Zero());
  const Vec3 axis = Vec3(1.0, 0.0, -1.0).normalized();
  WorldJoint& slider = bench.tie(JointKind::slider, 0, -1, Vec3(0.0, 0.02, 0.0), axis);
  slider.lower = -0.01;
  slider.upper = 0.05;
  bench.tie_all(kDown);
  double met = 0.0;
  for (int i = 0; i < 500; ++i) {
    bench.step();
    const double t = 1e-3 * (i + 1), free = 0.5 * kGravity * std::sqrt(0.5) * t * t;
    const double x = bench.read(0).coordinate;
    if (free < 0.05) {
      EXPECT_NEAR(x, free, 1e-12 + 1e-9 * free);
    } else {
      EXPECT_NEAR(x, 0.05, 1e-11);
      met = t;
    }
    EXPECT_LT((bench.state.bodies[0].position - x * axis).norm(), 1e-11);
  }
  EXPECT_GT(met, 0.0);
}

TEST(JointedWorld, MotorKeepsItsSpeedWithinItsTorque) {
  const double length = 0.1;
  for (const double most : {1.0, 0.02}) {
    JointBench bench = pendulum(length);
    const double weight = bench.bodies[0].mass * kGravity * 0.5 * length;
    bench.joints[0].motor = {.is_on = true, .target = -2.0, .most = most * weight};
    bench.tie_all(kDown);
    double largest = 0.0;
    for (int i = 0; i < 400; ++i) {
      bench.step();
      largest = std::max(largest, std::fabs(bench.read(0).motor));
      ASSERT_LE(largest, most * weight * (1.0 + 1e-12));
    }
    if (most < 1.0) {
      EXPECT_NEAR(largest, most * weight, 1e-9 * weight);  // too weak: all it has
    }
  }
  // Without gravity it has its speed at once, and needs nothing to keep it.
  JointBench bench = pendulum(length);
  bench.joints[0].motor = {.is_on = true, .target = 5.0, .most = 10.0};
  bench.tie_all(Vec3::Zero());
  for (int i = 0; i < 100; ++i) bench.step();
  const double before = bench.read(0).coordinate;
  for (int i = 0; i < 100; ++i) bench.step();
  EXPECT_NEAR(bench.read(0).coordinate - before, 0.5, 1e-6);
  EXPECT_LT(std::fabs(bench.read(0).motor), 1e-6);
}

TEST(JointedWorld, ServoGoesToItsTargetAndIsBounded) {
  JointBench bench = pendulum(0.1);
  const double weight = bench.bodies[0].mass * kGravity * 0.05;
  bench.joints[0].motor = {.is_on = true,
                           .is_servo = true,
                           .target = -1.0,
                           .most = 3.0 * weight,
                           .stiffness = 1000.0 * weight,
                           .damping = 60.0 * weight};
  bench.tie_all(kDown);
  for (int i = 0; i < 3000; ++i) {
    bench.step();
    ASSERT_LE(std::fabs(bench.read(0).motor), 3.0 * weight * (1.0 + 1e-12));
  }
  EXPECT_NEAR(bench.read(0).coordinate, -1.0, 1e-3);
  EXPECT_NEAR(bench.read(0).motor, -weight * std::cos(1.0), 0.01 * weight);
  const MotorDrive drive{0, 0.5};
  for (int i = 0; i < 3000; ++i) bench.step(1e-3, {.motors = {&drive, 1}});
  EXPECT_NEAR(bench.read(0).coordinate, 0.5, 1e-3);
}

TEST(JointedWorld, SpringSwingsAtItsRateAndItsDamperStopsIt) {
  for (const double damping : {0.0, 0.1}) {
    JointBench bench;
    const auto block = test::body_mesh(make_box(Vec3(0.04, 0.03, 0.02)));
    bench.add(block, BodyKind::moving, Vec3(0.1, 0.0, 0.0));
    WorldJoint& spring = bench.tie(JointKind::spring, 0, -1, Vec3(0.1, 0.0, 0.0));
    spring.b_from_joint.position = Vec3::Zero();
    spring.stiffness = 10.0;
    spring.damping = damping;
    spring.rest = 0.09;
    bench.tie_all(Vec3::Zero());
    const double energy = bench.energy(), m = bench.bodies[0].mass;
    EXPECT_NEAR(energy, 0.5 * 10.0 * 0.01 * 0.01, 1e-15);
    const double lag = 0.5 * damping / m, rate = std::sqrt(10.0 / m - lag * lag);
    for (int i = 0; i < 1000; ++i) {
      bench.step();
      ASSERT_LE(bench.energy(), energy * (1.0 + 1e-9));
      const double t = 1e-3 * (i + 1);
      const double x =
          0.01 * std::exp(-lag * t) * (std::cos(rate * t) + lag / rate * std::sin(rate * t));
      ASSERT_NEAR(bench.read(0).coordinate - 0.09, x, 3e-5 * (1.0 + t)) << i;
    }
    if (damping == 0.0) {
      EXPECT_NEAR(bench.energy(), energy, 1e-6 * energy);
    }
  }
}

TEST(JointedWorld, LidFallsOnItsBoxAndRestsThere) {
  // A hinge and contacts in one island; the lid and the box may touch.
  JointBench bench;
  test::add_floor(bench);
  bench.add(test::body_mesh(make_box(Vec3(0.08, 0.06, 0.04))), BodyKind::moving,
            Vec3(0.0, 0.0, 0.02 + 5e-6));
  const Quat open = rotation_from_vector(-1.0 * Vec3::UnitY());
  const Vec3 pin(-0.04, 0.0, 0.046);
  bench.add(test::body_mesh(make_box(Vec3(0.08, 0.06, 0.004))), BodyKind::moving,
            pin + open * Vec3(0.04, 0.0, 0.0), open, 500.0);
  WorldJoint& hinge = bench.tie(JointKind::hinge, 2, 1, pin);
  hinge.touches = true;
  bench.tie_all(kDown);
  double energy = bench.energy();
  const double start = energy;
  int not_whole = 0;
  double waited = 0.0, error = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const WorldStep step = bench.step();
    not_whole += step.is_whole ? 0 : 1;
    waited += step.waited;
    error = std::max(error, step.joint_error);
    EXPECT_LE(bench.energy(), energy + 1e-9 * start) << i;
    energy = bench.energy();
    if (i % 50 == 0) {
      EXPECT_GT(bench.distance(1, 2), 0.0) << i;
      EXPECT_GT(bench.distance(0, 1), 0.0) << i;
    }
  }
  EXPECT_EQ(not_whole, 0);
  EXPECT_EQ(waited, 0.0);
  EXPECT_LE(error, 1e-8);
  EXPECT_LT(bench.distance(1, 2), 1e-4);
  EXPECT_LT(bench.state.bodies[2].linear_momentum.norm() / bench.bodies[2].mass, 1e-4);
  EXPECT_LT((bench.state.bodies[1].position - Vec3(0.0, 0.0, 0.02)).norm(), 1e-3);
}

TEST(JointedWorld, JointedBodyBouncesAsItsRestitutionSays) {
  // A bar on a hinge falls on a floor: its end comes back at e times its speed.
  for (const double e : {0.8, 0.4}) {
    JointBench bench;
    test::add_floor(bench);
    bench.add(test::body_mesh(make_box(Vec3(0.1, 0.01, 0.006))), BodyKind::moving,
              Vec3(0.05, 0.0, 0.05));
    bench.bodies[1].restitution = e;
    bench.bodies[1].friction = {0.0, 0.0};  // rubbing would take its share
    bench.tie(JointKind::hinge, 1, -1, Vec3(0.0, 0.0, 0.05));
    bench.tie_all(kDown);
    double before = 0.0, after = 0.0, error = 0.0;
    for (int i = 0; i < 300 && after == 0.0; ++i) {
      const WorldStep step = bench.step();
      error = std::max(error, step.joint_error);
      const double rate = velocity(bench.world.rigid[1], bench.state.bodies[1]).angular.y();
      if (step.impacts > 0)
        after = rate;
      else
        before = rate;
    }
    EXPECT_GT(before, 5.0);
    EXPECT_NEAR(-after / before, e, 0.02 * e);
    EXPECT_LE(error, 1e-9);
  }
}

TEST(JointedWorld, PendulumOfAPrescribedArmFollowsIt) {
  JointBench bench;
  const auto block = test::body_mesh(make_box(Vec3(0.02, 0.02, 0.02)));
  bench.add(block, BodyKind::prescribed, Vec3::Zero());
  bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, -0.06));
  bench.tie(JointKind::ball, 1, 0, Vec3(0.0, 0.0, -0.02));
  bench.tie_all(kDown);
  const BodyDrive drive{0, {Vec3(0.1, 0.0, 0.0), Vec3(0.0, 0.0, 3.0)}};
  double error = 0.0;
  for (int i = 0; i < 2000; ++i)
    error = std::max(error, bench.step(1e-3, {.drives = {&drive, 1}}).joint_error);
  EXPECT_LE(error, 1e-8);
  EXPECT_NEAR(bench.state.bodies[0].position.x(), 0.2, 1e-5);
  EXPECT_NEAR(bench.state.bodies[1].position.x(), 0.2, 0.02);
}

TEST(JointedWorld, ChainInTheHandFollowsAndGivesNoEnergy) {
  JointBench bench;
  const auto link = test::body_mesh(make_box(Vec3(0.03, 0.008, 0.005)));
  for (int i = 0; i < 5; ++i)
    bench.add(link, i == 0 ? BodyKind::held : BodyKind::moving, Vec3(0.03 * (i + 0.5), 0.0, 0.0));
  for (int i = 1; i < 5; ++i) bench.tie(JointKind::ball, i, i - 1, Vec3(0.03 * i, 0.0, 0.0));
  bench.tie_all(Vec3::Zero());
  HandHold hand;
  hand.body = 0;
  hand.coupling.linear_stiffness = 500.0;
  hand.coupling.linear_damping = 2.0 * std::sqrt(500.0 * bench.bodies[0].mass);
  hand.coupling.angular_stiffness = 1.0;
  hand.coupling.angular_damping = 0.01;
  hand.handle.pose.position = bench.bodies[0].start.position;
  double energy = 0.0, least = 0.0, error = 0.0, before = hand.handle.pose.position.y();
  for (int i = 1; i <= 3000; ++i) {
    const double t = 1e-3 * i, rate = 2.0 * std::numbers::pi;
    hand.handle.pose.position.y() = 0.03 * std::sin(rate * t);
    hand.handle.twist.linear.y() = 0.03 * rate * std::cos(rate * t);
    error = std::max(error, bench.step(1e-3, {.hands = {&hand, 1}}).joint_error);
    const Wrench w =
        coupling_reaction(hand.coupling, hand.handle, bench.world.rigid[0], bench.state.bodies[0]);
    energy -= w.force.y() * (hand.handle.pose.position.y() - before);
    before = hand.handle.pose.position.y();
    least = std::min(least, energy);
  }
  EXPECT_LE(error, 1e-9);
  EXPECT_GE(least, -1e-6);
}

// A minute a swing, let go so near its rest that it moves by less in half a second than what
// sleeps.
TEST(JointedWorld, ASlowSpringIsNotTakenForRest) {
  constexpr double kPeriod = 60.0, kOff = 2e-5;
  JointBench bench;
  bench.add(test::body_mesh(make_box(Vec3(0.02, 0.02, 0.02))), BodyKind::moving, Vec3::Zero());
  WorldJoint& spring = bench.tie(JointKind::slider, 0, -1, Vec3::Zero());
  const double rate = 2.0 * std::numbers::pi / kPeriod;
  spring.stiffness = bench.bodies[0].mass * rate * rate;
  spring.rest = kOff;
  bench.tie_all(Vec3::Zero());
  bench.world.sleeps = true;
  for (int i = 0; i < 15000; ++i) bench.step();
  EXPECT_NEAR(bench.read(0).coordinate, kOff, 1e-3 * kOff);  // after a quarter of it
}

TEST(JointedWorld, SleepsWithItsJointsAndWakesThroughThem) {
  JointBench bench;
  const auto block = test::body_mesh(make_box(Vec3(0.02, 0.02, 0.02)));
  for (int i = 0; i < 3; ++i) bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, -0.03 * (i + 1)));
  for (int i = 0; i < 3; ++i)
    bench.tie(JointKind::ball, i, i - 1, Vec3(0.0, 0.0, -0.03 * i - 0.015));
  bench.tie_all(kDown);
  bench.world.sleeps = true;
  for (int i = 0; i < 700; ++i) bench.step();
  for (const std::uint8_t asleep : bench.state.is_asleep) EXPECT_EQ(asleep, 1);
  bench.state.is_asleep[2] = 0;
  bench.state.bodies[2].linear_momentum.x() = 0.1 * bench.bodies[2].mass;
  bench.step();
  for (const std::uint8_t asleep : bench.state.is_asleep) EXPECT_EQ(asleep, 0);
}

}  // namespace
}  // namespace thigma
