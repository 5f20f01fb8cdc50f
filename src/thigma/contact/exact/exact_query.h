#pragma once
// The exact contact query: every pair of finest patches whose triangles come within the tolerance.

#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

/// Contacts of finest patches, appended in order, and counts. Without keep_directions every bit is
/// a function of the two poses. Thread [contact]. Source: Sec. 3.4.1-3.4.2.
void query_exact(QueryFrame& frame) noexcept;

}  // namespace thigma::detail
