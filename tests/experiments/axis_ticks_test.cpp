#include "experiments/common/axis_ticks.h"

#include <cmath>

#include <gtest/gtest.h>

namespace thigma::plot {
namespace {

std::vector<std::string> labels(const Scale& scale) {
  std::vector<std::string> named;
  for (const Tick& t : scale.ticks) {
    if (!t.label.empty()) named.push_back(t.label);
  }
  return named;
}

TEST(AxisTicks, AreRoundNumbersThatCoverTheData) {
  const Scale scale = make_scale(0.13, 0.97, false, 5);
  EXPECT_LE(scale.low, 0.13);
  EXPECT_GE(scale.high, 0.97);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
}

TEST(AxisTicks, StayWithinEndsThatAreGiven) {
  const Scale scale = make_scale(0.0, 11.0, false, 5, false, false);
  EXPECT_EQ(scale.low, 0.0);
  EXPECT_EQ(scale.high, 11.0);
  EXPECT_EQ(labels(scale), (std::vector<std::string>{"0", "5", "10"}));
}

TEST(AxisTicks, SurviveDataWithoutExtent) {
  for (const double v : {0.0, 3.0, -2.0}) {
    const Scale scale = make_scale(v, v, false, 5);
    EXPECT_LT(scale.low, v);
    EXPECT_GT(scale.high, v);
    EXPECT_GE(labels(scale).size(), 2u);
  }
}

TEST(AxisTicks, NameTheDecadesOfALogarithmicAxis) {
  EXPECT_EQ(labels(make_scale(1.0, 1e7, true, 8)),
            (std::vector<std::string>{"1", "10", "100", "1000", "10000", "10⁵", "10⁶", "10⁷"}));
  EXPECT_EQ(labels(make_scale(1e-6, 1e-4, true, 8)),
            (std::vector<std::string>{"10⁻⁶", "10⁻⁵", "0.0001"}));
}

TEST(AxisTicks, NameMoreWhereADecadeOrLessIsShown) {
  EXPECT_EQ(labels(make_scale(0.9, 12.0, true, 5)),
            (std::vector<std::string>{"1", "2", "5", "10"}));
}

TEST(AxisTicks, PlaceValuesBetweenTheEnds) {
  EXPECT_DOUBLE_EQ(position(Scale{2.0, 6.0, false, {}}, 3.0), 0.25);
  EXPECT_DOUBLE_EQ(position(Scale{1.0, 100.0, true, {}}, 10.0), 0.5);
  EXPECT_FALSE(std::isfinite(position(Scale{1.0, 100.0, true, {}}, 0.0)));
}

}  // namespace
}  // namespace thigma::plot
