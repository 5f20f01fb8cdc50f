#include "thigma/dynamics/bristle.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "support/jacobian.h"
#include <gtest/gtest.h>

#include "thigma/dynamics/implicit_step.h"

namespace thigma {
namespace {

constexpr double kStep = 1e-3;

/// A plane term `depth` inside at a state.
PlaneTerm plane_at(Random& random, const BodyState& state, double depth) {
  PlaneTerm t;
  t.arm_body = random.in_cube(0.05);
  t.normal = random.direction();
  t.scene_point =
      state.position + rotation_matrix(state.orientation) * t.arm_body - depth * t.normal;
  t.stiffness = random.uniform(500.0, 5000.0);
  t.damping = random.uniform(0.0, 5.0);
  t.tolerance = 10e-3;  // far from the clamp's kink
  t.id = 3;
  t.friction = {0.3, 0.5};
  return t;
}

/// Bristles of a model in a body at a state, bent by some 2 mm.
Bristles bent(Random& random, const LinearContactModel& model, const BodyAtState& at) {
  Bristles bristles = bristles_of({model, 0.7, kStep}, at, {});
  for (Bristle& b : bristles) {
    b.entry.bend = b.entry.normal.cross(random.in_cube(2e-3));
    b.direction = b.entry.normal.cross(random.direction()).normalized();
    b.start += random.in_cube(1e-3);
  }
  return bristles;
}

TEST(Bristle, JacobiansAgreeWithDifferences) {
  Random random(1);
  for (int i = 0; i < 5; ++i) {
    const RigidBody body = test::random_body(random);
    for (const test::NamedState& at : test::states_to_try(random, body)) {
      LinearContactModel model;
      model.state = at.state;
      model.planes.push_back(plane_at(random, at.state, 2e-3));
      DepthTerm depth;
      depth.depth = 2e-3;
      depth.linear = 1.1 * random.direction();
      depth.angular = random.in_cube(0.05);
      depth.arm_body = random.in_cube(0.05);
      depth.stiffness = 2000.0;
      depth.damping = 2.0;
      depth.tolerance = 10e-3;
      depth.friction = {0.4, 0.4};
      model.depths.push_back(depth);
      Bristles bristles = bent(random, model, at_state(body, at.state));
      ASSERT_EQ(bristles.size(), 2u);
      for (Bristle& b : bristles) {
        for (const bool slides : {false, true}) {
          b.slides = slides;
          test::expect_jacobian(
              [&](const BodyState& y, WrenchJacobian* J) {
                if (J) J->setZero();
                return bristle_wrench(b, at_state(body, y), J);
              },
              body, at, 1e-6);
        }
      }
    }
  }
}

TEST(Bristle, WithoutFrictionTheStepIsTheImplicitStepToTheLastBit) {
  Random random(2);
  const RigidBody body = test::random_body(random);
  const BodyState state = test::random_state(random, body, random.orientation());
  LinearContactModel model;
  model.planes.push_back(plane_at(random, state, 1e-3));
  model.planes[0].friction = {};
  const BodyAtState at = at_state(body, state);
  StepForces forces;
  forces.wrench = contact_wrench(model, at, 1.0, &forces.jacobian);
  BristleMemory memory;
  memory.entries.push_back({});
  const BodyState next = bristle_step(at, forces, {model, 1.0, kStep}, memory);
  EXPECT_EQ(to_vector(next), to_vector(implicit_step(at, forces.wrench, forces.jacobian, kStep)));
  EXPECT_TRUE(memory.entries.empty());
}

double energy(const BristleMemory& memory) {
  double sum = 0.0;
  for (const BristleMemory::Entry& e : memory.entries)
    sum += 0.5 * e.stiffness * e.bend.squaredNorm();
  return sum;
}

TEST(Bristle, NoNewModelGivesItEnergy) {
  Random random(3);
  const RigidBody body = test::random_body(random);
  for (int trial = 0; trial < 2000; ++trial) {
    const BodyState state = test::random_state(random, body, random.orientation());
    const BodyAtState at = at_state(body, state);
    BristleMemory memory;
    for (int i = 0; i < 5; ++i) {
      BristleMemory::Entry e;
      e.id = i;
      e.stiffness = std::pow(10.0, random.uniform(-6.0, 4.0));
      e.normal = random.direction();
      e.bend = e.normal.cross(random.in_cube(1e-3));
      memory.entries.push_back(e);
    }
    LinearContactModel model;
    for (int i = 0; i < 5; ++i) {
      PlaneTerm term = plane_at(random, state, 1e-3);
      term.id = i + trial % 2;  // now and then another one
      term.stiffness = std::pow(10.0, random.uniform(-6.0, 4.0));
      if (trial % 3 == 0) term.normal = memory.entries[static_cast<std::size_t>(i)].normal;
      model.planes.push_back(term);
    }
    double after = 0.0;
    const Bristles bristles = bristles_of({model, random.uniform(), kStep}, at, memory);
    for (const Bristle& b : bristles) {
      after += 0.5 * b.entry.stiffness * b.entry.bend.squaredNorm();
      EXPECT_LE(std::fabs(b.entry.bend.dot(b.entry.normal)), 1e-12 * b.entry.bend.norm());
    }
    EXPECT_LE(after, energy(memory) * (1.0 + 1e-12));
    EXPECT_GT(after, 0.0);
  }
}

/// A block of 50 g on the plane z = 0, on its corners or on its middle; 2000 N/m together.
struct Block {
  RigidBody body;
  BodyState state;
  LinearContactModel model;
  BristleMemory memory;

