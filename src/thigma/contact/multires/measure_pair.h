#pragma once
// One pair of patches of any levels: the contact between them, how much detail it deserves, and
// what it says about the original triangles below.

#include "thigma/contact/detail/front_nodes.h"
#include "thigma/contact/surface_crossing.h"

namespace thigma::detail {

/// What a query with levels keeps for all its pairs.
struct MultiresQuery {
  QueryFrame& frame;
  const Resolution& resolution;
  CrossingContext crossing;  // of the query, for probes
  RelativePose last;         // the pose before [frame of the object]
  bool has_last = false;
  bool is_haptic_alone = false;  // the threshold is the same everywhere
  bool is_of_pair = false;       // so is s* of a pair: its level does not depend on the pose
  double threshold = 0.0;        // s0 of the haptic metric [m]
  double deviation_cap = 0.0;    // on s_a + s_b [m]
  float now = 0.0f;              // travel, rounded so that nothing expires too late
  bool is_carrying = false;
};

MultiresQuery make_multires_query(QueryFrame& frame) noexcept;

/// A node of merged hulls alone: nothing to measure a contact on.
inline bool is_free(const ClodNode& node) noexcept {
  return node.child_count > 0 && node.contact < 0;
}

/// Of each node's patch the largest support areas of its vertices, of both readings of the text,
/// and the D of SupportReading::patch; empty without simplified levels. Thread [offline].
std::vector<std::array<double, kSupportReadings>> support_of_nodes(const ClodHierarchy& hierarchy);

/// Whether a pair near its threshold shares its contact with its children (Sec. 3.4.4): where the
/// level is of the pair nothing changes that would be felt.
inline bool is_blended(const MultiresQuery& query) noexcept {
  return query.resolution.interpolates && !query.is_of_pair;
}

/// A pair that no measurement can keep from being split: free nodes, deviations above the cap,
/// features too large for any support area its patches have. Where the level is of the pair, with
/// no budget, that is every pair to be split but those whose bound does not hold.
bool is_always_refined(const MultiresQuery& query, const FrontNode& node) noexcept;

/// A measured pair, not both finest.
struct LevelPair {
  // status apart: farther than any contact at or below could be, depth minus a lower bound
  PatchPair pair;
  double reach = 0.0;  // separation up to which the pair could matter [m]
  // s* / s0; above 1 it has to be refined. Infinite where the bound would not hold
  double priority = 0.0;
  LevelDecision decided_by = LevelDecision::finest;
  double bound = 0.0;    // see Contact [m]
  double nearest = 0.0;  // the separation of the original triangles is not below this [m]
};

/// Measures a pair that is open, counts it, and bounds the original triangles below.
/// node  memory of the pair
/// i     its place in the front, whose timer may be refreshed; -1: none
LevelPair measure_level_pair(MultiresQuery& query, FrontNode& node, std::int32_t i) noexcept;

}  // namespace thigma::detail
