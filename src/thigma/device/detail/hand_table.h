#pragma once
// The parameters of `hand:` as an address names them: one row each, for parsing, checking and
// listing.

#include <span>
#include <string_view>

#include "thigma/device/hand.h"

namespace thigma::detail {

/// One number a person may set.
struct HandNumber {
  std::string_view name, unit, meaning;
  double low, high;  // allowed, both ends included
  double& (*field)(HandParams& params);
};

/// In the order of --help. Thread [offline].
std::span<const HandNumber> hand_numbers();

}  // namespace thigma::detail
