#include "thigma/multibody/island_solve.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "thigma/dynamics/row_solve.h"
#include "thigma/math/random.h"
#include "thigma/multibody/detail/multiplier_drift.h"

namespace thigma {
namespace {

Vec3 any(Random& random) { return {random.normal(), random.normal(), random.normal()}; }

struct RandomIsland {
  std::vector<IslandBody> bodies;
  std::vector<IslandRow> rows;
};

/// A chain of bodies with random rows between neighbours and against what does not move.
RandomIsland random_island(Random& random, int bodies, int rows, double friction) {
  RandomIsland island;
  for (int i = 0; i < bodies; ++i) {
    IslandBody body;
    const double mass = std::pow(10.0, random.uniform(-1.0, 1.0));
    body.metric = mass * Mat6::Identity();
    body.metric.bottomRightCorner<3, 3>() *= 1e-3;
    body.free << any(random), 10.0 * any(random);
    island.bodies.push_back(body);
  }
  for (int i = 0; i < rows; ++i) {
    IslandRow row;
    row.a = static_cast<std::int32_t>(random.uniform() * bodies);
    row.b = row.a + 1 < bodies && random.uniform() < 0.7 ? row.a + 1 : -1;
    if (random.uniform() < 0.3) std::swap(row.a, row.b);
    row.normal = any(random).normalized();
    row.first = row.normal.cross(any(random)).normalized();
    row.arm_a = 0.03 * any(random);
    row.arm_b = 0.03 * any(random);
    row.limit = random.uniform() < 0.5 ? 0.0 : random.uniform();
    row.friction = friction;
    island.rows.push_back(row);
    if (random.uniform() < 0.2) island.rows.push_back(row);  // twice
  }
  return island;
}

IslandScratch scratch_for(const RandomIsland& island) {
  IslandScratch scratch;
  reserve_island(island.bodies.size(), island.rows.size(), scratch);
  return scratch;
}

Vec3 speed_of(const RandomIsland& island, const IslandRow& row) {
  Vec3 w = Vec3::Zero();
  const auto at = [&](std::int32_t body, const Vec3& arm) -> Vec3 {
    const Vec6& u = island.bodies[static_cast<std::size_t>(body)].velocity;
    const Vec3 turn = u.tail<3>();
    return u.head<3>() + turn.cross(arm);
  };
  if (row.a >= 0) w += at(row.a, row.arm_a);
  if (row.b >= 0) w -= at(row.b, row.arm_b);
  return {row.normal.dot(w), row.first.dot(w), row.normal.cross(row.first).dot(w)};
}

TEST(IslandSolve, OneBodyGoesAsRowSolveSays) {
  Random random(1);
  for (int k = 0; k < 50; ++k) {
    RandomIsland island = random_island(random, 1, 12, 0.0);
    for (IslandRow& row : island.rows)
      if (row.a < 0) {  // the same from the other side
        std::swap(row.a, row.b);
        std::swap(row.arm_a, row.arm_b);
        row.normal = -row.normal;
      }
    auto rows = std::make_unique<VelocityRows>();
    rows->count = static_cast<int>(island.rows.size());
    for (std::size_t i = 0; i < island.rows.size(); ++i) {
      const IslandRow& row = island.rows[i];
      Vec6 g;
      g << row.normal, row.arm_a.cross(row.normal);
      for (std::size_t c = 0; c < 6; ++c) rows->gradient[c][i] = g[static_cast<Eigen::Index>(c)];
      rows->limit[i] = row.limit;
      rows->friction[i] = {};
    }
    auto impulses = std::make_unique<RowImpulses>();
    const RowSolution expected =
        solve_rows(island.bodies[0].metric, island.bodies[0].free, *rows, *impulses);
    IslandScratch scratch = scratch_for(island);
    const IslandSolution found = solve_island(island.bodies, island.rows, scratch);
    EXPECT_TRUE(found.is_whole);
    EXPECT_LT((island.bodies[0].velocity - expected.velocity).norm(),
              1e-7 * island.bodies[0].free.norm())
        << k;
  }
}

/// What Signorini and Coulomb ask of a solution.
void check_law(const RandomIsland& island, double speed) {
  double most = 0.0;
  for (const IslandRow& row : island.rows) most = std::max(most, row.impulse.x());
  for (const IslandRow& row : island.rows) {
    const Vec3 w = speed_of(island, row);
    EXPECT_LE(w.x(), row.limit + 1e-7 * speed);
    EXPECT_GE(row.impulse.x(), 0.0);
    if (row.impulse.x() > 1e-6 * most) {
      EXPECT_NEAR(w.x(), row.limit, 1e-6 * speed);
    }
    const Vec2 held(row.impulse.y(), row.impulse.z()), slip(w.y(), w.z());
    EXPECT_LE(held.norm(), row.friction * row.impulse.x() + 1e-6 * most);
    EXPECT_GE(held.dot(slip), -1e-7 * most * speed);  // never drives
    if (held.norm() < row.friction * row.impulse.x() - 1e-5 * most) {
      EXPECT_LT(slip.norm(), 1e-6 * speed);  // sticks
    }
    if (slip.norm() > 1e-4 * speed && row.impulse.x() > 1e-4 * most && row.friction > 0.0) {
      EXPECT_GT(held.dot(slip), 0.999 * held.norm() * slip.norm());  // against it
    }
  }
}

TEST(IslandSolve, ObeysSignoriniAndCoulomb) {
  Random random(2);
  int unsettled = 0;
  for (int k = 0; k < 200; ++k) {
    const int bodies = 1 + k % 8;
    RandomIsland island = random_island(random, bodies, 3 * bodies, k % 2 == 0 ? 0.0 : 0.4);
    double speed = 0.0;
    for (const IslandBody& body : island.bodies) speed = std::max(speed, body.free.norm());
    IslandScratch scratch = scratch_for(island);
    const IslandSolution found = solve_island(island.bodies, island.rows, scratch);
    EXPECT_TRUE(found.is_whole) << k;
    if (found.unsettled > 1e-6)
      ++unsettled;
    else
      check_law(island, speed);
  }
  EXPECT_LE(unsettled, 4);
  RecordProperty("unsettled", unsettled);
}

TEST(IslandSolve, TakesFromOneBodyWhatItGivesTheOther) {
  Random random(5);
  RandomIsland island = random_island(random, 6, 30, 0.5);
  for (IslandRow& row : island.rows) {
    if (row.b < 0) row.b = row.a == 0 ? 1 : row.a - 1;
    if (row.a < 0) row.a = row.b == 0 ? 1 : row.b - 1;
  }
  IslandScratch scratch = scratch_for(island);
  solve_island(island.bodies, island.rows, scratch);
  Vec3 sum = Vec3::Zero();
  double size = 0.0;
  for (const IslandBody& body : island.bodies) {
    sum += body.impulse.head<3>();
    size += body.impulse.head<3>().norm();
    const Vec6 expected = body.free + body.metric.inverse() * body.impulse;
    EXPECT_LT((body.velocity - expected).norm(), 1e-13 * (1.0 + expected.norm()));
  }
  EXPECT_GT(size, 0.0);
  EXPECT_LT(sum.norm(), 1e-14 * size);
}

TEST(IslandSolve, NeverAddsEnergy) {
  Random random(9);
  for (int k = 0; k < 100; ++k) {
    RandomIsland island = random_island(random, 1 + k % 5, 15, 0.8);
    IslandScratch scratch = scratch_for(island);
    solve_island(island.bodies, island.rows, scratch);
    double before = 0.0, after = 0.0;
    for (const IslandBody& body : island.bodies) {
      before += body.free.dot(body.metric * body.free);
      after += body.velocity.dot(body.metric * body.velocity);
    }
    EXPECT_LE(after, before * (1.0 + 1e-9)) << k;
  }
}

TEST(IslandSolve, SaysWhereRowsContradictEachOther) {
  RandomIsland island;
  island.bodies.resize(1);
  for (const double side : {1.0, -1.0}) {
    IslandRow row;
    row.a = 0;
    row.normal = side * Vec3::UnitZ();
    row.limit = -0.1;
    island.rows.push_back(row);
  }
  IslandScratch scratch = scratch_for(island);
  EXPECT_FALSE(solve_island(island.bodies, island.rows, scratch).is_whole);
  for (IslandRow& row : island.rows) row.limit = 0.0;
  EXPECT_TRUE(solve_island(island.bodies, island.rows, scratch).is_whole);
}

/// A body that hangs on two places of nearly one arm, whose normals lean to either side: with
/// friction they hold each freedom twice.
RandomIsland hung_on_two(Random& random) {
  RandomIsland island;
  IslandBody body;
  body.metric = Mat6::Identity();
  body.metric.bottomRightCorner<3, 3>() *= 1e-4;
  body.free << 1e-3 * any(random), 1e-2 * any(random);
  body.free.z() = 0.01;
  island.bodies.push_back(body);
  const Vec3 arm(1e-5 * random.normal(), 1e-5 * random.normal(), 0.0136);
  for (const double lean : {-0.06, 0.06 + 0.01 * random.uniform()}) {
    IslandRow row;
    row.a = 0;
    row.normal = Vec3(0.004 * random.normal(), lean, 1.0).normalized();
    row.first = row.normal.cross(Vec3::UnitX()).normalized();
    row.arm_a = arm + 1e-7 * any(random);
    row.friction = 0.2;
    island.rows.push_back(row);
  }
  return island;
}

TEST(IslandSolve, RowsThatShareALoadSettleInFewRounds) {
  Random random(14);
  int rounds = 0;
  double beyond = 0.0;  // the cone, of the normal impulses
  for (int k = 0; k < 100; ++k) {
    RandomIsland island = hung_on_two(random);
    IslandScratch scratch = scratch_for(island);
    solve_island(island.bodies, island.rows, scratch);
    // The next step: what pressed is where the load was, not where it goes.
    island.bodies[0].free.head<3>() += 1e-4 * any(random);
    const IslandSolution found = solve_island(island.bodies, island.rows, scratch);
    EXPECT_TRUE(found.is_whole) << k;
    rounds += found.rounds;
    double normal = 0.0;
    for (const IslandRow& row : island.rows) normal += row.impulse.x();
    for (const IslandRow& row : island.rows) {
      const double held = row.impulse.tail<2>().norm();
      beyond = std::max(beyond, (held - row.friction * row.impulse.x()) / normal);
      EXPECT_LT(speed_of(island, row).x(), 1e-7 * island.bodies[0].free.norm()) << k;
    }
  }
  EXPECT_LT(rounds, 700);  // 1,346 where they go on as long as shares change
  EXPECT_LT(beyond, 0.05);
  RecordProperty("rounds", rounds);
}

/// Of a load on two rows, what one gives the other in each round.
TEST(IslandSolve, SharesGoOnToTheirBound) {
  std::vector<IslandRow> rows(2);
  rows[0].impulse = {3.0, 0.0, 0.0};
  rows[1].impulse = {1.0, 0.1, 0.0};
  rows[0].friction = rows[1].friction = 0.5;
  const std::vector<double> weight{1.0, 1.0};
  const detail::Multipliers now{rows, {}, weight, {}};
  const auto steps = [&](const std::vector<Vec3>& last, const std::vector<Vec3>& before) {
    return detail::changes_to_bound(now, {last, {}}, {before, {}});
  };
  const std::vector<Vec3> gives{{-1e-3, 0.0, 0.0}, {1e-3, 0.0, 0.0}};
  EXPECT_NEAR(steps(gives, gives), 3000.0, 1e-6);
  // friction that grows faster than its bound: 0.1 + 2e-3 t = 0.5 (1 + 1e-3 t)
  std::vector<Vec3> slides = gives;
  slides[1].y() = 2e-3;
  EXPECT_NEAR(steps(slides, slides), 0.4 / 1.5e-3, 1e-6);
  // two ways, and one that nothing ends
  EXPECT_EQ(steps(gives, slides), 0.0);
  const std::vector<Vec3> grows{{1e-3, 0.0, 0.0}, {1e-3, 0.0, 0.0}};
  EXPECT_EQ(steps(grows, grows), 0.0);
}

TEST(IslandSolve, EndsWhateverItIsAsked) {
  Random random(15);
  for (const double far : {1e3, 1e30, 1e160, std::nan("")}) {
    RandomIsland island = hung_on_two(random);
    island.bodies[0].free *= far;
    IslandScratch scratch = scratch_for(island);
    const IslandSolution found = solve_island(island.bodies, island.rows, scratch);
    EXPECT_LE(found.rounds, 60) << far;
    EXPECT_LE(found.newton, 60 * 40 + 12) << far;
  }
}

TEST(IslandSolve, WarmStartNeedsLess) {
  Random random(6);
  RandomIsland island = random_island(random, 8, 40, 0.3);
  IslandScratch scratch = scratch_for(island);
  const IslandSolution cold = solve_island(island.bodies, island.rows, scratch);
  const Vec6 velocity = island.bodies[3].velocity;
  const IslandSolution warm = solve_island(island.bodies, island.rows, scratch);
  EXPECT_LT(warm.newton, cold.newton);
  EXPECT_LT((island.bodies[3].velocity - velocity).norm(), 1e-6 * velocity.norm());
}

}  // namespace
}  // namespace thigma
