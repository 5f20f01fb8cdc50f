#pragma once
// Contact of one pair of patches, bit-identical whatever is remembered of the pair.

#include "thigma/contact/contact.h"
#include "thigma/contact/front.h"
#include "thigma/convex/penetration.h"

namespace thigma::detail {

/// What a leaf pair of the traversal is.
struct PatchPair {
  PairContactStatus status = PairContactStatus::apart;
  double depth = 0.0;             // apart: minus a lower bound of the separation [m]
  Vec3 normal = Vec3::UnitZ();    // unit, out of a [frame of a]
  Vec3 witness_a = Vec3::Zero();  // [m; frame of a]
  Vec3 witness_b = Vec3::Zero();
  double separation = 0.0;  // of the triangles, 0 where they intersect; not of `apart` [m]
  // hull vertices of the closest features; 0 where triangles intersect
  std::uint32_t feature_a = 0, feature_b = 0;
  bool is_of_hulls = false;  // the hulls are apart, and it is their distance; not of `apart`
};

/// Decides whether a pair is measured to the end: `decide(context, feature_a, feature_b, point_a,
/// point_b)`, points in the frame of a, sees where the triangles are closest or meet. False: the
/// result holds these alone, its depth 0 and its normal any. Null: every pair is.
struct EarlyDecision {
  bool (*decide)(void* context, std::uint32_t feature_a, std::uint32_t feature_b,
                 const Vec3& point_a, const Vec3& point_b) noexcept = nullptr;
  void* context = nullptr;
};

/// Two patches to be measured.
struct PatchQuery {
  HullView a, b;
  const RelativePose& a_from_b;
  double tolerance = 0.0;        // pairs with a larger separation are `apart` [m]
  bool measures_hulls = false;   // see ContactQuery
  bool keeps_direction = false;  // that of the contact reported last, if it is nearly as good
  SegmentProbe probe{};
  EarlyDecision early{};  // asked of every pair that is not apart
};

/// Measures two patches.
///
/// memory   of the pair: support vertices, simplex and, with keeps_direction, the normal reported
///          last
/// stats    pair_queries and triangle_pairs are counted
/// returns  a function of the pose alone unless keeps_direction
/// Thread   [contact]; no failure, no allocation.
PatchPair measure_patches(const PatchQuery& query, FrontNode& memory, QueryStats& stats) noexcept;

}  // namespace thigma::detail
