// The world about a body in a hand: what a model has of it, and where it ends.

#include "thigma/multibody/hand_model.h"

#include "multibody/held_bench.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::HeldBench;

/// A tower on a floor with a block in the hand on top, let to rest on it.
void make_tower(HeldBench& held, int blocks) {
  test::add_floor(held.bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.02)));
  for (int i = 0; i < blocks; ++i)
    held.bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.010002 + 0.020002 * i));
  held.bench.add(block, BodyKind::held, Vec3(0.0, 0.0, 0.010002 + 0.020002 * blocks));
  held.make(blocks + 1);
  for (int i = 0; i < 50; ++i) held.step_world();
}

TEST(HandModel, HasTheNextBodiesBreadthFirstAndTheRestAsTheBorder) {
  HeldBench held;
  make_tower(held, 10);
  held.look(1e-3);
  const HandModel& model = *held.model;
  // Of the tower the nearest are solved; the one below them goes as it goes.
  ASSERT_EQ(model.bodies.size(), static_cast<std::size_t>(kHandMovers) + 2);
  EXPECT_EQ(model.bodies[0].body, 11);
  for (std::int32_t i = 1; i <= kHandMovers; ++i) {
    EXPECT_EQ(model.bodies[static_cast<std::size_t>(i)].body, 11 - i);
    EXPECT_TRUE(model.bodies[static_cast<std::size_t>(i)].is_solved);
  }
  EXPECT_EQ(model.bodies.back().body, 10 - kHandMovers);
  EXPECT_FALSE(model.bodies.back().is_solved);
  EXPECT_EQ(model.pairs.size(), static_cast<std::size_t>(kHandMovers) + 1);
  bool presses = false;
  for (const HandRow& row : model.rows) presses = presses || row.impulse.x() > 0.0;
  EXPECT_TRUE(presses);  // as the world's last step left them
}

TEST(HandModel, HasAWholeIslandWhereThereIsRoom) {
  HeldBench held;
  make_tower(held, 3);
  held.look(1e-3);
  EXPECT_EQ(held.model->left_out, 0);
  ASSERT_EQ(held.model->bodies.size(), 5u);
  for (const HandBody& body : held.model->bodies) EXPECT_EQ(body.is_solved, body.body != 0);
}

TEST(HandModel, ABodyThatSleepsIsNotMoved) {
  HeldBench held;
  test::make_beside(held);
  held.bench.state.is_asleep[1] = 1;
  held.look(2e-3);
  ASSERT_EQ(held.model->bodies.size(), 2u);
  EXPECT_FALSE(held.model->bodies[1].is_solved);
}

TEST(HandModel, IsBoundedAmongMoreBodiesThanThereIsRoomFor) {
  HeldBench held;
  const auto block = test::body_mesh(make_box(Vec3(0.008, 0.008, 0.008)));
  for (int i = -3; i <= 3; ++i)
    for (int k = -3; k <= 3; ++k)
      held.bench.add(block, BodyKind::fixed, Vec3(0.01 * i, 0.01 * k, -0.0045));
  held.bench.add(test::body_mesh(make_box(Vec3(0.06, 0.06, 0.01))), BodyKind::held,
                 Vec3(0.0, 0.0, 0.0052));
  held.make(49);
  held.step_world();
  held.body = held.bench.state.bodies[49];
  held.look(5e-3);
  EXPECT_GT(held.model->left_out, 0);
  EXPECT_EQ(held.model->bodies.size(), static_cast<std::size_t>(kHandBodies));
  EXPECT_LT(held.model->room, 1e-3);
  // No new model: however hard it is pressed and turned, nothing is entered.
  for (int i = 0; i < 200; ++i) {
    held.hand.handle.pose.position = Vec3(2e-5 * i, 0.0, 0.0052 - 2e-5 * i);
    held.hand.handle.pose.orientation = Quat(Eigen::AngleAxisd(1e-3 * i, Vec3::UnitX()));
    held.step();
    EXPECT_LE(held.memory.rows, kHandRows);
    EXPECT_LE(held.memory.newton, kHandNewton);
    if (i % 10 == 0) {
      ASSERT_GT(held.least_distance(), 0.0) << i;
    }
  }
}

}  // namespace
}  // namespace thigma
