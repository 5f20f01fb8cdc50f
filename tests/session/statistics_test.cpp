#include "thigma/session/statistics.h"

#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "support/row_samples.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(HapticStatistics, KeepsExtremesSumsAndTheHash) {
  const auto t = std::make_unique<HapticStatistics>();
  HapticSample a;
  a.command.force = {3.0, 4.0, 0.0};
  a.feedback.torque = {0.0, 0.0, 0.5};  // felt, though not sent
  a.penetration = 1e-4;
  a.stretch = 0.5;  // nobody holds it
  a.model_sequence = 1;
  a.model_age = 0.002;
  HapticSample b = a;
  b.command.force = {0.0, 0.0, 1.0};
  b.penetration = -1.0;
  b.is_grasped = true;
  b.stretch = 0.25;
  accumulate(*t, a, 1000, -1);
  accumulate(*t, b, 2000, 500);
  EXPECT_EQ(t->frames, 2u);
  EXPECT_EQ(t->force_max, 5.0);
  EXPECT_EQ(t->force_square_sum, 26.0);
  EXPECT_EQ(t->torque_max, 0.5);
  EXPECT_EQ(t->penetration_max, 1e-4);
  EXPECT_EQ(t->stretch_max, 0.25);
  EXPECT_EQ(t->step_cpu.total, 2u);
  EXPECT_EQ(t->wake_late.total, 1u);
  EXPECT_EQ(t->model_age.total, 2u);
  StateHash hash;
  add_frame(hash, a.body, a.command);
  add_frame(hash, b.body, b.command);
  EXPECT_EQ(t->hash.value, hash.value);
}

