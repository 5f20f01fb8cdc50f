// Rows of coarse pairs against the triangles below them, by a search that knows nothing of levels.

#include "thigma/constraint/coarse_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "support/level_check.h"
#include "support/wavy_ball.h"
#include <gtest/gtest.h>

#include "thigma/dynamics/constraint_model.h"
#include "thigma/math/infinity.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

/// Two levelled bodies, the second at rest at the identity.
struct Bodies {
  test::LevelPairCheck pair;
  test::PatchSurfaces objects, scenes;
  std::vector<SceneBody> bodies;
  double size;  // the smaller radius

  Bodies(const char* name, const TriangleMesh& a, const TriangleMesh& b)
      : pair(test::make_level_pair(name, a, b)),
        objects(pair.exact.object, pair.object_mesh),
        scenes(pair.exact.scene, pair.scene_mesh),
        bodies{{&pair.exact.scene, Pose{}}},
        size(pair.exact.radius) {}
  Bodies(const Bodies&) = delete;
  Bodies& operator=(const Bodies&) = delete;
};

/// Made once for all tests.
const std::vector<std::unique_ptr<Bodies>>& all_bodies() {
  static std::vector<std::unique_ptr<Bodies>> all;
  if (!all.empty()) return all;
  all.push_back(std::make_unique<Bodies>("waves on a ring", test::wavy_ball_of(12, 1.0, 0.05),
                                         make_torus(1.2, 0.4, 48, 24)));
  all.push_back(std::make_unique<Bodies>("ring on waves", make_torus(1.0, 0.35, 48, 20),
                                         test::wavy_ball_of(12, 1.3, 0.08)));
  return all;
}

/// What is asked: all within `travel`, finest patches within a part of it.
struct Asked {
  double threshold = 0.025, travel = 0.0, part = 0.5, turn = 0.0;
};

ContactQuery query_of(const Asked& asked) {
  ContactQuery query{.tolerance = asked.travel};
  query.resolution.is_exact = false;
  query.resolution.metric.haptic = asked.threshold;
  query.resolution.exact_within = asked.part * asked.travel;
  query.resolution.turn = asked.turn;
  return query;
}

