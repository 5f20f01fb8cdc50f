#include "thigma/multibody/detail/row_cut.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma::detail {
namespace {

constexpr int kRows = 200;  // of a pair
constexpr double kRadius = 0.04;

/// A stack of rings: each row is a place where one lies on the next, on a bowl that is not flat, so
/// that which rows press changes with the load.
struct Stack {
  std::vector<IslandBody> bodies;
  std::vector<IslandRow> rows;
  std::vector<RowSource> sources;
};

Stack make_stack(int count, double friction, Random& random) {
  Stack stack;
  for (int i = 0; i < count; ++i) {
    IslandBody body;
    body.metric = Mat6::Identity() * 0.1;
    body.metric.bottomRightCorner<3, 3>() *= kRadius * kRadius;
    body.free << 0.1 * random.normal(), 0.1 * random.normal(), -0.5 + 0.2 * random.normal(),
        2.0 * random.normal(), 2.0 * random.normal(), 2.0 * random.normal();
    stack.bodies.push_back(body);
    for (int k = 0; k < kRows; ++k) {
      const SinCos at = sin_cos(6.283185307179586 * k / kRows);
      IslandRow row;
      row.a = i;
      row.b = i - 1;
      row.arm_a = Vec3(kRadius * at.cos, kRadius * at.sin, -0.006);
      row.arm_b = Vec3(kRadius * at.cos, kRadius * at.sin, 0.006);
      row.normal = Vec3(0.2 * at.cos, 0.2 * at.sin, -1.0).normalized();
      row.first = row.normal.unitOrthogonal();
      row.limit = 0.01 * std::fabs(random.normal());
      row.friction = friction;
      stack.rows.push_back(row);
      stack.sources.push_back({.pair = i, .row = k});
    }
  }
  return stack;
}

double worst_violation(const Stack& stack) {
  double worst = -kInfinity;
  for (const IslandRow& row : stack.rows) {
    const auto at = [&](std::int32_t body, const Vec3& arm) -> Vec3 {
      if (body < 0) return Vec3::Zero();
      const Vec6& u = stack.bodies[static_cast<std::size_t>(body)].velocity;
      const Vec3 turn = u.tail<3>();
      return u.head<3>() + turn.cross(arm);
    };
    const Vec3 w = at(row.a, row.arm_a) - at(row.b, row.arm_b);
    worst = std::max(worst, row.normal.dot(w) - row.limit);
  }
  return worst;
}

TEST(RowCut, SolutionOfFewRowsObeysAllAndIsThatOfAll) {
  Random random(3);
  RowCut cut;
  IslandScratch scratch;
  for (int turn = 0; turn < 20; ++turn) {
    Stack few = make_stack(3, 0.0, random), all = few;
    const CutSolution solution = solve_cut(few.bodies, few.rows, few.sources, {}, cut, scratch);
    solve_island(all.bodies, all.rows, scratch);
    EXPECT_LE(solution.most_handed, kMostHanded);
    EXPECT_GT(solution.rounds, 1) << "the first rows do";
    EXPECT_TRUE(solution.solution.is_whole);
    EXPECT_LE(worst_violation(few), 1e-6);
    EXPECT_LE(solution.solution.residual, 1e-6);
    for (std::size_t i = 0; i < few.bodies.size(); ++i)
      EXPECT_LE((few.bodies[i].velocity - all.bodies[i].velocity).norm(), 1e-3) << turn;
  }
}

TEST(RowCut, FrictionKeepsAllRowsToo) {
  Random random(4);
  RowCut cut;
  IslandScratch scratch;
  for (int turn = 0; turn < 20; ++turn) {
    Stack few = make_stack(3, 0.4, random);
    const CutSolution solution = solve_cut(few.bodies, few.rows, few.sources, {}, cut, scratch);
    EXPECT_LE(solution.most_handed, kMostHanded);
    EXPECT_LE(worst_violation(few), 2e-6);
    EXPECT_GE(solution.solution.residual, worst_violation(few) - 1e-8);
  }
}

TEST(RowCut, SmallPairsAreHandedOverWhole) {
  Random random(5);
  RowCut cut;
  IslandScratch scratch;
  Stack few = make_stack(1, 0.4, random);
  few.rows.resize(kWholePair);
  few.sources.resize(kWholePair);
  Stack all = few;
  const CutSolution solution = solve_cut(few.bodies, few.rows, few.sources, {}, cut, scratch);
  solve_island(all.bodies, all.rows, scratch);
  EXPECT_EQ(solution.most_handed, kWholePair);
  EXPECT_EQ(solution.rounds, 1);
  EXPECT_EQ(few.bodies[0].velocity, all.bodies[0].velocity);
}

}  // namespace
}  // namespace thigma::detail