  Block(const Friction& friction, const Vec3& gravity, bool is_point = false) {
    body = make_body(0.05, Mat3(1e-5 * Mat3::Identity()), gravity);
    const double half = is_point ? 0.0 : 0.01;
    for (const double x : {-half, half})
      for (const double y : {-half, half}) {
        if (is_point && !model.planes.empty()) continue;
        PlaneTerm t;
        t.arm_body = {x, y, is_point ? 0.0 : -half};
        t.normal = -Vec3::UnitZ();
        t.stiffness = is_point ? 2000.0 : 500.0;
        t.damping = 2.0 * 0.7 * std::sqrt(2000.0 * 0.05) * t.stiffness / 2000.0;
        t.id = static_cast<std::int32_t>(model.planes.size());
        t.friction = friction;
        model.planes.push_back(t);
      }
    state.position.z() = half + 0.05 * gravity.z() / 2000.0;
  }

  /// A step under a force at the centre of mass; returns what friction is at its end.
  Wrench step(const Vec3& pull) {
    const BodyAtState at = at_state(body, state);
    StepForces forces;
    forces.wrench = contact_wrench(model, at, 1.0, &forces.jacobian);
    forces.wrench.force += pull;
    state = bristle_step(at, forces, {model, 1.0, kStep}, memory);
    return memory.wrench;
  }
};

TEST(Bristle, SticksBelowTheConeAndSlidesAsCoulombSays) {
  const double mu = 0.5, g = 9.81;
  const auto on_slope = [&](double angle) {
    return Block({mu, mu}, {g * std::sin(angle), 0.0, -g * std::cos(angle)});
  };
  Block below = on_slope(0.95 * std::atan(mu));
  for (int k = 0; k < 500; ++k) below.step(Vec3::Zero());
  const Vec3 settled = below.state.position;
  for (int k = 0; k < 10000; ++k) below.step(Vec3::Zero());
  EXPECT_LE((below.state.position - settled).norm(), 1e-9);

  const double angle = 1.3 * std::atan(mu);
  Block above = on_slope(angle);
  for (int k = 0; k < 500; ++k) above.step(Vec3::Zero());
  const double before = above.state.linear_momentum.x();
  for (int k = 0; k < 500; ++k) above.step(Vec3::Zero());
  const double acceleration = (above.state.linear_momentum.x() - before) / 0.05 / 0.5;
  const double expected = g * (std::sin(angle) - mu * std::cos(angle));
  EXPECT_NEAR(acceleration, expected, 1e-3 * expected);
}

TEST(Bristle, BreaksAwayAtTheStaticForceAndSlidesWithTheKineticOne) {
  const double weight = 0.05 * 9.81, at_rest = 0.6, kinetic = 0.3;
  Block block({kinetic, at_rest}, {0.0, 0.0, -9.81}, true);
  for (int k = 0; k < 500; ++k) block.step(Vec3::Zero());
  double most = 0.0, sum = 0.0;
  int slid = 0;
  for (int k = 0; k < 20000; ++k) {
    // A weak spring whose end moves on at 10 mm/s.
    const Wrench held = block.step({20.0 * (0.01 * k * kStep - block.state.position.x()), 0, 0});
    most = std::max(most, -held.force.x());
    if (!block.memory.entries.empty() && block.memory.entries[0].is_sliding) {
      sum -= held.force.x();
      ++slid;
    }
  }
  EXPECT_NEAR(most, at_rest * weight, 0.02 * at_rest * weight);
  ASSERT_GT(slid, 100);
  EXPECT_NEAR(sum / slid, kinetic * weight, 0.02 * kinetic * weight);
}

TEST(Bristle, NeverGivesMoreThanItWasGiven) {
  for (const Friction friction : {Friction{0.5, 0.5}, Friction{0.2, 0.8}}) {
    Random random(9);
    Block block(friction, {0.0, 0.0, -9.81}, true);
    double worst = 0.0, scale = 0.0;
    Vec3 push = Vec3::Zero();
    for (int k = 0; k < 20000; ++k) {
      if (k % 20 == 0) push = random.in_cube(0.6);
      Vec3 pull = push;
      pull.z() *= 0.5;  // presses and lifts
      const double kinetic_before = block.state.linear_momentum.head<2>().squaredNorm() / 0.1;
      const double bent_before = energy(block.memory);
      const Vec3 from = block.state.position;
      block.step(pull);
      const double kinetic_after = block.state.linear_momentum.head<2>().squaredNorm() / 0.1;
      const Vec3 way = block.state.position - from;
      const double put_in = pull.head<2>().dot(way.head<2>());
      worst = std::max(
          worst, kinetic_after - kinetic_before + energy(block.memory) - bent_before - put_in);
      scale = std::max(scale, kinetic_after);
    }
    EXPECT_LE(worst, 1e-12 * scale) << friction.at_rest;
    EXPECT_GT(scale, 0.0);
  }
}

TEST(Bristle, HoldsTheSameInEveryDirection) {
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.1 + 0.52 * k;
    Block block({0.4, 0.4}, {0.0, 0.0, -9.81});
    for (int i = 0; i < 300; ++i) block.step(Vec3::Zero());
    const Vec3 pull(std::cos(angle), std::sin(angle), 0.0);
    Wrench held;
    for (int i = 0; i < 200; ++i) held = block.step(pull);
    EXPECT_NEAR(held.force.dot(pull), -0.4 * 0.05 * 9.81, 0.01 * 0.4 * 0.05 * 9.81) << angle;
  }
}

}  // namespace
}  // namespace thigma
