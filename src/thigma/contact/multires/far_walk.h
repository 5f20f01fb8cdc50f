#pragma once
// The query with levels of detail for rows: finest patches near, coarse ones where they are proven
// apart.

#include "thigma/contact/multires/measure_pair.h"

namespace thigma::detail {

/// Contacts of finest patches, and of pairs that stay coarse (Resolution::exact_within): these with
/// the distance and the normal of the hulls of their nodes, and the bound that follows. The stack
/// of the front holds the root.
void walk_far(MultiresQuery& query) noexcept;

}  // namespace thigma::detail
