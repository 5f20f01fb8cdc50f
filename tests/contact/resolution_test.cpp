// What a query with levels of detail promises beside its bounds: thresholds, budgets, blending,
// memory.

#include "thigma/contact/resolution.h"

#include <vector>

#include "support/audit.h"
#include "support/ring_on_ball.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/clustering.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

struct Pair : test::RingOnBall {
  double d = 0.03;
};

const Pair& the_pair() {
  static const Pair pair;
  return pair;
}

ContactQuery query_at(double threshold, double cap = kNoCap) {
  ContactQuery query{.tolerance = the_pair().d};
  query.resolution.is_exact = false;
  query.resolution.metric.haptic = threshold;
  query.resolution.deviation_cap = cap;
  return query;
}

void ask(const ContactQuery& query, const Pose& pose, ContactFront& front, ContactSet& set) {
  clear(set);
  query_contacts({the_pair().object, pose}, {the_pair().scene}, query, front, set);
}

ContactSet room() {
  ContactSet set;
  set.contacts.reserve(100'000);
  return set;
}

TEST(Resolution, NoContactIsCoarserThanTheCoarsestLevelAllowed) {
  std::int32_t free_to = 0;
  for (const std::int32_t limit : {100, 2, 1, 0}) {
    ContactFront front;
    ContactSet set = room();
    ContactQuery query = query_at(0.5);
    query.resolution.coarsest_level = limit;
    std::int32_t coarsest = 0;
    for (int i = 0; i <= 20; ++i) {
      ask(query, test::ring_at(i / 20.0), front, set);
      for (const Contact& c : set.contacts)
        coarsest = std::max({coarsest, c.object_level, c.scene_level});
    }
    EXPECT_LE(coarsest, limit);
    if (limit == 100) free_to = coarsest;
    EXPECT_EQ(coarsest, std::min(limit, free_to)) << limit;
  }
  EXPECT_GE(free_to, 2);
}

TEST(Resolution, TellsWhatDecidedTheLevelOfEachContact) {
  const auto deciders = [](const ContactQuery& query) {
    ContactFront front;
    ContactSet set = room();
    std::array<int, kLevelDecisions> count{};
    for (int i = 0; i <= 40; ++i) {
      ask(query, test::ring_at(i / 40.0), front, set);
      for (const Contact& c : set.contacts) {
        ++count[static_cast<std::size_t>(c.decided_by)];
        EXPECT_EQ(c.decided_by == LevelDecision::finest, c.object_level == 0 && c.scene_level == 0);
      }
    }
    return count;
  };
  const auto of = [](const std::array<int, kLevelDecisions>& count, LevelDecision by) {
    return count[static_cast<std::size_t>(by)];
  };
  const auto haptic = deciders(query_at(0.1));
  EXPECT_GT(of(haptic, LevelDecision::haptic), 0);
  EXPECT_EQ(of(haptic, LevelDecision::cap) + of(haptic, LevelDecision::velocity) +
                of(haptic, LevelDecision::view) + of(haptic, LevelDecision::budget),
            0);
  EXPECT_GT(of(deciders(query_at(10.0, 0.02)), LevelDecision::cap), 0)
      << "s0 allows all, the cap does not";
  ContactQuery fast = query_at(10.0);
  fast.resolution.metric.velocity = 1e-6;
  EXPECT_GT(of(deciders(fast), LevelDecision::velocity) + of(deciders(fast), LevelDecision::finest),
            0);
  ContactQuery seen = query_at(10.0);
  seen.resolution.metric.view = {
      .pixels = 1.0, .distance = 1.0, .frustum_size = 0.1, .near_distance = 0.1, .image_size = 4.0};
  EXPECT_GT(of(deciders(seen), LevelDecision::view), 0);
  ContactQuery hurried = query_at(1e-4);
  hurried.resolution.budget_tests = 30;
  EXPECT_GT(of(deciders(hurried), LevelDecision::budget), 0);
}

TEST(Resolution, ThresholdZeroIsExactContactForContact) {
  ContactFront front, exact_front;
  ContactSet set = room(), exact = room();
  std::size_t contacts = 0;
  for (int i = 0; i <= 40; ++i) {
    ask(query_at(0.0), test::ring_at(i / 40.0), front, set);
    ask({.tolerance = the_pair().d}, test::ring_at(i / 40.0), exact_front, exact);
    ASSERT_EQ(test::first_difference(set, exact), -1) << "pose " << i;
    contacts += set.contacts.size();
  }
  EXPECT_GT(contacts, 100u);
}

// As before the levels of a scene have been built. A budget has nothing to leave coarse there.
TEST(Resolution, ABudgetWithoutLevelsLosesNoContact) {
  const ClodHierarchy ring = build_exact_hierarchy(make_torus(0.03, 0.01, 48, 24));
  const double d = 0.02 * ring.radius;
  ContactFront exact_front, front;
  reserve_front(exact_front, ring, ring);
  reserve_front(front, ring, ring);
  ContactSet exact = room(), set = room();
  Pose beside;
  beside.position = Vec3(0.0, 0.0, 0.02 + 0.5 * d);
  query_contacts({ring, beside}, {ring}, {.tolerance = d}, exact_front, exact);
  ContactQuery query{.tolerance = d};
  query.resolution.is_exact = false;
  query.resolution.budget_tests = 30;
  query_contacts({ring, beside}, {ring}, query, front, set);
  EXPECT_GT(exact.contacts.size(), 10u);
  EXPECT_EQ(set.contacts.size(), exact.contacts.size());
  EXPECT_EQ(set.dropped, 0);
}

TEST(Resolution, CoarserThresholdsMakeSmallerFronts) {
  std::int64_t fronts[3] = {};
  std::size_t coarse = 0;
  const double thresholds[3] = {0.0, 0.05, 0.5};
  ContactSet set = room();
  for (int k = 0; k < 3; ++k) {
    ContactFront front;
    for (int i = 0; i <= 20; ++i) {
      ask(query_at(thresholds[k]), test::ring_at(i / 20.0), front, set);
      fronts[k] += set.stats.front;
      for (const Contact& c : set.contacts)
        coarse += c.object_level > 0 || c.scene_level > 0 ? 1u : 0u;
    }
  }
  EXPECT_LT(fronts[1], fronts[0]);
  EXPECT_LE(fronts[2], fronts[1]);
  EXPECT_GT(coarse, 20u);
}

TEST(Resolution, FasterMotionIsCoarserAndStandstillExact) {
  ContactQuery query = query_at(0.0);
  query.resolution.metric.haptic = 0.0;
  query.resolution.metric.velocity = 0.1;
  ContactFront front, exact_front;
  ContactSet set = room(), exact = room();
  ask(query, test::ring_at(0.8), front, set);
  ask(query, test::ring_at(0.8), front, set);
  ask({.tolerance = the_pair().d}, test::ring_at(0.8), exact_front, exact);
  EXPECT_EQ(test::first_difference(set, exact), -1);
  ask(query, test::ring_at(0.81), front, set);
  std::size_t coarse = 0;
  for (const Contact& c : set.contacts) coarse += c.object_level > 0 ? 1u : 0u;
  EXPECT_GT(coarse, 0u);
}

TEST(Resolution, BudgetOfTestsIsNeverPassedAndIsReproducible) {
  ContactFront unlimited_front;
  ContactSet set = room(), again = room();
  double errors[3] = {};
  const std::int64_t budgets[3] = {30, 120, 100'000};
  for (int k = 0; k < 3; ++k) {
    ContactFront front, second;
    ContactQuery query = query_at(0.001);
    query.resolution.budget_tests = budgets[k];
    for (int i = 0; i <= 30; ++i) {
      ask(query, test::ring_at(i / 30.0), front, set);
      EXPECT_LE(set.stats.tests, std::max(budgets[k], set.stats.mandatory_tests));
      if (k == 2) {
        EXPECT_EQ(set.stats.unrefined, 0);
      }
      ask(query, test::ring_at(i / 30.0), second, again);
      EXPECT_EQ(test::first_difference(set, again), -1);
      for (const Contact& c : set.contacts)
        errors[k] += c.bound / static_cast<double>(set.contacts.size());
    }
  }
  EXPECT_GE(errors[0], errors[1]);
  EXPECT_GT(errors[1], errors[2]);
}

TEST(Resolution, BudgetThatIsAmpleAnswersAsWithout) {
  ContactFront front, other;
  ContactSet set = room(), free = room();
  ContactQuery query = query_at(0.01);
  for (int i = 0; i <= 20; ++i) {
    query.resolution.budget_tests = 0;
    ask(query, test::ring_at(i / 20.0), front, free);
    query.resolution.budget_tests = 1'000'000;
    ask(query, test::ring_at(i / 20.0), other, set);
    EXPECT_EQ(test::first_difference(set, free), -1) << "pose " << i;
  }
}

TEST(Resolution, FullFrontAnswersTheSame) {
  ContactFront front, tiny;
  reserve_front(tiny, the_pair().object, the_pair().scene, 16);
  ContactSet set = room(), other = room();
  for (int i = 0; i <= 20; ++i) {
    ask(query_at(0.01), test::ring_at(i / 20.0), front, set);
    ask(query_at(0.01), test::ring_at(i / 20.0), tiny, other);
    EXPECT_EQ(test::first_difference(set, other), -1) << "pose " << i;
  }
}

TEST(Resolution, NothingIsAllocatedAfterTheFirstQuery) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  ContactFront front;
  ContactSet set = room();
  ContactQuery query = query_at(0.01);
  ask(query, test::ring_at(0.0), front, set);
  const test::AuditScope watched;
  for (int i = 0; i <= 100; ++i) {
    query.resolution.budget_tests = i % 3 == 0 ? 60 : 0;
    ask(query, test::ring_at(i / 100.0), front, set);
  }
  EXPECT_EQ(watched.counts().allocations, 0);
  EXPECT_EQ(watched.counts().frees, 0);
}

// How unsteadily the weighted sum of depth + d along the normals changes over a fine path: squares
// of its second differences, to which a jump of any contact adds and steady motion does not.
double unsteadiness(double threshold, bool interpolates) {
  ContactFront front;
  ContactSet set = room();
  ContactQuery query = query_at(threshold);
  query.resolution.interpolates = interpolates;
  Vec3 last = Vec3::Zero(), last_step = Vec3::Zero();
  double sum_of_squares = 0.0;
  for (int i = 0; i <= 600; ++i) {
    ask(query, test::ring_at(0.4 + 0.6 * i / 600.0), front, set);
    Vec3 sum = Vec3::Zero();
    for (const Contact& c : set.contacts) {
      sum += c.weight * std::max(c.depth + the_pair().d, 0.0) * c.normal;
    }
    const Vec3 step = sum - last;
    if (i > 1) sum_of_squares += (step - last_step).squaredNorm();
    last = sum;
    last_step = step;
  }
  return sum_of_squares;
}

TEST(Resolution, BlendingTakesAwayJumps) {
  double blended = 0.0, plain = 0.0;
  for (const double threshold : {0.01, 0.025, 0.05}) {
    blended += unsteadiness(threshold, true);
    plain += unsteadiness(threshold, false);
  }
  EXPECT_LT(blended, plain);
}

}  // namespace
}  // namespace thigma
