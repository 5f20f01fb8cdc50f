#pragma once
// Pairs that are certain to be within the tolerance, of which the nearest alone are measured.

#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

/// Whether this query, which carries contacts, is asked to hold pairs.
bool may_hold(const QueryFrame& frame) noexcept;

/// Begins.
/// returns  whether pairs can be held: the set has room for all, and the hand is not slow
bool begin_holding(QueryFrame& frame) noexcept;

/// Keeps the distance of the hulls of the leaf pair at place i of the front; of one that is not
/// certain nothing.
void keep_hulls(QueryFrame& frame, std::int32_t i, const Separation& hulls) noexcept;

/// Whether the hulls of the leaf pair at place i of the front are certain to be apart and within
/// the tolerance; they are searched where what is known of them does not say.
/// least  they may be as near as that, where they are [m]
bool is_certain(QueryFrame& frame, std::int32_t i, double& least) noexcept;

/// Reports a pair that is within the tolerance, its contact to be filled in.
/// returns  whether there is room for it
bool hold_pair(QueryFrame& frame, std::int32_t i, double least) noexcept;

/// Measures those of the held pairs that may be nearest, and fills in the contacts of all.
void fill_held(QueryFrame& frame, const SegmentProbe& probe) noexcept;

}  // namespace thigma::detail
