#include "thigma/contact/front.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TEST(Front, TakesMemoryOnceAndForgetsOnRequest) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 6));
  ContactFront front;
  reserve_front(front, ball, ball);
  EXPECT_EQ(front.capacity, default_front_capacity(ball, ball));
  const FrontNode* nodes = front.nodes.get();
  ContactSet set;
  set.contacts.reserve(10'000);
  Pose pose;
  pose.position = Vec3(2.01, 0, 0);
  query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, front, set);
  EXPECT_GT(front.alive, 1);
  clear_front(front);
  EXPECT_EQ(front.alive, 0);
  EXPECT_EQ(front.nodes.get(), nodes);
  const std::size_t before = set.contacts.size();
  query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, front, set);
  EXPECT_EQ(set.contacts.size(), 2 * before);
  EXPECT_EQ(front.nodes.get(), nodes);
}

TEST(Front, OfOtherBodiesIsStartedAfresh) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 6));
  const ClodHierarchy box = build_exact_hierarchy(make_box(Vec3(2, 2, 2), {3, 3, 3}));
  ContactFront used, fresh;
  ContactSet set, want;
  set.contacts.reserve(1000);
  want.contacts.reserve(1000);
  Pose pose;
  pose.position = Vec3(2.01, 0, 0);
  query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, used, set);
  clear(set);
  query_contacts({ball, pose}, {box}, {.tolerance = 0.05}, used, set);
  query_contacts({ball, pose}, {box}, {.tolerance = 0.05}, fresh, want);
  ASSERT_EQ(set.contacts.size(), want.contacts.size());
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    EXPECT_EQ(set.contacts[i].depth, want.contacts[i].depth);
    EXPECT_EQ(set.contacts[i].scene_patch, want.contacts[i].scene_patch);
  }
}

/// A ball about a ring: near on one side, never the same pose twice.
Pose on_the_way(int k) {
  const double t = 0.05 * k;
  return {{2.0 + 0.05 * std::sin(3.0 * t), 0.3 * std::sin(t), 0.1 * t},
          rotation_from_vector({0.1 * t, 0.2 * std::sin(t), 0.0})};
}

void expect_same(const ContactSet& set, const ContactSet& want) {
  ASSERT_EQ(set.contacts.size(), want.contacts.size());
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    EXPECT_EQ(set.contacts[i].depth, want.contacts[i].depth);
    EXPECT_EQ(set.contacts[i].point, want.contacts[i].point);
  }
}