ContactSet room() {
  ContactSet set;
  set.contacts.reserve(200'000);
  return set;
}

/// A pose at which the surfaces stand apart by a share of the size.
Pose apart_by(const Bodies& bodies, double gap, Random& random) {
  Pose start;
  start.orientation = random.orientation();
  const Vec3 direction = random.direction();
  const double far = 1.2 * (bodies.pair.exact.object.radius + bodies.pair.exact.scene.radius);
  start.position = -far * direction;
  return test::pose_at_gap(bodies.pair.exact, start, direction, gap * bodies.size);
}

/// One query of the exact bodies, into an empty set.
void ask(const Bodies& bodies, const Pose& pose, const ContactQuery& query, ContactFront& front,
         ContactSet& set) {
  clear(set);
  query_contacts({bodies.pair.exact.object, pose}, {bodies.pair.exact.scene}, query, front, set);
}

TEST(CoarseRows, WhatNoRowKeepsApartIsFartherThanTheTravel) {
  Random random(11);
  for (const auto& bodies : all_bodies()) {
    for (const double s0 : {0.0025, 0.01, 0.025, 0.05}) {
      ContactFront front;
      ContactSet set = room();
      std::int64_t coarse = 0, true_pairs = 0;
      for (int k = 0; k < 12; ++k) {
        const double gap = k % 3 == 0 ? 1e-6 : random.uniform(0.0, 0.1);
        const Pose pose = apart_by(*bodies, gap, random);
        const Asked asked{s0, bodies->size * random.uniform(0.01, 0.3), random.uniform(0.05, 0.6),
                          random.uniform(0.0, 0.2)};
        ask(*bodies, pose, query_of(asked), front, set);
        ASSERT_EQ(set.dropped, 0);
        EXPECT_EQ(test::count_missed(bodies->pair, bodies->objects, bodies->scenes, pose,
                                     asked.travel * (1.0 - 1e-9), set, true_pairs),
                  0)
            << bodies->pair.name << ' ' << s0;
        coarse += std::count_if(set.contacts.begin(), set.contacts.end(), is_coarse);
        if (set.contacts.empty()) {
          const double least = test::least_triangle_distance(
              test::placed(bodies->pair.exact.object_tree, pose), bodies->pair.exact.scene_tree);
          EXPECT_LE(unreported_separation(front), least * (1.0 + 1e-9));
          EXPECT_GE(unreported_separation(front), asked.travel);
        }
      }
      if (s0 >= 0.01) EXPECT_GT(coarse, 30) << bodies->pair.name << ' ' << s0;
      EXPECT_GT(true_pairs, 200) << bodies->pair.name << ' ' << s0;
    }
  }
}

TEST(CoarseRows, TooManyContactsShrinkTheToleranceAndLeaveOutNoneWithinIt) {
  constexpr std::size_t kMost = 40;
  Random random(13);
  int shrunk = 0, most_halved = 0;
  for (const auto& bodies : all_bodies()) {
    ContactFront kept;
    ContactSet set = room(), want = room();
    for (int k = 0; k < 20; ++k) {
      const Pose pose = apart_by(*bodies, random.uniform(0.0, 0.05), random);
      const Asked asked{0.025, bodies->size * random.uniform(0.02, 0.4), random.uniform(0.05, 0.6)};
      ContactQuery query = query_of(asked);
      query.most_pairs = kMost;
      ask(*bodies, pose, query, kept, set);
      ASSERT_LE(kept.tolerance, query.tolerance);
      ASSERT_GE(kept.tolerance, query.tolerance / 64.0);
      const bool is_shrunk = kept.tolerance < query.tolerance;
      const int halvings =
          static_cast<int>(std::lround(std::log2(query.tolerance / kept.tolerance)));
      EXPECT_TRUE(set.contacts.size() <= kMost || halvings == 6);
      // What was known before changes nothing, nor whether there is memory for it.
      for (const int capacity : {0, 50}) {
        ContactFront other;
        if (capacity > 0)
          reserve_front(other, bodies->pair.exact.object, bodies->pair.exact.scene, capacity);
        ask(*bodies, pose, query, other, want);
        EXPECT_EQ(other.tolerance, kept.tolerance);
        EXPECT_EQ(test::first_difference(set, want), -1);
      }
      most_halved = std::max(most_halved, halvings);
      // As if so much had been asked for.
      query.most_pairs = 0;
      query.tolerance = kept.tolerance;
      if (is_shrunk) {
        query.resolution.exact_within =
            std::min(query.resolution.exact_within, 0.5 * query.tolerance);
      }
      ContactFront fresh;
      ask(*bodies, pose, query, fresh, want);
      EXPECT_EQ(test::first_difference(set, want), -1);
      EXPECT_EQ(set.dropped, 0);
      ASSERT_FALSE(testing::Test::HasFailure()) << bodies->pair.name << ' ' << k;
      shrunk += is_shrunk;
    }
  }
  EXPECT_GE(shrunk, 15);
  EXPECT_GE(most_halved, 2);
}

TEST(CoarseRows, WithoutRoomTheToleranceShrinksAllTheSame) {
  // Contacts of other bodies have taken most of it.
  Random random(15);
  const Bodies& bodies = *all_bodies().front();
  const Pose pose = apart_by(bodies, 1e-3, random);
  ContactQuery query = query_of({0.025, 0.4 * bodies.size});
  query.most_pairs = 40;
  ContactFront front, fresh;
  ContactSet roomy = room(), set;
  ask(bodies, pose, query, front, roomy);
  ASSERT_LT(front.tolerance, query.tolerance);
  ASSERT_GT(roomy.contacts.size(), 10u);
  constexpr std::size_t kOthers = 7, kRoom = 10;
  set.contacts.reserve(kOthers + kRoom);
  set.contacts.resize(kOthers);
  query_contacts({bodies.pair.exact.object, pose}, {bodies.pair.exact.scene}, query, fresh, set);
  EXPECT_LT(fresh.tolerance, query.tolerance);
  EXPECT_GE(fresh.tolerance, front.tolerance);
  EXPECT_EQ(set.contacts.size(), set.contacts.capacity());
  EXPECT_LE(set.contacts.size() - kOthers + static_cast<std::size_t>(set.dropped), 40u);
}

TEST(CoarseRows, TheToleranceShrinksNoFartherThanIsAllowed) {
  Random random(14);
  const Bodies& bodies = *all_bodies().front();
  const Pose pose = apart_by(bodies, 1e-3, random);
  ContactQuery query = query_of({0.025, 0.4 * bodies.size});
  query.most_pairs = 5;
  query.least_tolerance = 0.15 * bodies.size;
  ContactFront front;
  ContactSet set = room();
  ask(bodies, pose, query, front, set);
  EXPECT_EQ(front.tolerance, 0.5 * query.tolerance);
}

/// A motion that moves no point of the object farther than `travel`, nor turns it by more than
/// `turn`.
Pose moved(const Pose& pose, double reach, const Asked& asked, Random& random) {
  const double angle = random.uniform(0.0, std::min(asked.turn, 0.5 * asked.travel / reach));
  Pose to = pose;
  to.orientation = rotation_from_vector(angle * random.direction()) * pose.orientation;
  to.position += random.uniform(0.0, 0.5 * asked.travel) * random.direction();
  return to;
}

double separation(Bodies& bodies, const Contact& contact, const Pose& pose) {
  return test::least_triangle_distance(
      test::placed(bodies.objects.below(contact.object_patch), pose),
      bodies.scenes.below(contact.scene_patch));
}

TEST(CoarseRows, NoGapIsLargerThanTheSeparationWhereverTheObjectGoes) {
  Random random(12);
  for (const auto& bodies : all_bodies()) {
    const double reach = 1.2 * bodies->pair.exact.object.radius;
    ContactFront front;
    ContactSet set = room();
    std::vector<FoundRow> rows;
    double tightest = 0.0;
    for (int k = 0; k < 8; ++k) {
      const Pose pose = apart_by(*bodies, random.uniform(0.0, 0.03), random);
      Asked asked{0.05, bodies->size * random.uniform(0.02, 0.2)};
      asked.turn = asked.travel / reach;
      ask(*bodies, pose, query_of(asked), front, set);
      for (const Contact& contact : set.contacts) {
        if (!is_coarse(contact)) continue;
        rows.clear();
        find_coarse_rows({bodies->pair.exact.object, pose}, bodies->bodies, std::span(&contact, 1),
                         {kInfinity, asked.turn}, rows);
        ASSERT_EQ(rows.size(), 1u);
        const double here = separation(*bodies, contact, pose);
        EXPECT_GT(rows[0].gap, asked.part * asked.travel * (1.0 - 1e-6));
        EXPECT_LE(rows[0].gap, here);
        EXPECT_LE(std::fabs(-contact.depth - here), contact.bound);
        tightest = std::max(tightest, rows[0].gap / here);
        const RowAtState at = row_at(rows[0].row, pose.position, rotation_matrix(pose.orientation));
        EXPECT_NEAR(at.gap, rows[0].gap, 1e-12);
        for (int n = 0; n < 3; ++n) {
          const Pose there = moved(pose, reach, asked, random);
          const double gap =
              row_at(rows[0].row, there.position, rotation_matrix(there.orientation)).gap;
          if (gap > 0.0) EXPECT_LE(gap, separation(*bodies, contact, there));
        }
      }
    }
    EXPECT_GT(tightest, 0.6) << bodies->pair.name;  // and some are nearly as large
  }
}

TEST(CoarseRows, RowsBeyondReachAreLeftOutAndFinestContactsPassedOver) {
  Bodies& bodies = *all_bodies().front();
  Random random(13);
  const Pose pose = apart_by(bodies, 0.001, random);
  const Asked asked{0.05, 0.3 * bodies.size};
  ContactFront front;
  ContactSet set = room();
  ask(bodies, pose, query_of(asked), front, set);
  std::vector<FoundRow> near, all_rows;
  const PlacedHierarchy object{bodies.pair.exact.object, pose};
  find_coarse_rows(object, bodies.bodies, set.contacts, {kInfinity, 0.0}, all_rows);
  find_coarse_rows(object, bodies.bodies, set.contacts, {0.8 * asked.travel, 0.0}, near);
  const auto coarse = std::count_if(set.contacts.begin(), set.contacts.end(), is_coarse);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(all_rows.size()), coarse);
  EXPECT_LT(coarse, static_cast<std::ptrdiff_t>(set.contacts.size()));
  EXPECT_LT(near.size(), all_rows.size());
  EXPECT_GT(near.size(), 0u);
  std::set<std::uint64_t> ids;
  for (const FoundRow& row : all_rows) {
    ids.insert(row.row.id);
    EXPECT_LT(row.row.body, 0);
    EXPECT_EQ(row.row.friction, Friction{});
    EXPECT_EQ(row.row.kind, RowKind::scene_plane);
  }
  EXPECT_EQ(ids.size(), all_rows.size());
}

