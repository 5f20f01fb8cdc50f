#include "thigma/multibody/world_rows.h"

#include <cmath>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/multibody/detail/pair_kinds.h"

namespace thigma {
namespace {

// A block at rest on a floor: rows at its corners bear its weight, and say where.
TEST(WorldRows, SayWhatKeepsABlockOnItsFloor) {
  test::WorldBench bench;
  test::add_floor(bench);
  bench.add(test::body_mesh(make_box(Vec3(0.04, 0.04, 0.02))), BodyKind::moving,
            Vec3(0.1, -0.05, 0.01));
  bench.make();
  bench.world.sleeps = false;
  const double slop = bench.world.pair_kinds->list.back().constraints.slop;
  bench.state.bodies[1].position.z() += slop;
  for (int i = 0; i < 50; ++i) bench.step();
  std::vector<WorldRow> rows;
  const std::size_t all = read_rows(bench.state, *bench.scratch, 1e-3, 64, rows);
  ASSERT_EQ(all, rows.size());
  ASSERT_GE(rows.size(), 4u);
  Vec3 on_block = Vec3::Zero();
  bool pressed = true;
  for (const WorldRow& row : rows) {
    EXPECT_GE(pressed, row.presses());  // those that press come first
    pressed = row.presses();
    const bool is_block = row.a == 1;
    EXPECT_EQ(is_block ? row.b : row.a, 0);
    const Vec3 out = is_block ? row.normal : Vec3(-row.normal);  // of the block
    EXPECT_NEAR(out.z(), -1.0, 1e-9);
    on_block += is_block ? row.force : Vec3(-row.force);
    const Vec3 block = is_block ? row.point : Vec3(row.point + row.gap * row.normal);
    EXPECT_NEAR(std::fabs(block.x() - 0.1), 0.02, 1e-6);
    EXPECT_NEAR(std::fabs(block.y() + 0.05), 0.02, 1e-6);
    EXPECT_NEAR(block.z(), slop, 1e-6 * slop + 1e-12);
    EXPECT_NEAR(row.gap, slop, 1e-3 * slop);
    EXPECT_EQ(row.friction, 0.3);
  }
  const double weight = bench.world.bodies[1].mass * 9.81;
  EXPECT_NEAR(on_block.z(), weight, 1e-6 * weight);
  EXPECT_LT(on_block.head<2>().norm(), 1e-6 * weight);
  EXPECT_EQ(read_rows(bench.state, *bench.scratch, 1e-3, 2, rows), all);
  EXPECT_EQ(rows.size(), 2u);
  EXPECT_TRUE(rows[0].presses());
}

}  // namespace
}  // namespace thigma
