#pragma once
// What the contact of two patches says about the original triangles below them.

#include "thigma/contact/multires/measure_pair.h"
#include "thigma/contact/multires/patch_at_level.h"

namespace thigma::detail {

/// Bounds a pair that is apart, and moves its contact out to the distance of the culling hulls
/// where that is more.
/// node, i  memory of the pair and its place in the front, -1: none
void bound_separated(MultiresQuery& query, const PairAtLevel& pair, FrontNode& node, std::int32_t i,
                     LevelPair& out) noexcept;

/// Bounds the depth of a pair that is through.
void bound_penetrating(const MultiresQuery& query, const PairAtLevel& pair, const FrontNode& node,
                       LevelPair& out) noexcept;

}  // namespace thigma::detail
