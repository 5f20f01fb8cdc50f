// A haptic step of a body in a hand among others: bounded, and outside of all that the world has.

#include "thigma/multibody/hand_step.h"

#include "multibody/held_bench.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::HeldBench;
using test::make_beside;

TEST(HandStep, WhereTheWorldHasSomethingTheBodyGoesBackByNoMoreThanItMust) {
  for (const double into : {1e-5, 1e-3}) {
    HeldBench held;
    make_beside(held);
    held.step_world();
    held.body = held.bench.state.bodies[2];
    held.body.position.x() += 0.5e-3 + into;
    EXPECT_EQ(held.least_distance(), 0.0);
    const double before = held.body.position.x();
    const HandCorrection correction = held.look(2e-3);
    EXPECT_GT(held.least_distance(), 0.0) << into;
    EXPECT_LT(held.least_distance(), 1e-6) << into;
    EXPECT_NEAR(correction.way, before - held.body.position.x(), 1e-12);
    EXPECT_NEAR(correction.way, into, 1e-6 + 1e-3 * into);
  }
}

TEST(HandStep, WhereNothingIsTheBodyStaysWhereItIs) {
  HeldBench held;
  make_beside(held);
  held.step_world();
  held.body = held.bench.state.bodies[2];
  held.body.position.x() -= 1e-4;
  const BodyState before = held.body;
  EXPECT_EQ(held.look(2e-3).way, 0.0);
  EXPECT_EQ(held.body.position, before.position);
  EXPECT_EQ(held.body.orientation.coeffs(), before.orientation.coeffs());
}

TEST(HandStep, GoesWithItsNeighbourForOneStepOfTheWorldAndThenStandsBeforeIt) {
  HeldBench held;
  make_beside(held);
  const auto push = [&] {
    held.hand.handle.pose.position.x() += 1e-4;
    held.hand.handle.twist.linear.x() = 0.1;
  };
  for (int i = 0; i < 60; ++i) {  // pushes the block
    push();
    held.step_world();
    held.look(1e-3);
  }
  held.body = held.bench.state.bodies[2];
  held.look(1e-3);
  ASSERT_EQ(held.model->bodies[1].body, 1);
  ASSERT_TRUE(held.model->bodies[1].is_solved);
  const double block = held.memory.states[1].position.x(), begin = held.body.position.x();
  push();
  held.step();
  const double way = held.body.position.x() - begin;
  EXPECT_NEAR(way, 1e-4, 1e-5);
  EXPECT_NEAR(held.memory.states[1].position.x() - block, way, 1e-6);  // before it
  for (int i = 0; i < 20; ++i) {
    push();
    held.step();
  }
  EXPECT_NEAR(held.body.position.x() - begin, way, 5e-6);
  EXPECT_EQ(held.memory.bodies, 1);
}

TEST(HandStep, WaitsWhereFactorsRunOut) {
  // As many rows of friction as a step takes, pressed against each other from all sides.
  HeldBench held;
  make_beside(held);
  held.step_world();
  held.look(2e-3);
  held.step_scratch.solve.newton_left = 0;
  IslandBody body;
  body.free << 0.1, 0.0, 0.0, 0.0, 0.0, 0.0;
  IslandRow row;
  row.a = 0;
  row.normal = Vec3::UnitX();
  const IslandSolution none = solve_island({&body, 1}, {&row, 1}, held.step_scratch.solve);
  EXPECT_FALSE(none.is_whole);
  EXPECT_EQ(none.newton, 0);
  held.step_scratch.solve.newton_left = 30;
  const IslandSolution some = solve_island({&body, 1}, {&row, 1}, held.step_scratch.solve);
  EXPECT_TRUE(some.is_whole);
  EXPECT_EQ(held.step_scratch.solve.newton_left, 30 - some.newton);
}

}  // namespace
}  // namespace thigma
