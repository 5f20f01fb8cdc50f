#pragma once
// The contact query that chooses its resolution, pair by pair.

#include "thigma/contact/detail/front_nodes.h"

namespace thigma::detail {

/// Contacts at the resolution the query asks for, appended in order, and counts. Without a budget
/// and without keep_directions every bit is a function of the two poses (and, with the velocity
/// metric, of the pose before). Thread [contact]. Source: Sec. 3.4.2-3.4.4.
void query_multires(QueryFrame& frame) noexcept;

}  // namespace thigma::detail
