// The interval of the least separation against the exact query, and what it costs and remembers.

#include "thigma/contact/least_separation.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "support/audit.h"
#include "support/ring_on_ball.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

struct Pair : test::RingOnBall {
  double d = 0.05;
};

const Pair& the_pair() {
  static const Pair pair;
  return pair;
}

double smaller_radius() { return std::min(the_pair().object.radius, the_pair().scene.radius); }

ContactSet ask(const Pose& pose, double threshold) {
  ContactQuery query{.tolerance = the_pair().d};
  query.resolution.is_exact = !(threshold > 0.0);
  query.resolution.metric.haptic = threshold;
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(100'000);
  query_contacts({the_pair().object, pose}, {the_pair().scene}, query, front, set);
  return set;
}

SeparationInterval narrow(const Pose& pose, const ContactSet& set, SeparationScratch& scratch,
                          double width = 0.01, std::int64_t budget = 100'000) {
  const SeparationQuery query{.tolerance = the_pair().d, .width = width, .budget = budget};
  return least_separation({the_pair().object, pose}, {the_pair().scene}, set, query, scratch);
}

/// Of the contacts' own bounds [m].
double width_of_bounds(const ContactSet& set) {
  double low = kInfinity, high = kInfinity;
  for (const Contact& c : set.contacts) {
    low = std::min(low, -c.depth - c.bound);
    high = std::min(high, -c.depth + c.bound);
  }
  return high - low;
}

bool same_bits(const SeparationInterval& x, const SeparationInterval& y) {
  return std::memcmp(&x.low, &y.low, sizeof x.low) == 0 &&
         std::memcmp(&x.high, &y.high, sizeof x.high) == 0 && x.expansions == y.expansions;
}

TEST(LeastSeparation, HoldsTheExactOneWithinTheWidthAskedFor) {
  SeparationScratch scratch;
  int touching = 0, inside = 0, narrower = 0;
  for (const double threshold : {0.0025, 0.025, 0.2}) {
    for (const double width : {0.0, 0.001, 0.01, 0.1}) {
      for (int i = 0; i <= 40; ++i) {
        SCOPED_TRACE("s0 " + std::to_string(threshold) + " width " + std::to_string(width) +
                     " pose " + std::to_string(i));
        const Pose pose = test::ring_at(i / 40.0);
        const ContactSet exact = ask(pose, 0.0), levels = ask(pose, threshold);
        if (levels.contacts.empty()) continue;
        const double truth = least_distance(exact), rounding = 1e-9 * smaller_radius();
        const SeparationInterval found = narrow(pose, levels, scratch, width);
        EXPECT_TRUE(found.is_narrow);
        EXPECT_LE(found.low, truth + rounding);
        EXPECT_GE(found.high, std::min(truth, the_pair().d) - rounding);
        if (found.low < the_pair().d) {
          EXPECT_LE(found.high - found.low, width * smaller_radius() + rounding);
        }
        if (exact.contacts.empty()) continue;
        ++touching;
        if (truth < 0.0) ++inside;
        if (found.high - found.low < 0.5 * width_of_bounds(levels)) ++narrower;
      }
    }
  }
  EXPECT_GT(touching, 200);
  EXPECT_GT(inside, 50);
  EXPECT_GT(narrower, touching / 2);
}

TEST(LeastSeparation, IsTheExactContactsOwnWhereThereAreNoLevels) {
  SeparationScratch scratch;
  const Pose pose = test::ring_at(0.7);
  const ContactSet exact = ask(pose, 0.0);
  const SeparationInterval found = narrow(pose, exact, scratch);
  EXPECT_EQ(found.low, least_distance(exact));
  EXPECT_EQ(found.high, least_distance(exact));
  EXPECT_EQ(found.expansions, 0);
}

TEST(LeastSeparation, IsAFunctionOfPoseAndContacts) {
  SeparationScratch used, fresh;
  for (int i = 0; i <= 20; ++i)
    narrow(test::ring_at(i / 20.0), ask(test::ring_at(i / 20.0), 0.2), used);
  const Pose pose = test::ring_at(0.8);
  const ContactSet set = ask(pose, 0.2);
  const SeparationInterval first = narrow(pose, set, used), second = narrow(pose, set, fresh);
  EXPECT_GT(first.expansions, 0);
  EXPECT_TRUE(same_bits(first, second));
}

TEST(LeastSeparation, EndsWithTheBudgetAndStaysHonest) {
  SeparationScratch scratch;
  const Pose pose = test::ring_at(0.8);
  const ContactSet set = ask(pose, 0.2);
  const double truth = least_distance(ask(pose, 0.0));
  const std::int64_t all = narrow(pose, set, scratch, 0.0).expansions;
  ASSERT_GT(all, 10);
  double last = kInfinity;
  for (const std::int64_t budget : {std::int64_t{0}, all / 4, all / 2, all}) {
    const SeparationInterval found = narrow(pose, set, scratch, 0.0, budget);
    EXPECT_LE(found.expansions, budget);
    EXPECT_EQ(found.is_narrow, budget == all);
    EXPECT_LE(found.low, truth + 1e-9);
    EXPECT_GE(found.high, truth - 1e-9);
    EXPECT_LE(found.high - found.low, last);
    last = found.high - found.low;
  }
}

TEST(LeastSeparation, SaysSoWhereThereIsNoRoom) {
  SeparationScratch scratch;
  reserve_separation(scratch, the_pair().object, the_pair().scene, 2);
  const Pose pose = test::ring_at(0.8);
  const double truth = least_distance(ask(pose, 0.0));
  const SeparationInterval found = narrow(pose, ask(pose, 0.2), scratch, 0.0);
  EXPECT_FALSE(found.is_narrow);
  EXPECT_LE(found.low, truth);
  EXPECT_GE(found.high, truth);
}

TEST(LeastSeparation, SearchesFromTheRootsWhereContactsWereDropped) {
  SeparationScratch scratch;
  const Pose pose = test::ring_at(0.8);
  ContactSet set = ask(pose, 0.025);
  std::sort(set.contacts.begin(), set.contacts.end(),
            [](const Contact& x, const Contact& y) { return x.depth < y.depth; });
  set.dropped = static_cast<std::int64_t>(set.contacts.size()) - 1;
  ASSERT_GT(set.dropped, 0);
  set.contacts.resize(1);
  const SeparationInterval found = narrow(pose, set, scratch);
  const double truth = least_distance(ask(pose, 0.0));
  EXPECT_TRUE(found.is_narrow);
  EXPECT_LE(found.low, truth);
  EXPECT_GE(found.high, truth);
}

TEST(LeastSeparation, SaysNothingOfAPoseThatIsNotFinite) {
  SeparationScratch scratch;
  Pose pose = test::ring_at(0.8);
  const ContactSet set = ask(pose, 0.2);
  pose.position.x() = std::numeric_limits<double>::quiet_NaN();
  const SeparationInterval found = narrow(pose, set, scratch);
  EXPECT_EQ(found.low, -kInfinity);
  EXPECT_EQ(found.high, kInfinity);
}

TEST(LeastSeparation, OfOtherBodiesTakesNoContact) {
  SeparationScratch scratch;
  const Pose pose = test::ring_at(0.8);
  const SeparationQuery query{.tolerance = the_pair().d, .body = 1};
  const SeparationInterval found = least_separation({the_pair().object, pose}, {the_pair().scene},
                                                    ask(pose, 0.2), query, scratch);
  EXPECT_EQ(found.low, the_pair().d);
  EXPECT_EQ(found.high, kInfinity);
}

TEST(LeastSeparation, AllocatesNothingOnceWarm) {
  if (test::why_no_audit() != nullptr) GTEST_SKIP() << test::why_no_audit();
  SeparationScratch scratch;
  reserve_separation(scratch, the_pair().object, the_pair().scene);
  const Pose pose = test::ring_at(0.8);
  const ContactSet set = ask(pose, 0.2);
  const test::AuditScope watched;
  const SeparationInterval found = narrow(pose, set, scratch, 0.0);
  EXPECT_EQ(watched.counts().allocations, 0);
  EXPECT_EQ(watched.counts().frees, 0);
  EXPECT_GT(found.expansions, 0);
}

}  // namespace
}  // namespace thigma
