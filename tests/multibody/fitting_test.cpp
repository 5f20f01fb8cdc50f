// Bodies whose surfaces fit each other: hundreds of rows near, few for the solver, none entered.

#include "experiments/common/outside_depth.h"
#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/multibody/detail/row_cut.h"

namespace thigma {
namespace {

using test::WorldBench;

constexpr double kRingHeight = 0.012, kFall = 1e-4;  // [m]

/// Rings of 5,000 triangles on each other, the last leaning.
void add_rings(WorldBench& bench, int count) {
  test::add_floor(bench);
  const auto ring = test::body_mesh(make_torus(0.04, 0.006, 64, 39));
  for (int i = 0; i < count; ++i) {
    const bool is_last = i + 1 == count;
    const Quat turn(Eigen::AngleAxisd(is_last ? 0.05 : 0.0, Vec3::UnitX()));
    const double lift = is_last ? 0.003 : 0.0;
    bench.add(ring, BodyKind::moving,
              Vec3(0.0, 0.0, (i + 0.5) * kRingHeight + (i + 1) * kFall + lift), turn);
  }
  bench.make();
}

TEST(FittingBodies, RingsStandOnEachOtherAndNoneEnters) {
  WorldBench bench;
  constexpr int kRings = 3;
  add_rings(bench, kRings);
  std::vector<experiments::DepthSurface> surfaces;
  for (const test::BodyMesh* mesh : bench.of)
    surfaces.push_back(experiments::make_depth_surface(mesh->mesh));
  // Numbered from the floor: a body and the one that it lies on.
  const auto depth = [&](std::size_t body) {
    const Pose world_from_below = bench.world_from_mesh(body - 1);
    const auto back = world_from_below.orientation.conjugate();
    const Pose mesh = bench.world_from_mesh(body);
    const Pose relative{back._transformVector(mesh.position - world_from_below.position),
                        (back * mesh.orientation).normalized()};
    return experiments::outside_depth(surfaces[body], relative, surfaces[body - 1], 4);
  };
  std::int64_t most_rows = 0;
  std::int32_t most_handed = 0, most_pressing = 0;
  double energy = bench.energy();
  for (int i = 0; i < 300; ++i) {
    const WorldStep step = bench.step();
    most_rows = std::max(most_rows, step.rows / std::max(step.pairs, 1));
    most_handed = std::max(most_handed, step.most_handed);
    most_pressing = std::max(most_pressing, step.pressing);
    ASSERT_EQ(step.waited, 0.0) << i;
    ASSERT_LE(bench.energy(), energy + 1e-9 * std::fabs(energy)) << i;
    energy = bench.energy();
    if (i % 25 != 24) continue;
    for (std::size_t body = 1; body <= kRings; ++body) EXPECT_EQ(depth(body), 0.0) << i;
  }
  EXPECT_GT(most_rows, 2 * detail::kMostHanded) << "they do not fit each other";
  EXPECT_GT(most_pressing, 0);
  EXPECT_LE(most_handed, detail::kMostHanded);
  for (std::size_t body = 1; body <= kRings; ++body)
    EXPECT_NEAR(bench.state.bodies[body].position.z(), (double(body) - 0.5) * kRingHeight, 1e-4);
}

TEST(FittingBodies, RestingRingsFallAsleepAndCostNoQuery) {
  WorldBench bench;
  add_rings(bench, 2);
  WorldStep step;
  for (int i = 0; i < 3000 && (i == 0 || step.awake > 0); ++i) step = bench.step();
  EXPECT_EQ(step.awake, 0);
  step = bench.step();
  EXPECT_EQ(step.queries, 0);
  EXPECT_EQ(step.rows, 0);
  EXPECT_EQ(step.handed, 0);
}

}  // namespace
}  // namespace thigma
