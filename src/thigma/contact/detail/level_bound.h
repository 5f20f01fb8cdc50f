#pragma once
// What the contact of two patches says about the original triangles below them.

#include "thigma/contact/detail/level_measure.h"
#include "thigma/contact/detail/level_side.h"

namespace thigma::detail {

/// Bounds a pair that is apart, and moves its contact out to the distance of the culling hulls
/// where that is more.
/// below  how far the original triangles may be behind the closest points, both together [m]
/// n, i   memory of the pair and its place in the front, -1: none
void bound_separated(LevelQuery& q, const Side& a, const Side& b, double below, FrontNode& n,
                     std::int32_t i, LevelPair& out) noexcept;

/// Bounds the depth of a pair that is through.
void bound_penetrating(const LevelQuery& q, const Side& a, const Side& b, const FrontNode& n,
                       LevelPair& out) noexcept;

}  // namespace thigma::detail
