// Rows with lists of what may touch are those without, bit for bit, however the object moves.

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "support/row_query.h"
#include <gtest/gtest.h>

#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

/// The same question to two, of which one keeps lists.
struct Twins {
  test::RowQuery plain, listed;

  Twins(const TriangleMesh& a, const TriangleMesh& b) : plain(a, b), listed(a, b) {
    reserve_pair_lists(listed.scratch.rows);
  }

  void ask(const BodyState& state, double tolerance, const LikelyWay& way,
           const std::string& where) {
    plain.way = listed.way = way;
    const ConstraintStats of_plain = plain.ask(state, tolerance);
    const ConstraintStats of_listed = listed.ask(state, tolerance);
    ASSERT_EQ(of_plain.rows, of_listed.rows) << where;
    ASSERT_EQ(of_plain.left_out, of_listed.left_out) << where;
    ASSERT_EQ(plain.model->travel, listed.model->travel) << where;
    ASSERT_EQ(plain.model->rows.size(), listed.model->rows.size()) << where;
    for (std::size_t i = 0; i < plain.model->rows.size(); ++i)
      ASSERT_TRUE(is_same(plain.model->rows[i], listed.model->rows[i])) << where << ", row " << i;
  }

  static bool is_same(const ContactRow& a, const ContactRow& b) {
    return a.kind == b.kind && a.id == b.id && a.object_point == b.object_point &&
           a.scene_point == b.scene_point && a.object_direction == b.object_direction &&
           a.scene_direction == b.scene_direction && a.body == b.body;
  }
};

/// Walks about a place near the touch, by so much of the reach a step; counts rows.
std::int64_t walk(Twins& twins, const Vec3& start, double step, int seed, bool knows_way) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> normal;
  const auto any = [&] { return Vec3(normal(random), normal(random), normal(random)); };
  const double reach = twins.plain.world.reach;
  BodyState state;
  state.position = start;
  std::int64_t rows = 0;
  for (int frame = 0; frame < 150; ++frame) {
    const Vec3 way = step * reach * any(), turn = step * any();
    state.position += way + 0.1 * (start - state.position);
    state.orientation = (rotation_from_vector(turn) * state.orientation).normalized();
    LikelyWay likely;
    if (knows_way) likely = {true, 2.0 * way, 2.0 * turn, state.position, way.norm()};
    // What is looked ahead goes up and down by twos.
    const double tolerance = 0.01 * reach * (frame % 40 < 30 ? 1.0 : 2.0);
    twins.ask(state, tolerance, likely,
              "seed " + std::to_string(seed) + ", frame " + std::to_string(frame));
    if (testing::Test::HasFatalFailure()) return rows;
    rows += static_cast<std::int64_t>(twins.plain.model->rows.size());
  }
  return rows;
}

TEST(PairLists, MakeTheSameRowsWhereTheObjectHardlyMoves) {
  Twins twins(make_ball(0.02, 6), make_torus(0.05, 0.02, 48, 24));
  const std::int64_t rows = walk(twins, {0.05, 0.0, 0.0401}, 1e-4, 1, true);
  const RowScratch& scratch = twins.listed.scratch.rows;
  EXPECT_GT(rows, 100);
  EXPECT_GT(scratch.lists_used, 5 * scratch.lists_made) << "hardly a list is used twice";
  EXPECT_GT(scratch.lists_made, 1);
}

TEST(PairLists, MakeTheSameRowsHoweverItMoves) {
  for (const double step : {3e-4, 1e-3, 3e-3, 1e-2}) {
    for (const bool knows_way : {true, false}) {
      Twins twins(make_box({0.02, 0.03, 0.01}), make_ellipsoid({0.03, 0.04, 0.02}, 6));
      const std::int64_t rows = walk(twins, {0.0, 0.0, 0.0252}, step, 2, knows_way);
      if (HasFatalFailure()) return;
      EXPECT_GT(rows, 30) << step;
    }
  }
}

TEST(PairLists, MakeTheSameRowsWhereItSlidesAndDoesNotTurn) {
  Twins twins(make_ball(0.02, 12), make_ball(0.05, 12));
  const double away = 0.07002, angle = 4e-4;
  BodyState state;
  std::size_t rows = 0;
  for (int frame = 0; frame < 300; ++frame) {
    const double a = 0.2 + angle * frame;
    const Vec3 at = away * Vec3(std::sin(a), 0.0, std::cos(a));
    const LikelyWay way{true, frame > 0 ? Vec3(2.0 * (at - state.position)) : Vec3::Zero()};
    state.position = at;
    twins.ask(state, 2e-4, way, "frame " + std::to_string(frame));
    if (HasFatalFailure()) return;
    rows += twins.plain.model->rows.size();
  }
  EXPECT_GT(rows, 300U);
  EXPECT_GT(twins.listed.scratch.rows.lists_used, 300);
}

TEST(PairLists, MakeTheSameRowsAtAnySize) {
  for (const double size : {1e-9, 1.0, 1e3}) {
    Twins twins(make_cylinder(0.3 * size, 0.5 * size, 24), make_cylinder(size, size, 48, 3));
    const std::int64_t rows = walk(twins, {0.0, 0.0, 0.752 * size}, 3e-4, 3, true);
    if (HasFatalFailure()) return;
    EXPECT_GT(rows, 30) << size;
    EXPECT_GT(twins.listed.scratch.rows.lists_used, 100) << size;
  }
}

TEST(PairLists, MoreThanAListHoldsIsSearchedWithoutOne) {
  // Two disks face to face: all vertices of a wide patch over all triangles of another.
  Twins twins(make_cylinder(0.05, 0.01, 96), make_cylinder(0.05, 0.01, 96));
  const std::int64_t rows = walk(twins, {0.0, 0.0, 0.01002}, 1e-5, 4, true);
  EXPECT_GT(rows, 100);
  const auto& lists = twins.listed.scratch.rows.lists;
  EXPECT_TRUE(std::any_of(lists.begin(), lists.end(), [](const auto& l) { return l.is_full; }));
}

TEST(PairLists, MakeTheSameRowsWherePairsOfPatchesShareAPlace) {
  for (const std::size_t places : {1U, 2U, 4U}) {
    // Disks whose rims cross: one pair of patches has more than a list holds, others have not.
    Twins twins(make_cylinder(0.05, 0.01, 96), make_cylinder(0.05, 0.01, 96));
    twins.listed.scratch.rows.lists.resize(places);
    const std::int64_t rows = walk(twins, {0.06, 0.0, 0.01002}, 1e-4, 5, true);
    if (HasFatalFailure()) return;
    EXPECT_GT(rows, 100) << places;
    const RowScratch& scratch = twins.listed.scratch.rows;
    EXPECT_GT(scratch.lists_made, 300) << places << ": hardly a place is shared";
  }
}

}  // namespace
}  // namespace thigma
