#include "thigma/constraint/feature_rows.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "support/apart.h"
#include "support/row_query.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

using Two = test::RowQuery;

BodyState at_pose(const Pose& pose) {
  BodyState state;
  state.position = pose.position;
  state.orientation = pose.orientation;
  return state;
}

Vec3 random_direction(Random& random) {
  return Vec3(random.normal(), random.normal(), random.normal()).normalized();
}

bool obeys(const ConstraintModel& model, const BodyState& state) {
  const Mat3 rotation = rotation_matrix(state.orientation);
  for (const ContactRow& row : model.rows)
    if (row_at(row, state.position, rotation).gap < 0.0) return false;
  return true;
}

/// Motions of at most the travel of the model, pushed against what is near.
BodyState moved(const ConstraintModel& model, Random& random, const Vec3& towards) {
  const double share = random.uniform(), angle = (1.0 - share) * model.travel / model.reach;
  BodyState state = model.state;
  const Vec3 along = (random_direction(random) + 0.7 * towards).normalized();
  state.position += share * model.travel * along;
  state.orientation =
      rotation_from_vector(angle * random_direction(random)) * model.state.orientation;
  return state;
}

struct Counts {
  int obeyed = 0, met = 0, met_though_obeyed = 0;
};

/// Random places near the scene, random motions from there.
Counts try_motions(Two& two, Random& random, int places, int motions, double tolerance) {
  const test::TriangleTree scene = test::build_triangle_tree(two.scene);
  Counts counts;
  for (int place = 0; place < places; ++place) {
    const Vec3 from = random_direction(random);
    Pose far{0.2 * from, rotation_from_vector(3.0 * random_direction(random))};
    const Vec3 towards = (Vec3(0.006 * random_direction(random)) - far.position).normalized();
    const double gap = (place % 3 == 0 ? 0.01 : random.uniform(0.05, 0.8)) * tolerance;
    const Pose near = test::brought_near(two.object, far, towards, scene, gap);
    // Whatever way is thought likely, and however long.
    two.way = {place % 2 == 0, tolerance * random.uniform(0.0, 2.0) * random_direction(random),
               random.uniform(0.0, 0.1) * random_direction(random), near.position};
    const ConstraintStats stats = two.ask(at_pose(near), tolerance);
    EXPECT_EQ(stats.left_out, 0);
    EXPECT_TRUE(obeys(*two.model, two.model->state)) << "at rest, place " << place;
    for (int k = 0; k < motions; ++k) {
      const BodyState state = moved(*two.model, random, towards);
      const bool obeyed = obeys(*two.model, state);
      const bool met = test::meet(two.object, {state.position, state.orientation}, scene);
      counts.obeyed += obeyed;
      counts.met += met;
      counts.met_though_obeyed += obeyed && met;
    }
  }
  return counts;
}

struct Pair {
  std::string name;
  std::function<TriangleMesh()> object, scene;
};

std::vector<Pair> pairs() {
  const auto box = [] { return make_box({0.02, 0.015, 0.01}, {2, 2, 2}); };
  const auto plate = [] { return make_box({0.03, 0.03, 0.002}, {5, 5, 1}); };
  const auto ball = [] { return make_ball(0.01, 4); };
  const auto ring = [] { return make_torus(0.012, 0.004, 18, 9); };
  const auto angle = [] { return make_l_shape(0.02, 0.01); };
  const auto peg = [] { return make_cylinder(0.004, 0.03, 12); };
  return {{"box on plate", box, plate}, {"box on box", box, box},
          {"ball on box", ball, box},   {"ball on ball", ball, ball},
          {"ring on ring", ring, ring}, {"angle on angle", angle, angle},
          {"peg on ring", peg, ring},   {"box on angle", box, angle},
          {"plate on peg", plate, peg}, {"angle on ring", angle, ring}};
}

TEST(FeatureRows, WhoObeysThemMeetsNothing) {
  Random random(2026);
  for (const Pair& pair : pairs()) {
    Two two(pair.object(), pair.scene());
    const Counts counts = try_motions(two, random, 25, 60, 1e-3);
    EXPECT_EQ(counts.met_though_obeyed, 0) << pair.name;
    // The test can fail: motions that nothing forbids, and motions that would have entered.
    EXPECT_GT(counts.obeyed, 200) << pair.name;
    EXPECT_GT(counts.met, 50) << pair.name;
  }
}

// With the travel of models that come late the object turns by up to 17 degrees, and by 57 where it
// may go as far as it is wide.
TEST(FeatureRows, NorDoesWhoGoesFarAndTurns) {
  Random random(2027);
  for (const double share : {0.3, 1.0}) {
    for (const Pair& pair : pairs()) {
      Two two(pair.object(), pair.scene());
      const Counts counts = try_motions(two, random, 25, 60, share * two.world.reach);
      EXPECT_EQ(counts.met_though_obeyed, 0) << pair.name << ", " << share;
      EXPECT_GT(counts.obeyed, 200) << pair.name << ", " << share;
      EXPECT_GT(counts.met, 50) << pair.name << ", " << share;
    }
  }
}

