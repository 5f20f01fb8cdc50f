// Levels of detail far away: what is felt is exact, and nothing is passed.
#include <cmath>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/math/random.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma {
namespace {

using test::BodyMesh;
using test::WorldBench;

std::shared_ptr<BodyMesh> with_levels(const TriangleMesh& mesh) {
  auto made = test::body_mesh(mesh);
  made->hierarchy = build_clod(mesh);
  return made;
}

/// Three bodies thrown at each other over a floor with levels of its own.
struct Thrown {
  WorldBench bench;
  std::int64_t coarse = 0;
  int pressing = 0, coarse_pressing = 0;  // rows that pressed in a step
  double waited = 0.0, least = 1.0, gained = 0.0;

  Thrown(const std::vector<std::shared_ptr<BodyMesh>>& meshes, std::uint64_t seed,
         double threshold) {
    Random random(seed);
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      WorldBody& body =
          bench.add(meshes[i], i == 0 ? BodyKind::fixed : BodyKind::moving,
                    i == 0 ? Vec3(0.0, 0.0, -0.05) : Vec3(0.13 * double(i) - 0.26, 0.0, 0.12),
                    i == 0 ? Quat::Identity() : random.orientation());
      if (i == 0) continue;
      const double speed = random.uniform(0.2, 3.0);
      body.start.linear_momentum =
          body.mass * speed * Vec3(2.0 - double(i), 0.1 * random.normal(), -0.6);
      body.start.angular_momentum = body.inertia * (15.0 * random.direction());
    }
    bench.make();
    bench.world.threshold = threshold;
    bench.scratch = reserve_world(bench.world);
  }

  void count_pressing() {
    for (const detail::NearPair* pair : bench.scratch->pairs.near) {
      for (std::size_t i = 0; i < pair->history.size(); ++i) {
        if (!(pair->history[i].impulse.x() > 0.0)) continue;
        ++(detail::is_coarse_row(pair->model.rows[i]) ? coarse_pressing : pressing);
      }
    }
  }

  void run(int steps) {
    const double start = bench.energy();
    for (int i = 0; i < steps; ++i) {
      const WorldStep step = bench.step();
      coarse += step.coarse;
      count_pressing();
      waited += step.waited;
      gained = std::max(gained, bench.energy() - start);
      if (i % 5 != 0) continue;
      for (std::size_t a = 0; a < bench.bodies.size(); ++a)
        for (std::size_t b = a + 1; b < bench.bodies.size(); ++b)
          least = std::min(least, bench.distance(a, b));
    }
  }
};

/// Built once: they are never changed.
const std::vector<std::shared_ptr<BodyMesh>>& meshes_with_levels() {
  static const std::vector<std::shared_ptr<BodyMesh>> meshes = {
      with_levels(make_box(Vec3(1.0, 1.0, 0.1), {16, 16, 2})),
      with_levels(make_torus(0.045, 0.015, 48, 24)), with_levels(make_ball(0.04, 10)),
      with_levels(make_torus(0.05, 0.01, 48, 24))};
  return meshes;
}

TEST(WorldLevels, NothingIsPassedAndEnergyNeverGrows) {
  const auto& meshes = meshes_with_levels();
  std::int64_t coarse = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Thrown thrown(meshes, seed, 0.025);
    thrown.run(200);
    coarse += thrown.coarse;
    EXPECT_GT(thrown.least, 0.0) << seed;
    EXPECT_EQ(thrown.waited, 0.0) << seed;
    EXPECT_EQ(thrown.coarse_pressing, 0) << seed;
    EXPECT_GT(thrown.pressing, 0) << seed;
    EXPECT_LE(thrown.gained, 1e-9) << seed;
  }
  EXPECT_GT(coarse, 100);
}

TEST(WorldLevels, AreAskedForAndTheSameEveryTime) {
  const auto& meshes = meshes_with_levels();
  Thrown exact(meshes, 3, 0.0), one(meshes, 3, 0.025), other(meshes, 3, 0.025);
  for (Thrown* thrown : {&exact, &one, &other}) thrown->run(150);
  EXPECT_EQ(exact.coarse, 0);
  EXPECT_GT(one.coarse, 0);
  for (std::size_t i = 1; i < meshes.size(); ++i) {
    EXPECT_EQ(one.bench.state.bodies[i].position, other.bench.state.bodies[i].position);
    EXPECT_EQ(one.bench.state.bodies[i].angular_momentum,
              other.bench.state.bodies[i].angular_momentum);
  }
}

TEST(WorldLevels, WhatRestsIsHeldByExactRows) {
  // A ring flat on a finely cut floor rests where it does without levels.
  const auto& meshes = meshes_with_levels();
  double heights[2];
  for (const int turn : {0, 1}) {
    WorldBench bench;
    bench.add(meshes[0], BodyKind::fixed, Vec3(0.0, 0.0, -0.05));
    bench.add(meshes[1], BodyKind::moving, Vec3(0.011, 0.017, 0.0153));
    bench.make();
    bench.world.threshold = turn == 0 ? 0.0 : 0.025;
    bench.scratch = reserve_world(bench.world);
    for (int i = 0; i < 400; ++i) bench.step();
    heights[turn] = bench.state.bodies[1].position.z();
  }
  EXPECT_NEAR(heights[1], heights[0], 1e-7);
}

}  // namespace
}  // namespace thigma
