#pragma once
// How much a figure owes to the poses it was taken at: the poses drawn again, with repetitions.

#include <cstdint>
#include <vector>

namespace thigma::experiments::level_choice {

/// A quotient of sums over poses, by pose.
struct PoseShare {
  std::vector<double> over, under;
};

/// How many times one quotient is another, and 95 % of what drawn poses give.
struct Growth {
  double value = 0.0, low = 0.0, high = 0.0;
};

/// Same poses in both, in the same order; neighbours resemble each other, so that the interval is
/// narrow rather than wide.
/// is_squared  quotients are of squares: the roots are compared
/// seed        of the draws
/// Thread      [offline]; NaN where nothing is.
Growth growth_between(const PoseShare& from, const PoseShare& to, bool is_squared,
                      std::uint64_t seed);

/// How widely values are spread: their 90 % quantile over their 10 % quantile, and 95 % of what
/// drawn poses give. One pose unlike the others moves the quotient, and not the lower end.
///
/// values  > 0, by pose
/// seed    of the draws
/// Thread  [offline]; NaN where nothing is.
Growth spread_of(const std::vector<std::vector<double>>& values, std::uint64_t seed);

}  // namespace thigma::experiments::level_choice