TEST(HapticStatistics, SplitsAFrameAndCountsWhatWasLate) {
  const auto t = std::make_unique<HapticStatistics>();
  accumulate(*t, StageTimes{.device_read = 2000, .device_write = 500, .whole = 10000});
  accumulate(
      *t, StageTimes{.device_read = 2000, .device_write = 500, .whole = 10000, .is_overrun = true});
  EXPECT_NEAR(quantile(t->compute, 0.5), 7.5e-6, 2e-7);
  EXPECT_EQ(t->whole.total, 2u);
  EXPECT_EQ(t->overruns, 1u);
  const HapticSample sample;
  for (const std::int64_t late : {-1, 50'000, 150'000, 250'000, 5'000'000})
    accumulate(*t, sample, 0, late);
  EXPECT_EQ(t->late[0], 3u);
  EXPECT_EQ(t->late[1], 2u);
  EXPECT_EQ(t->late[2], 1u);
  EXPECT_EQ(t->wake_late.total, 4u);
}

TEST(ContactStatistics, AddsUp) {
  const auto t = std::make_unique<ContactStatistics>();
  ContactSample s;
  s.contacts = 10;
  s.clusters = 3;
  s.front = 100;
  s.dropped = 1;
  s.query_cpu = 1e-3;
  s.step_cpu = 2e-3;
  s.depth_max = -1e-4;
  s.texture_sheets = 4;
  s.texture_coarse = 3;
  s.texture_bent = 2;
  s.texture_left_out = 1;
  accumulate(*t, s);
  s.depth_max = -2e-4;
  accumulate(*t, s);
  EXPECT_EQ(t->depth_max, -1e-4);
  EXPECT_EQ(t->texture_sheets, 8u);
  EXPECT_EQ(t->texture_coarse, 6u);
  EXPECT_EQ(t->texture_bent, 4u);
  EXPECT_EQ(t->texture_left_out, 2u);
  EXPECT_EQ(t->updates, 2u);
  EXPECT_EQ(t->contacts, 20u);
  EXPECT_EQ(t->clusters, 6u);
  EXPECT_EQ(t->front, 200u);
  EXPECT_EQ(t->dropped, 2u);
  EXPECT_NEAR(quantile(t->query_cpu, 0.5), 1e-3, 2e-5);
  EXPECT_NEAR(quantile(t->step_cpu, 0.5), 2e-3, 4e-5);
  EXPECT_NEAR(quantile(t->model_cpu, 0.5), 1e-3, 2e-5);
}

using test::grasped;
using test::with_rows;

TEST(ConstraintStatistics, CountOnlyFramesWithTheObjectInTheHand) {
  HeldCounts counts;
  for (std::uint64_t i = 0; i < 40; ++i) {
    HapticSample s = grasped(i);
    s.is_grasped = i >= 20;
    s.is_held_back = i % 4 == 0;
    s.is_squeezed = i == 25;
    s.touching = i == 30 ? 5 : 1;
    s.solve_residual = i == 31 ? 1e-9 : 1e-12;
    s.wanted_speed = i < 20 ? 9.0 : 0.25;
    accumulate(counts, s);
  }
  const ConstraintSummary summary = summarize(counts, RowCounts{});
  EXPECT_EQ(counts.frames, 20u);
  EXPECT_DOUBLE_EQ(summary.held_back_share, 0.25);
  EXPECT_DOUBLE_EQ(summary.squeezed_share, 0.05);
  EXPECT_EQ(summary.active_max, 5);
  EXPECT_EQ(summary.residual_max, 1e-9);
  EXPECT_EQ(summary.wanted_speed_max, 0.25);
}

TEST(ConstraintStatistics, RowsAreThoseOfModelsThatHaveAny) {
  RowCounts counts;
  for (const std::size_t n : {0, 0, 0, 0, 3, 5, 5, 40, 256}) {
    ContactSample c = with_rows(n);
    c.travel = n == 40 ? 1e-4 : 3e-4;
    c.look_ahead = 2e-4 * static_cast<double>(n);
    c.coarse = n == 5 ? 17 : 2;
    if (n == 256) {
      c.rows = 700;
      c.travel_halvings = 3;
      c.left_out = 2;
    }
    accumulate(counts, c);
  }
  const ConstraintSummary s = summarize(HeldCounts{}, counts);
  EXPECT_EQ(s.rows_p50, 5);
  EXPECT_EQ(s.rows_max, 256);
  EXPECT_EQ(s.found_max, 700);
  EXPECT_EQ(s.halvings_max, 3);
  EXPECT_EQ(s.halved_models, 1u);
  EXPECT_EQ(s.left_out_max, 2);
  EXPECT_EQ(s.left_out_models, 1u);
  EXPECT_EQ(s.travel_min, 1e-4);
  EXPECT_EQ(s.look_ahead_max, 2e-4 * 256.0);
  EXPECT_EQ(s.coarse_max, 17);
}

TEST(ConstraintStatistics, WithoutAFrameNothingIsMadeUp) {
  const ConstraintSummary s = summarize(HeldCounts{}, RowCounts{});
  EXPECT_EQ(s.held_back_share, 0.0);
  EXPECT_EQ(s.rows_p50, 0);
  EXPECT_FALSE(std::isfinite(s.travel_min));
}

/// Every key of a list with the groups that it is in.
struct Keys {
  std::multiset<std::string> all;
  std::multiset<std::string> unknown;  // groups
  std::string inside;

  template <class Value>
  void operator()(const std::string& key, const Value&) {
    all.insert(inside + key);
  }
  template <class Fill>
  void group(const std::string& key, bool is_known, const Fill& fill) {
    if (!is_known) unknown.insert(inside + key);
    const std::string outer = inside;
    inside += key + ".";
    if (is_known) fill();
    inside = outer;
  }
};

TEST(SummaryList, EveryNumberHasAKeyOfItsOwn) {
  SessionSummary s;
  Keys keys;
  visit_summary(s, keys);
  EXPECT_EQ(keys.unknown,
            (std::multiset<std::string>{"haptic.stages_us", "haptic.deadlines", "levels.decided_by",
                                        "constraint", "friction", "passivity"}));
  s.stages.whole.count = s.wake_late.count = 1;
  s.constraint.is_on = s.friction.is_on = s.passivity.is_on = true;
  s.decided_by[0] = 1;
  Keys more;
  visit_summary(s, more);
  EXPECT_TRUE(more.unknown.empty());
  EXPECT_GT(more.all.size(), keys.all.size());
  for (const std::string& key : more.all) EXPECT_EQ(more.all.count(key), 1u) << key;
  for (const std::string& key : keys.all) EXPECT_EQ(more.all.count(key), 1u) << key;
}

TEST(SummaryList, SharesEndWithTheLastThatIsNotZero) {
  EXPECT_TRUE(shares_of(std::array<std::uint64_t, 3>{}).empty());
  EXPECT_EQ(shares_of(std::array<std::uint64_t, 4>{1, 0, 3, 0}),
            (std::vector<double>{0.25, 0.0, 0.75}));
}

TEST(Summary, TotalsAreTakenAsTheyWereGathered) {
  const auto haptic = std::make_unique<HapticStatistics>();
  haptic->frames = 4;
  haptic->force_max = 3.0;
  haptic->force_square_sum = 16.0;
  const auto contact = std::make_unique<ContactStatistics>();
  contact->updates = 2;
  contact->contacts = 3;
  contact->unrefined = 7;
  contact->depth_max = -1.0;
  const SessionSummary s = summarize(SessionConfig{}, *haptic, *contact, HapticState{});
  EXPECT_EQ(s.frames, 4u);
  EXPECT_EQ(s.force_max, 3.0);
  EXPECT_EQ(s.force_rms, 2.0);
  EXPECT_EQ(s.unrefined, 7u);
  EXPECT_EQ(s.contacts_mean, 1.5);
  EXPECT_EQ(s.penetration_max, 0.0);
}

TEST(ConstraintStatistics, TheLeastGapIsThatOfFramesInTheHand) {
  HeldCounts counts;
  for (const double penetration : {-2e-5, 3e-6, -1e-6}) {
    HapticSample s = grasped(0);
    s.penetration = penetration;
    accumulate(counts, s);
    s.is_grasped = false;
    s.penetration = 1.0;
    accumulate(counts, s);
  }
  EXPECT_EQ(summarize(counts, RowCounts{}).row_gap_min, -3e-6);
}

TEST(FrictionStatistics, ShareOfContactsThatStickAndWorkOfTheOthers) {
  const auto t = std::make_unique<HapticStatistics>();
  EXPECT_FALSE(summarize(t->slip).is_on);
  HapticSample s = grasped(0);
  s.slip = {3, 1, 2e-6};
  accumulate(*t, s, -1, -1);
  s.slip = {0, 4, 5e-6};
  accumulate(*t, s, -1, -1);
  const FrictionSummary f = summarize(t->slip);
  EXPECT_TRUE(f.is_on);
  EXPECT_DOUBLE_EQ(f.sticking_share, 3.0 / 8.0);
  EXPECT_DOUBLE_EQ(f.slip_work, 7e-6);
}

TEST(HapticStatistics, TimesSolvesWhereThereWereRows) {
  const auto t = std::make_unique<HapticStatistics>();
  HapticSample s = grasped(0);
  accumulate(*t, s, -1, -1);
  s.solve_ns = 5000;
  accumulate(*t, s, -1, -1);
  EXPECT_EQ(t->solve.total, 1u);
  EXPECT_NEAR(quantile(t->solve, 0.5), 5e-6, 1e-7);
}

}  // namespace
}  // namespace thigma
