#pragma once
// Contact of one pair of surface patches: separated, penetrating or passed through, from the pose alone.

#include <cstdint>

#include "thigma/convex/hull_view.h"
#include "thigma/convex/pair.h"

namespace thigma {

/// Answers, for two patches whose backs face each other, whether other surface lies between them.
/// separates(context, from, to): `from` on a, `to` on b [m; frame of a]; the open segment leaves a into its
/// material and reaches b through its material. True when it crosses the surface of a, or that of b, an odd number
/// of times: then the material ends in between (two plates lying side by side) and nothing penetrates. The ends lie
/// on the surfaces, often on edges shared with neighbours: only crossings inside the segment count.
/// A null function means that no other surface exists. Called at most once a pair. Thread [contact].
struct SegmentProbe {
  bool (*separates)(const void* context, const Vec3& from, const Vec3& to) noexcept = nullptr;
  const void* context = nullptr;
};

enum class PairContactStatus : std::uint8_t {
  apart,        // farther than the tolerance: no contact; depth is minus a lower bound of the separation
  separated,    // depth <= 0 is minus the separation of the original triangles
  penetrating,  // depth is the overlap along normal, at most half the thickness of the thinner patch
  deep,         // the same, beyond that: see pair_contact
};

/// depth = normal . (witness_a - witness_b), and witness_a - witness_b is parallel to normal.
struct PairContact {
  PairContactStatus status = PairContactStatus::apart;
  bool backs_facing = false;       // the probe was needed (whatever it said)
  std::int16_t triangle_pairs = 0;  // original triangle pairs measured, for statistics
  double depth = 0.0;              // [m]
  double separation = 0.0;         // of the original triangles, 0 where they intersect [m]
  Vec3 normal = Vec3::UnitZ();     // unit, out of a [frame of a]
  Vec3 witness_a = Vec3::Zero();   // [m; frame of a]
  Vec3 witness_b = Vec3::Zero();
};

/// Contact of two finest patches: original triangles, not hulls, decide.
///
/// a, b        views with faces, edges and triangles
/// a_from_b    relative pose
/// tolerance   d: pairs with a larger separation are `apart` [m]
/// cache       of the pair, read and written; results do not depend on it beyond rounding
/// last_normal null, or the normal this pair reported last, frame of a: among directions within 5 % of the least
///             overlap the one nearest to it is kept, and a pair that is deep keeps to it where it can
/// probe       asked only for pairs whose backs face each other within the tolerance
/// Thread      [contact]; no failure, no allocation. Without last_normal the result is a function of the pose.
PairContact pair_contact(const HullView& a, const HullView& b, const RelativePose& a_from_b, double tolerance,
                         GjkCache& cache, const Vec3* last_normal, const SegmentProbe& probe) noexcept;

}  // namespace thigma
