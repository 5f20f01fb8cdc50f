#include "thigma/scene/world_change.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

const std::string kScene = R"(
gravity = [0.0, 0.0, -9.81]
[object]
name = "tool"
mesh = "procedural:box?triangles=12"
unit_scale = 0.2
position = [0.0, 0.0, 0.3]
density = 500.0
[[static]]
name = "table"
mesh = "procedural:box?triangles=12"
unit_scale = 10.0
position = [0.0, 0.0, -0.2]
[[body]]
name = "block"
mesh = "procedural:box?triangles=12"
unit_scale = 0.5
position = [0.0, 0.0, 0.0100021]
copies = 2
spacing = [0.1, 0.0, 0.0]
density = 600.0
[[body]]
name = "lid"
mesh = "procedural:box?triangles=12"
unit_scale = 0.5
position = [0.3, 0.0, 0.1]
density = 600.0
[[joint]]
name = "pin"
kind = "hinge"
body = "lid"
position = [0.27, 0.0, 0.1]
axis = [0.0, 1.0, 0.0]
)";

LoadedWorld loaded() { return load_world(parse_world_scene(kScene, "w.toml", "")); }

std::string why(const std::function<void()>& change) {
  try {
    change();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// The world's state after some steps.
WorldState moved(const LoadedWorld& world, int steps) {
  WorldState state = world.config.start;
  const WorldScratchPtr scratch = reserve_world(world.config.world);
  for (int i = 0; i < steps; ++i) step_world(world.config.world, {}, 1e-3, state, *scratch);
  return state;
}

TEST(WorldChange, AnotherBodyStandsAboveAllAndTheOthersGoOn) {
  const LoadedWorld world = loaded();
  const WorldState before = moved(world, 50);
  const WorldChange change = with_another(world, 2, std::nullopt, before);
  const World& w = change.world.config.world;
  ASSERT_EQ(w.bodies.size(), 6u);
  EXPECT_EQ(w.bodies[5].name, "block 3");
  EXPECT_EQ(change.was, (std::vector<std::int32_t>{0, 1, 2, 3, 4, -1}));
  EXPECT_EQ(w.shapes.size(), world.config.world.shapes.size());  // no new one
  EXPECT_EQ(change.world.meshes[5], world.meshes[2]);
  const WorldState state = carried_state(change, before);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(state.bodies[i].position, before.bodies[i].position);
    EXPECT_EQ(state.bodies[i].linear_momentum, before.bodies[i].linear_momentum);
  }
  EXPECT_EQ(state.time, before.time);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_GT(state.bodies[5].position.z(), before.bodies[i].position.z());
  // The same way on as without it, while it is far away.
  WorldState with = state, alone = before;
  const WorldScratchPtr a = reserve_world(w), b = reserve_world(world.config.world);
  for (int i = 0; i < 50; ++i) {
    step_world(w, {}, 1e-3, with, *a);
    step_world(world.config.world, {}, 1e-3, alone, *b);
  }
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR((with.bodies[i].position - alone.bodies[i].position).norm(), 0.0, 1e-9);
}

TEST(WorldChange, WhatCannotComeIsRefusedByName) {
  const LoadedWorld world = loaded();
  const WorldState& start = world.config.start;
  const WorldChange inside = with_another(world, 2, Vec3(0.0, 0.0, 0.02), start);
  const std::string said = why([&] { carried_state(inside, start); });
  EXPECT_NE(said.find("body 'block 3'"), std::string::npos) << said;
  EXPECT_NE(said.find("inside body 'block 1'"), std::string::npos) << said;
  const WorldChange swallowed = with_another(world, 2, Vec3(0.0, 0.0, -0.2), start);
  const std::string within = why([&] { carried_state(swallowed, start); });
  EXPECT_NE(within.find("body 'block 3': starts inside body 'table'"), std::string::npos) << within;
  EXPECT_NE(why([&] { with_another(world, 1, std::nullopt, start); }).find("'table'"),
            std::string::npos);
  const std::string far = why([&] { with_another(world, 2, Vec3(0.0, 0.0, 1e30), start); });
  EXPECT_NE(far.find("body 'block 3': position"), std::string::npos) << far;
  EXPECT_EQ(why([&] { with_another(world, 2, Vec3(0.0, 0.0, 100.0), start); }), "");
}

TEST(WorldChange, WithoutABodyJointsAndHandsHaveItsNumbersBehindIt) {
  const LoadedWorld world = loaded();
  const WorldState before = moved(world, 20);
  const WorldChange change = without(world, 2);
  const World& w = change.world.config.world;
  ASSERT_EQ(w.bodies.size(), 4u);
  EXPECT_EQ(w.bodies[2].name, "block 2");
  EXPECT_EQ(change.world.description.bodies[2].object.name, "block 2");
  EXPECT_EQ(w.joints[0].a, 3);  // the lid
  EXPECT_EQ(change.world.config.hands[0].body, 0);
  const WorldState state = carried_state(change, before);
  EXPECT_EQ(state.bodies[2].position, before.bodies[3].position);
  EXPECT_EQ(state.bodies[3].angular_momentum, before.bodies[4].angular_momentum);
  EXPECT_NE(why([&] { without(world, 4); }).find("joint 'pin'"), std::string::npos);
  EXPECT_NE(why([&] { without(world, 0); }).find("held"), std::string::npos);
  EXPECT_NE(why([&] { without(world, 1); }).find("stands still"), std::string::npos);
}

}  // namespace
}  // namespace thigma
