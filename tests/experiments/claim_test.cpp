#include "experiments/common/claim.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "experiments/worse_value.h"
#include <gtest/gtest.h>

namespace thigma::experiments {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// Three rows that a claim's sweep can name.
std::vector<Table> small_tables() {
  std::vector<Table> tables = {{.columns = {"series", "x"}}, {.name = "sweep", .columns = {"x"}}};
  for (const double x : {1.0, 2.0, 3.0}) {
    add_row(tables[0], {"damping", x});
    add_row(tables[0], {x < 2.5 ? "short" : "other", x});
    add_row(tables[1], {x});
  }
  return tables;
}

Known known(double floor, const std::string& sweep = "sweep.csv") {
  return {.reason = "because", .sweep = sweep, .floor = floor};
}

/// One of each kind and comparison, none of them broken.
std::vector<Claim> one_of_each() {
  return {
      at_least("least", "", 2.0, 2.0),
      at_most("most", "", 2.0, 2.0),
      within("within", "", 5.0, 1.0, 10.0),
      above("above", "", 2.1, 2.0),
      below("below", "", 1.9, 2.0),
      stated("stated", "", -7.0),
      known_not_to(at_least("least-known", "", 1.5, 2.0), known(1.0)),
      known_not_to(at_most("most-known", "", 2.5, 2.0), known(3.0)),
      known_not_to(within("within-known", "", 0.7, 1.0, 10.0),
                   {.reason = "because", .sweep = "sweep.csv", .floor = 10.0, .floor_low = 0.5}),
      known_not_to(above("above-known", "", 2.0, 2.0), known(1.0)),
      known_not_to(below("below-known", "", 2.0, 2.0), known(3.0))};
}

TEST(Claims, compare_with_their_bound) {
  EXPECT_TRUE(at_least("a", "", 2.0, 2.0).holds);
  EXPECT_FALSE(above("a", "", 2.0, 2.0).holds);
  EXPECT_TRUE(at_most("a", "", 2.0, 2.0).holds);
  EXPECT_FALSE(below("a", "", 2.0, 2.0).holds);
  EXPECT_TRUE(within("a", "", 1.0, 1.0, 10.0).holds);
  EXPECT_TRUE(within("a", "", 10.0, 1.0, 10.0).holds);
  EXPECT_FALSE(within("a", "", 0.9, 1.0, 10.0).holds);
  EXPECT_FALSE(within("a", "", 10.1, 1.0, 10.0).holds);
}

TEST(Claims, of_every_kind_break_without_a_number) {
  for (const Claim& claim : one_of_each()) {
    EXPECT_FALSE(is_broken(claim)) << claim.id;
    for (const double none : {std::nan(""), kInf, -kInf}) {
      const Claim bad = with_value(claim, none);
      EXPECT_FALSE(bad.value.has_value()) << claim.id;
      EXPECT_TRUE(is_broken(bad)) << claim.id;
    }
  }
}

TEST(Claims, of_every_kind_break_with_a_wrong_value) {
  for (const Claim& claim : one_of_each()) {
    for (const double wrong : test::worse_values(claim))
      EXPECT_TRUE(is_broken(with_value(claim, wrong))) << claim.id << " " << wrong;
  }
}

TEST(Claims, not_reproduced_are_excused_between_bound_and_floor_only) {
  const Claim claim = known_not_to(at_least("a", "", 1.5, 2.0), known(1.0));
  EXPECT_FALSE(claim.holds);
  EXPECT_FALSE(claim.expected);
  EXPECT_FALSE(is_broken(claim));
  EXPECT_STREQ(verdict(claim), "not reproduced");
  EXPECT_FALSE(is_broken(with_value(claim, 1.0)));
  EXPECT_TRUE(is_broken(with_value(claim, 0.999)));
  EXPECT_STREQ(verdict(with_value(claim, 0.999)), "WORSE THAN KNOWN");
}

TEST(Claims, that_hold_though_marked_say_so) {
  const Claim claim = known_not_to(at_least("a", "", 3.0, 2.0), known(1.0));
  EXPECT_TRUE(claim.holds);
  EXPECT_TRUE(holds_though_marked(claim));
  EXPECT_FALSE(is_broken(claim));
  EXPECT_STREQ(verdict(claim), "holds, though marked");
  EXPECT_EQ(count_claims({claim}).marked_though_held, 1);
  EXPECT_FALSE(holds_though_marked(at_least("a", "", 3.0, 2.0)));
}

TEST(Claims, that_are_stated_never_say_that_they_hold) {
  EXPECT_STREQ(verdict(stated("a", "", 1e9)), "stated");
  EXPECT_STREQ(verdict(stated("a", "", kInf)), "NO NUMBER");
  EXPECT_STREQ(verdict(at_least("a", "", 1.0, 0.0)), "holds");
  EXPECT_STREQ(verdict(at_least("a", "", -1.0, 0.0)), "DOES NOT HOLD");
}

TEST(Claims, cannot_be_excused_without_reason_sweep_and_floor_outside_the_bound) {
  const Claim claim = at_least("a", "", 1.5, 2.0);
  EXPECT_THROW(known_not_to(claim, {.reason = "", .sweep = "data.csv", .floor = 1.0}),
               std::invalid_argument);
  EXPECT_THROW(known_not_to(claim, {.reason = "why", .sweep = "", .floor = 1.0}),
               std::invalid_argument);
  EXPECT_THROW(known_not_to(claim, known(2.5)), std::invalid_argument);
  EXPECT_THROW(known_not_to(at_most("a", "", 3.0, 2.0), known(1.0)), std::invalid_argument);
  EXPECT_THROW(known_not_to(within("a", "", 0.5, 1.0, 2.0), known(3.0)), std::invalid_argument);
  EXPECT_THROW(known_not_to(stated("a", "", 1.0), known(0.0)), std::invalid_argument);
  EXPECT_THROW(known_not_to(claim, known(std::nan(""))), std::invalid_argument);
}

TEST(Claims, are_counted_by_kind) {
  std::vector<Claim> claims = one_of_each();
  EXPECT_EQ(counts_text(count_claims(claims)),
            "11 claims: 5 checked, 1 stated, 5 not reproduced; 0 broken");
  claims[0] = with_value(claims[0], 1.0);
  claims[5] = with_value(claims[5], kInf);
  claims[6] = with_value(claims[6], 0.0);
  claims[7] = with_value(claims[7], 0.0);
  EXPECT_EQ(counts_text(count_claims(claims)),
            "11 claims: 5 checked, 1 stated, 5 not reproduced; 3 broken, 1 held though marked");
  const ClaimCounts both = count_claims({claims[0]}) + count_claims({claims[5]});
  EXPECT_EQ(counts_text(both), "2 claims: 1 checked, 1 stated, 0 not reproduced; 2 broken");
}

TEST(Claims, that_are_excused_need_three_rows_of_their_sweep) {
  const auto count = [](const std::string& sweep) {
    return faults({known_not_to(at_least("a", "", 1.5, 2.0), known(1.0, sweep))}, small_tables())
        .size();
  };
  EXPECT_EQ(count("sweep.csv"), 0u);
  EXPECT_EQ(count("data.csv:series=damping"), 0u);
  for (const char* missing : {"other.csv", "data.csv:series=short", "data.csv:series",
                              "data.csv:name=damping", "data.csv:x=1", "sweep"})
    EXPECT_EQ(count(missing), 1u) << missing;
}

TEST(Claims, stand_there_once) {
  const std::vector<Claim> claims = {at_least("a", "", 1.0, 0.0), at_most("a", "", 1.0, 2.0)};
  ASSERT_EQ(faults(claims, {}).size(), 1u);
  EXPECT_NE(faults(claims, {})[0].find("twice"), std::string::npos);
}

}  // namespace
}  // namespace thigma::experiments