/// As far from a start along a direction as the rows of a model let a state, less a little.
bool press(const ConstraintModel& model, const Vec3& start, const Vec3& towards, BodyState& state) {
  constexpr double kLess = 1e-4;  // of the travel
  double low = -model.travel, high = model.travel;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    state.position = start + middle * towards;
    (obeys(model, state) ? low : high) = middle;
  }
  state.position = start + (low - kLess * model.travel) * towards;
  return obeys(model, state) && !is_beyond(model, state);
}

// Two edges that are exactly parallel and lie over each other in part: a vertex of either keeps
// them apart as long as nothing turns. Turned about axes between them and their normal they would
// cross.
TEST(FeatureRows, ParallelEdgesDoNotCrossByTurning) {
  const Vec3 size(0.02, 0.015, 0.01), towards = Vec3(0.0, -1.0, -1.0).normalized();
  const TriangleMesh box = make_box(size, {1, 1, 1});
  const test::TriangleTree scene = test::build_triangle_tree(box);
  Random random(7);
  for (const double share : {0.05, 0.1, 0.2, 0.3}) {
    Two two(box, box);
    const double travel = share * two.world.reach;
    int obeyed = 0, met = 0;
    for (int place = 0; place < 40; ++place) {
      const double apart = (place % 2 == 0 ? 0.3 : 0.01) * travel;
      BodyState state;
      state.position = {random.uniform(-0.9, 0.9) * size.x(),
                        size.y() + apart * random.uniform(0.1, 1.0),
                        size.z() + apart * random.uniform(0.1, 1.0)};
      two.ask(state, travel);
      const ConstraintModel& model = *two.model;
      for (int k = 0; k < 400; ++k) {
        const double lean = random.uniform(-3.2, 3.2);
        const Vec3 axis = std::cos(lean) * Vec3::UnitX() + std::sin(lean) * towards +
                          0.2 * random_direction(random);
        const double angle = random.uniform(0.3, 1.0) * model.travel / model.reach;
        state.orientation = rotation_from_vector(angle * axis.normalized());
        const Vec3 start = model.state.position +
                           random.uniform(-0.3, 0.3) * model.travel * Vec3::UnitX() +
                           random.uniform(-0.2, 0.2) * model.travel * random_direction(random);
        if (!press(model, start, towards, state)) continue;
        ++obeyed;
        met += test::meet(two.object, {state.position, state.orientation}, scene);
      }
    }
    EXPECT_EQ(met, 0) << share;
    EXPECT_GT(obeyed, 5000) << share;
  }
}

TEST(FeatureRows, ANanometreAndAKilometreGiveTheSameRows) {
  std::size_t expected = 0;
  for (const double scale : {1.0, 1e-6, 1e5}) {
    const Vec3 size = scale * Vec3(0.02, 0.02, 0.02);
    Two two(make_box(size, {2, 2, 2}), make_box(3.0 * size, {3, 3, 3}));
    BodyState state;
    state.position = {0.0013 * scale, 0.0007 * scale, 0.04001 * scale};
    two.ask(state, 2e-4 * scale);
    if (expected == 0) expected = two.model->rows.size();
    EXPECT_EQ(two.model->rows.size(), expected) << scale;
  }
  EXPECT_EQ(expected, 4u);
}

TEST(FeatureRows, FlatTilesGiveARowACornerAndNoneAtTheirBorders) {
  for (const int tiles : {1, 8, 64}) {
    TriangleMesh plate = make_box({0.1, 0.1, 0.01}, {tiles, tiles, 1});
    Two two(make_box({0.02, 0.02, 0.02}, {3, 3, 3}), plate);
    for (const double x : {0.0, 0.00125, 0.0031, 0.01}) {
      BodyState state;
      state.position = {x, 0.3 * x, 0.015 + 1e-6};
      two.ask(state, 2e-4);
      ASSERT_EQ(two.model->rows.size(), 4u) << tiles << " tiles at " << x;
      for (const ContactRow& row : two.model->rows)
        EXPECT_LE((row.scene_direction + Vec3::UnitZ()).norm(), 1e-12);
    }
  }
}

TEST(FeatureRows, FarFromEverythingThereAreNone) {
  Two two(make_ball(0.01, 4), make_ball(0.01, 4));
  BodyState state;
  state.position = {0.0, 0.0, 0.1};
  const ConstraintStats stats = two.ask(state, 1e-3);
  EXPECT_EQ(stats.rows, 0);
  EXPECT_GT(two.model->travel, 0.0);
}

