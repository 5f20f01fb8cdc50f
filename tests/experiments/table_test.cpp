#include "experiments/common/table.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace thigma::experiments {
namespace {

TEST(Table, WritesNumbersThatReadBackTheSame) {
  Table table{.columns = {"force [N]", "what"}};
  add_row(table, {0.1, "a"});
  add_row(table, {1.0 / 3.0, "b"});
  add_row(table, {-2.0, "c"});
  EXPECT_EQ(csv_text(table), "force [N],what\n0.1,a\n0.3333333333333333,b\n-2,c\n");
}

TEST(Table, LeavesOutWhatIsNoNumber) {
  Table table{.columns = {"a", "b"}};
  add_row(table, {std::nan(""), std::numeric_limits<double>::infinity()});
  EXPECT_EQ(csv_text(table), "a,b\n,\n");
}

TEST(Table, QuotesWhatWouldBreakARow) {
  Table table{.columns = {"a, b"}};
  add_row(table, {"say \"x\"\nplease"});
  EXPECT_EQ(csv_text(table), "\"a, b\"\n\"say \"\"x\"\"\nplease\"\n");
}

}  // namespace
}  // namespace thigma::experiments
