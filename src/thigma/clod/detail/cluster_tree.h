#pragma once
// A binary tree over boxes by merging neighbours: the shape of the free levels.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/math/types.h"

namespace thigma::detail {

struct ClusterBox {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

/// Two clusters that become one. Clusters 0..n-1 are the leaves, n + i is merge i; the last merge
/// is the root.
struct Merge {
  std::int32_t left = -1, right = -1;
};

/// n - 1 merges; children come before parents. Deterministic.
///
/// boxes   of the leaves, at least one
/// Thread  [offline].
/// Source  Meister and Bittner 2018 (parallel locally-ordered clustering), run in order.
std::vector<Merge> merge_clusters(std::span<const ClusterBox> boxes);

}  // namespace thigma::detail
