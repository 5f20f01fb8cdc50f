#pragma once
// The front of the exact query: culled pairs of nodes, and leaf pairs that are measured each frame.

#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

/// The larger of two nodes is split. The rule sees the pair only, so every pair is reached in one
/// way.
bool splits_a(const QueryFrame& frame, std::int32_t a, std::int32_t b) noexcept;

/// Brings the front to the poses of a frame and measures no contact. False where there is no
/// memory for it. query_exact does so itself; for who times the two halves apart.
bool track_exact(QueryFrame& frame) noexcept;

}  // namespace thigma::detail
