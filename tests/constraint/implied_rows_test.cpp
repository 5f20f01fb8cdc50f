#include "thigma/constraint/implied_rows.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "support/row_query.h"
#include <gtest/gtest.h>

#include "thigma/core/index.h"
#include "thigma/dynamics/row_solve.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

constexpr double kMargin = 1e-6;  // of the ball's radius

/// The inside of a ball, as a surface of its own.
TriangleMesh cavity(double radius, int divisions) {
  TriangleMesh mesh = make_ball(radius, divisions);
  for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

/// A ball that nearly fills its socket and rests near the wall: all rows of one state.
struct BallInSocket {
  test::RowQuery query;
  BodyState state;
  double radius;

  explicit BallInSocket(double r) : query(make_ball(r, 20), cavity(1.02 * r, 24)), radius(r) {
    state.position = r * Vec3(0.008, 0.004, -0.009);
    query.ask(state, 0.025 * r);
  }
  const std::vector<FoundRow>& found() const { return query.scratch.found; }
};

/// The nearest displacement to a wanted one that leaves every kept row its margin, to first order.
Vec6 within(const BallInSocket& ball, std::span<const std::int32_t> kept, const Vec6& wanted) {
  auto rows = std::make_unique<VelocityRows>();
  auto impulses = std::make_unique<RowImpulses>();
  rows->count = static_cast<int>(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const RowAtState at =
        row_at(ball.found()[idx(kept[i])].row, ball.state.position, Mat3::Identity());
    const Vec3 moment = at.arm.cross(at.normal);
    for (int k = 0; k < 3; ++k) {
      rows->gradient[idx(k)][i] = at.normal[k];
      rows->gradient[idx(k + 3)][i] = moment[k];
    }
    rows->limit[i] = std::max(at.gap - kMargin * ball.radius, 0.0);
    rows->friction[i] = {};
  }
  Mat6 metric = Mat6::Identity();
  metric.bottomRightCorner<3, 3>() *= ball.radius * ball.radius;
  const RowSolution solution = solve_rows(metric, wanted, *rows, *impulses);
  EXPECT_TRUE(solution.is_whole);
  return solution.velocity;
}

BodyState moved(const BodyState& from, const Vec6& by) {
  BodyState to = from;
  to.position += by.head<3>();
  to.orientation = rotation_from_vector(by.tail<3>()) * from.orientation;
  return to;
}

double least_gap(std::span<const FoundRow> rows, std::span<const std::int32_t> which,
                 const BodyState& state) {
  const Mat3 rotation = state.orientation.toRotationMatrix();
  double least = 1e300;
  for (const std::int32_t i : which)
    least = std::min(least, row_at(rows[idx(i)].row, state.position, rotation).gap);
  return least;
}

/// What 2,000 far and turned displacements leave of any gap, where the kept rows keep their margin
/// and no point goes farther than `travel`.
double least_of_all(const BallInSocket& ball, std::span<const std::int32_t> kept, double travel) {
  std::vector<std::int32_t> all(ball.found().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  double least = 1e300;
  for (int k = 0; k < 2000; ++k) {
    Vec6 wanted;
    for (int i = 0; i < 6; ++i) wanted[i] = normal(random) * (i < 3 ? 1.0 : 1.0 / ball.radius);
    const double reach = wanted.head<3>().norm() + ball.radius * wanted.tail<3>().norm();
    Vec6 by = within(ball, kept, 3.0 * travel / reach * wanted);
    // The last bit of the way, on the true gaps and travel.
    double share = 1.0;
    const auto is_allowed = [&] {
      const BodyState to = moved(ball.state, share * by);
      return travel_between(ball.state, to, ball.query.world.reach) <= travel &&
             least_gap(ball.found(), kept, to) >= kMargin * ball.radius;
    };
    while (!is_allowed() && share > 1e-6) share *= 0.98;
    if (is_allowed())
      least = std::min(least, least_gap(ball.found(), all, moved(ball.state, share * by)));
  }
  return least;
}

RowBounds bounds_of(const BallInSocket& ball, double travel) {
  return {travel, ball.query.world.reach, kMargin * ball.radius};
}

TEST(ImpliedRows, WhereTheOthersAreKeptWhatIsLeftOutIsApart) {
  const BallInSocket ball(0.02);
  ASSERT_GT(ball.found().size(), 200u);
  ImpliedScratch scratch;
  reserve_implied(scratch, ball.found().size());
  for (const double travel : {1e-4, 2e-5, 5e-6}) {
    const auto kept =
        needed_rows(ball.found(), ball.state, bounds_of(ball, travel), kMaxRows, scratch);
    ASSERT_LE(kept.size(), static_cast<std::size_t>(kMaxRows));
    EXPECT_LT(2 * kept.size(), ball.found().size());
    EXPECT_GE(least_of_all(ball, kept, travel), 0.0) << travel << ", " << kept.size() << " kept";
  }
}

TEST(ImpliedRows, FarBeyondTheTravelTheOthersSayNothing) {
  // The oracle sees it where the bound is too small.
  const BallInSocket ball(0.02);
  ImpliedScratch scratch;
  reserve_implied(scratch, ball.found().size());
  const auto kept = needed_rows(ball.found(), ball.state, bounds_of(ball, 1e-5), kMaxRows, scratch);
  EXPECT_LT(least_of_all(ball, kept, 4e-4), -1e-6);
}

TEST(ImpliedRows, SizeDoesNotMatter) {
  // Powers of two: every number is the same but for its exponent, so that no choice between two
  // rows that are as good is left to rounding.
  constexpr double kSmall = 0x1p-30, kLarge = 0x1p10;
  const BallInSocket small(kSmall), large(kLarge);
  ASSERT_EQ(small.found().size(), large.found().size());
  ImpliedScratch a, b;
  reserve_implied(a, small.found().size());
  reserve_implied(b, large.found().size());
  const auto of_small =
      needed_rows(small.found(), small.state, bounds_of(small, 0.01 * kSmall), kMaxRows, a);
  const auto of_large =
      needed_rows(large.found(), large.state, bounds_of(large, 0.01 * kLarge), kMaxRows, b);
  EXPECT_TRUE(std::equal(of_small.begin(), of_small.end(), of_large.begin(), of_large.end()));
}

TEST(ImpliedRows, StopsWhereThereIsNoRoom) {
  const BallInSocket ball(0.02);
  ImpliedScratch scratch;
  reserve_implied(scratch, ball.found().size());
  EXPECT_EQ(needed_rows(ball.found(), ball.state, bounds_of(ball, 4e-4), 5, scratch).size(), 6u);
}

}  // namespace
}  // namespace thigma