TEST(Front, OutlivesAChangeOfTolerance) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 8));
  const ClodHierarchy ring = build_exact_hierarchy(make_torus(1.2, 0.4, 48, 24));
  ContactFront kept;
  ContactSet set, want;
  set.contacts.reserve(10'000);
  want.contacts.reserve(10'000);
  std::int64_t tests = 0, fresh_tests = 0;
  const double tolerances[] = {0.02, 0.04, 0.04, 0.08, 0.01, 0.16, 0.02};
  for (int k = 0; k < 140; ++k) {
    const ContactQuery query{.tolerance = tolerances[k % 7]};
    const Pose pose = on_the_way(k);
    clear(set);
    clear(want);
    query_contacts({ball, pose}, {ring}, query, kept, set);
    ContactFront fresh;
    query_contacts({ball, pose}, {ring}, query, fresh, want);
    tests += set.stats.tests;
    fresh_tests += want.stats.tests;
    SCOPED_TRACE(k);
    expect_same(set, want);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
  EXPECT_LT(tests, fresh_tests / 2);  // and it pays
}

TEST(Front, OutlivesWantOfRoomAndAChangeOfTolerance) {
  // Pairs that the front had no room for are split when there is room again; where the tolerance
  // became smaller in between they are not taken for far ones.
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 8));
  const ClodHierarchy ring = build_exact_hierarchy(make_torus(1.2, 0.4, 48, 24));
  ContactSet set, want;
  set.contacts.reserve(10'000);
  want.contacts.reserve(10'000);
  for (const std::int32_t capacity : {40, 80, 160, 320}) {
    ContactFront kept;
    reserve_front(kept, ball, ring, capacity);
    const double tolerances[] = {0.02, 0.8, 0.3, 0.1, 0.05, 0.03, 0.4, 0.02};
    for (int k = 0; k < 160; ++k) {
      const ContactQuery query{.tolerance = tolerances[k % 8]};
      const Pose pose = on_the_way(k);
      clear(set);
      clear(want);
      query_contacts({ball, pose}, {ring}, query, kept, set);
      ContactFront fresh;
      query_contacts({ball, pose}, {ring}, query, fresh, want);
      SCOPED_TRACE(k);
      expect_same(set, want);
      ASSERT_FALSE(testing::Test::HasFailure()) << capacity;
    }
  }
}

TEST(Front, TooManyPairsShrinkTheToleranceAndLeaveOutNoneWithinIt) {
  // A ball in a hollow one: nothing is near at one tolerance, nearly everything at twice that.
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 16));
  const ClodHierarchy hollow = build_exact_hierarchy(make_ball(1.05, 16));
  ContactFront kept;
  ContactSet set, want;
  set.contacts.reserve(1'000'000);
  want.contacts.reserve(1'000'000);
  int shrunk = 0;
  std::int64_t most = 0, most_without = 0;
  for (int k = 0; k < 40; ++k) {
    const Pose pose{{0.04 * std::sin(0.3 * k), 0.0, 0.0},
                    rotation_from_vector({0.0, 0.1 * k, 0.0})};
    const ContactQuery query{.tolerance = k % 3 == 0 ? 0.02 : 0.4, .most_pairs = 500};
    clear(set);
    clear(want);
    query_contacts({ball, pose}, {hollow}, query, kept, set);
    ASSERT_LE(kept.tolerance, query.tolerance);
    ASSERT_GE(kept.tolerance, query.tolerance / 64.0);
    ContactFront fresh;
    query_contacts({ball, pose}, {hollow}, {.tolerance = kept.tolerance}, fresh, want);
    SCOPED_TRACE(k);
    expect_same(set, want);
    ASSERT_FALSE(testing::Test::HasFailure());
    if (kept.tolerance < query.tolerance) ++shrunk;
    most = std::max(most, set.stats.tests);
    clear(want);
    query_contacts({ball, pose}, {hollow}, {.tolerance = query.tolerance}, fresh, want);
    most_without = std::max(most_without, want.stats.tests);
  }
  EXPECT_GE(shrunk, 20);
  EXPECT_LT(2 * most, most_without);
}

TEST(Front, TheToleranceShrinksNoFartherThanIsAllowed) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 16));
  const ClodHierarchy hollow = build_exact_hierarchy(make_ball(1.05, 16));
  ContactSet set;
  set.contacts.reserve(1'000'000);
  const auto left = [&](double least) {
    ContactFront front;
    double tolerance = 1.0;
    for (int k = 0; k < 10; ++k) {
      clear(set);
      query_contacts({ball, {{0.004 * k, 0.0, 0.0}}}, {hollow},
                     {.tolerance = 0.4, .most_pairs = 100, .least_tolerance = least}, front, set);
      tolerance = std::min(tolerance, front.tolerance);
    }
    return tolerance;
  };
  EXPECT_LT(left(0.0), 0.05);
  EXPECT_GE(left(0.06), 0.06);
  EXPECT_LT(left(0.06), 0.4);
  EXPECT_EQ(left(0.3), 0.4);
}

TEST(Front, KnowsHowFarWhatItDidNotReportIs) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 8));
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(10'000);
  for (const double gap : {5.0, 0.5, 0.06}) {
    const Pose pose{{2.0 + gap, 0.0, 0.0}};
    clear(set);
    query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, front, set);
    ASSERT_TRUE(set.contacts.empty());
    const double proven = unreported_separation(front);
    EXPECT_GE(proven, 0.05);
    EXPECT_LE(proven, gap + 0.03);  // facets
    EXPECT_GE(proven, gap > 1.0 ? 0.8 * gap : 0.05);
  }
}

}  // namespace
}  // namespace thigma
