// A haptic step of a body in a hand among others: bounded, and outside of all that the world has.

#include "thigma/multibody/hand_step.h"

#include <cmath>
#include <cstdio>

#include "multibody/held_bench.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::HeldBench;
using test::make_beside;

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
  HeldBench held;
  test::add_floor(held.bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.03, 0.02)));
  for (int i = 0; i < 5; ++i)
    held.bench.add(block, BodyKind::moving, Vec3(2e-3 * (i % 2), 0.0, 0.010002 + 0.020002 * i));
  held.bench.add(block, BodyKind::held, Vec3(0.0, 0.0, 0.110012));
  held.make(6);
  const Vec3 begin = held.hand.handle.pose.position;
  int cut = 0;
  for (int i = 0; i < 400; ++i) {  // pressed and rubbed to and fro
    held.hand.handle.pose.position =
        begin + Vec3(4e-3 * std::sin(0.3 * i), 3e-3 * std::sin(0.41 * i), -4e-3);
    held.step_world();
    held.look(5e-3);
    const BodyState before = held.body;
    const ConstrainedStep made = held.step();
    EXPECT_LE(held.memory.newton, kHandNewton);
    if (made.solution.is_whole) continue;
    EXPECT_TRUE(held.memory.is_cut_short);
    EXPECT_EQ(held.body.position, before.position);
    EXPECT_EQ(held.body.linear_momentum, Vec3(Vec3::Zero()));
    ++cut;
  }
  std::printf("%d of 400 steps cut short\n", cut);
  EXPECT_GT(cut, 0);
}

TEST(HandStep, ASolveTakesNoMoreFactorsThanAreLeft) {
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
