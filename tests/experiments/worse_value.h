#pragma once
// Wrong values to plant in a claim: just beyond what it bears.

#include <cmath>
#include <limits>
#include <vector>

#include "experiments/common/claim.h"

namespace thigma::test {

/// Values with which a claim has to break: the next ones beyond its bound, or beyond its floor
/// where it is not reproduced.
inline std::vector<double> worse_values(const experiments::Claim& claim) {
  using experiments::Comparison;
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const bool is_marked = claim.kind == experiments::ClaimKind::not_reproduced;
  const double bound = (is_marked ? claim.floor : claim.bound).value_or(0.0);
  const double low = (is_marked ? claim.floor_low : claim.bound_low).value_or(0.0);
  switch (claim.comparison) {
    case Comparison::none:
      return {kInf};
    case Comparison::at_least:
      return {std::nextafter(bound, -kInf)};
    case Comparison::at_most:
      return {std::nextafter(bound, kInf)};
    case Comparison::within:
      return {std::nextafter(low, -kInf), std::nextafter(bound, kInf)};
    case Comparison::above:
    case Comparison::below:
      return {bound};
  }
  return {};
}

}  // namespace thigma::test
