#pragma once
// Pairs that are certain to be within the tolerance, of which the nearest alone are measured.

#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

/// What is certain of a leaf pair that has not been measured.
enum class Nearness : std::uint8_t { unknown, within, beyond };

/// Whether this query, which carries contacts, is asked to hold pairs.
bool may_hold(const QueryFrame& frame) noexcept;

/// Begins. `leaves`: pairs there are at most.
/// returns  whether the set has room for all, so that pairs can be held
bool begin_holding(QueryFrame& frame, std::size_t leaves) noexcept;

/// Keeps the distance of the hulls of the leaf pair at place i of the front; of one that is not
/// certain nothing.
void keep_hulls(QueryFrame& frame, std::int32_t i, const Separation& hulls) noexcept;

/// Of the leaf pair at place i of the front, by its hulls where what is known of it does not say.
/// least  it may be as near as that; of `unknown` nothing [m]
Nearness nearness_of(QueryFrame& frame, std::int32_t i, double& least) noexcept;

/// Reports a pair that is within the tolerance, its contact to be filled in.
/// returns  whether there is room for it
bool hold_pair(QueryFrame& frame, std::int32_t i, double least) noexcept;

/// Measures those of the held pairs that may be nearest, and fills in the contacts of all.
void fill_held(QueryFrame& frame, const SegmentProbe& probe) noexcept;

}  // namespace thigma::detail