TEST(CoarseRows, WhatIsRememberedChangesNoBit) {
  // Also where the tolerance changes from frame to frame.
  for (const auto& bodies : all_bodies()) {
    const ClodHierarchy &object = bodies->pair.exact.object, &scene = bodies->pair.exact.scene;
    Random random(14);
    const Pose start = apart_by(*bodies, 0.002, random);
    ContactFront kept;
    ContactSet set = room(), want = room();
    for (int k = 0; k < 120; ++k) {
      Pose pose = start;
      pose.position += 0.02 * bodies->size * std::sin(0.13 * k) * Vec3(0.3, 0.9, 0.1);
      pose.orientation = rotation_from_vector({0.02 * std::sin(0.11 * k), 0.0, 0.03 * k / 120.0}) *
                         start.orientation;
      const double travel = bodies->size * (0.02 * (1 << (k / 7 % 4)));
      const ContactQuery query = query_of({0.025, travel, k % 5 == 0 ? 0.2 : 0.5, travel});
      ContactFront fresh;
      clear(set);
      clear(want);
      query_contacts({object, pose}, {scene}, query, kept, set);
      query_contacts({object, pose}, {scene}, query, fresh, want);
      ASSERT_EQ(test::first_difference(set, want), -1) << bodies->pair.name << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace thigma
