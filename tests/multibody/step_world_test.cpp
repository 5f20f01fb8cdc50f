#include "thigma/multibody/step_world.h"

#include <cmath>

#include <gtest/gtest.h>

#include "multibody/world_bench.h"

namespace thigma {
namespace {

using test::WorldBench;

TEST(StepWorld, BlockFallsAndRests) {
  WorldBench bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.05));
  bench.make();
  for (int i = 0; i < 1500; ++i) {
    const WorldStep s = bench.step();
    if (i % 50 == 0 || s.impacts || !s.is_whole || s.waited > 0)
      std::printf("%d z %.9f e %.9g pressing %d parts %d newton %d queries %d awake %d res %g\n", i,
                  bench.state.bodies[1].position.z(), bench.energy(), s.pressing, s.parts, s.newton,
                  (int)s.queries, s.awake, s.residual);
  }
}

TEST(StepWorld, Tower) {
  WorldBench bench;
  test::add_floor(bench);
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.02)));
  for (int i = 0; i < 30; ++i)
    bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.01 + 2e-6 + i * (0.02 + 2e-6)));
  bench.make();
  bench.world.sleeps = false;
  const WorldState start = bench.state;
  const double e0 = bench.energy();
  for (int i = 0; i < 3000; ++i) {
    const WorldStep s = bench.step();
    double drift = 0;
    for (int k = 1; k <= 30; ++k)
      drift = std::max(drift, (bench.state.bodies[k].position - start.bodies[k].position).norm());
    if (i < 20 || i % 500 == 0 || !s.is_whole || s.waited > 0)
      std::printf("%d drift %g de %.3g pressing %d rows %d parts %d newton %d queries %d res %g gap %g\n", i, drift,
                  bench.energy() - e0, s.pressing, (int)s.rows, s.parts, s.newton, (int)s.queries, s.residual, s.least_gap);
  }
}

}  // namespace
}  // namespace thigma
