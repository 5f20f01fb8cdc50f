#include "benchmarks/baselines/bullet_world.h"

#include <cmath>

#include "benchmarks/baselines/bullet_baseline.h"
#include "benchmarks/world_bench.h"
#include <gtest/gtest.h>

namespace thigma::bench {
namespace {

TEST(BulletWorld, BoxesFallAndSlideInMetres) {
  if (!has_bullet()) GTEST_SKIP() << "without Bullet";
  const double unit = 0.04;
  BulletBox floor, falls, slides;
  floor.size = Vec3(4.0, 4.0, 0.02);
  floor.start.position.z() = -0.01;
  falls.size = slides.size = Vec3(0.06, 0.06, 0.02);
  falls.mass = slides.mass = 0.1;
  falls.start.position = Vec3(0.5, 0.0, 1.0);
  slides.start.position = Vec3(0.0, 0.0, 0.01);
  slides.velocity.x() = 1.0;
  const BulletBox boxes[] = {floor, falls, slides};
  const BulletWorldPtr world = make_bullet_world(boxes, Vec3(0.0, 0.0, -9.81), unit, 10);
  ASSERT_NE(world, nullptr);
  for (int i = 0; i < 200; ++i) step_bullet(*world, 1e-3);
  EXPECT_NEAR(bullet_pose(*world, 1).position.z(), 1.0 - 0.5 * 9.81 * 0.04, 2e-3);
  EXPECT_NEAR(bullet_speed(*world, 1), 9.81 * 0.2, 0.01);
  EXPECT_NEAR(bullet_pose(*world, 2).position.x(), 0.2 - 0.5 * 0.3 * 9.81 * 0.04, 5e-3);
}

TEST(WorldRows, MeasureBothEngines) {
  const std::vector<Row> rows = world_rows(true);
  ASSERT_EQ(rows.size(), 4u);
  for (const Row& row : rows) {
    EXPECT_GT(row.ours.p50, 0.0) << row.name;
    EXPECT_EQ(row.theirs.has_value(), has_bullet());
    EXPECT_FALSE(row.note.empty());
  }
}

}  // namespace
}  // namespace thigma::bench