TEST(FeatureRows, RowsOfRoundThingsPointWhereTheSurfacesDo) {
  // An object that slides would run into planes beside what is near, within half the travel.
  for (const double gap : {1e-6, 5e-5}) {
    Two two(make_ball(0.020, 24), make_ball(0.030, 32));
    BodyState state;
    const Vec3 up = Vec3(0.3, 0.2, 1.0).normalized();
    const test::TriangleTree scene = test::build_triangle_tree(two.scene);
    const Pose near =
        test::brought_near(two.object, {0.06 * up, Quat::Identity()}, -up, scene, gap);
    state = at_pose(near);
    two.ask(state, 1.6e-3);
    ASSERT_GT(two.model->rows.size(), 20u);
    double least = 1.0;
    for (const ContactRow& row : two.model->rows) {
      const RowAtState at = row_at(row, state.position, Mat3::Identity());
      if (at.gap > 0.5 * two.model->travel) continue;
      least = std::min(least, -at.normal.dot((state.position + at.arm).normalized()));
    }
    EXPECT_GT(least, 0.6) << gap;  // 0 upright
  }
}

TEST(FeatureRows, ACornerSlidesOverAShallowRidgeWithoutACatch) {
  // Over the near slope, which its own bottom keeps it from touching first: a plane square to the
  // way to the far slope stands upright on the ridge, and the corner would run into it.
  constexpr double kSlope = 0.06, kGap = 2e-6, kBeside = 3e-5;
  TriangleMesh roof = make_box({0.06, 0.05, 0.01}, {2, 1, 1});
  for (Vec3& p : roof.positions)
    if (p.z() > 0.0) p.z() -= kSlope * std::fabs(p.x());
  Two two(make_box({0.02, 0.03, 0.02}, {1, 1, 1}), roof);
  const BodyState state = at_pose({{0.01 - kBeside, 0.0, 0.005 + 0.01 + kGap}, Quat::Identity()});
  two.ask(state, 2e-4);
  ASSERT_GT(two.model->rows.size(), 0u);
  ASSERT_GT(two.model->travel, 3.0 * kBeside);
  BodyState beyond = state;
  beyond.position.x() += 2.0 * kBeside;
  EXPECT_TRUE(obeys(*two.model, beyond));
  BodyState below = state;
  below.position.z() -= 2.0 * kGap;
  EXPECT_FALSE(obeys(*two.model, below));
}

TEST(FeatureRows, WhatDoesNotFitIsLookedForNearer) {
  const TriangleMesh ball = make_ball(0.01, 16);
  BodyState state;
  state.position = {0.0, 0.0, 0.02001};
  Two all(ball, ball);
  const ConstraintStats known = all.ask(state, 1e-3);
  ASSERT_EQ(known.left_out, 0);
  // Room for the contacts, but not for the rows.
  const std::size_t contacts = all.contacts.contacts.size();
  ASSERT_LT(contacts, static_cast<std::size_t>(known.rows));
  Two two(ball, ball, 0.0, contacts);
  const ConstraintStats stats = two.ask(state, 1e-3);
  EXPECT_EQ(stats.left_out, 0);
  EXPECT_GT(stats.halvings, 0);
  EXPECT_GT(two.model->travel, 0.0);
  EXPECT_LT(two.model->travel, all.model->travel);
  EXPECT_GT(two.model->rows.size(), 0u);
}

TEST(FeatureRows, WhatWouldBeFarTooManyIsLookedForNearer) {
  const TriangleMesh ball = make_ball(0.01, 64);
  BodyState state;
  state.position = {0.0, 0.0, 0.02001};
  Two two(ball, ball, 0.0, 60'000);
  const ConstraintStats stats = two.ask(state, 1e-3);
  EXPECT_EQ(stats.left_out, 0);
  EXPECT_GT(stats.halvings, 0);
  EXPECT_LT(stats.rows, 10 * static_cast<std::int64_t>(kMaxRows));
  EXPECT_GT(two.model->travel, 0.0);
  // What is nearest is kept out.
  BodyState below = state;
  below.position.z() -= 2e-5;
  EXPECT_FALSE(obeys(*two.model, below));
  // Without a bound there would be more.
  std::vector<FoundRow> all;
  all.reserve(60'000);
  RowScratch scratch;
  reserve_rows(scratch, two.world.object, *two.world.scene[0], 60'000);
  const BodyPair pair{{&two.world.object, {state.position, state.orientation}},
                      {two.world.scene[0].get(), Pose{}},
                      0};
  EXPECT_EQ(find_rows(pair, two.contacts.contacts, row_reach(two.world, 9.5e-4), scratch, all), 0);
  EXPECT_GT(all.size(), 10 * kMaxRows);
}

TEST(FeatureRows, WhatDoesNotFitStopsTheMotion) {
  Two two(make_ball(0.01, 8), make_ball(0.01, 8), 0.0, 4);
  BodyState state;
  state.position = {0.0, 0.0, 0.0201};
  EXPECT_GT(two.ask(state, 1e-3).left_out, 0);
  EXPECT_EQ(two.model->travel, 0.0);
}

}  // namespace
}  // namespace thigma
