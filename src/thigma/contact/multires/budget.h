#pragma once
// The query with levels of detail when tests or time are limited.

#include "thigma/contact/multires/measure_pair.h"

namespace thigma::detail {

/// As the walk without a budget, in the order of what is most needed, and no farther than the
/// budget of the query goes. The stack of the front holds the root.
void walk_within_budget(MultiresQuery& query) noexcept;

}  // namespace thigma::detail
