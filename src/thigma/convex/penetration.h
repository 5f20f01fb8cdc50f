#pragma once
// Contact of one pair of surface patches: separated, penetrating or passed through, from the pose
// alone.

#include <cstdint>

#include "thigma/convex/gjk.h"
#include "thigma/convex/hull_view.h"
#include "thigma/convex/patch_separation.h"

namespace thigma {

/// From the closest point of one patch to that of another, whose backs face each other.
struct ProbeSegment {
  Vec3 from, to;  // on a, on b [m; frame of a]
  // The end is a vertex of its patch. Faces of other patches may meet there, which nobody has
  // looked at: whether the segment leaves into material is still to be seen.
  bool from_vertex = false, to_vertex = false;
};

/// Answers, for two patches whose backs face each other, whether other surface lies between them.
/// separates(context, segment): the open segment leaves a into its material and reaches b through
/// its material. True when it crosses the surface of a, or that of b, an odd number of times: then
/// the material ends in between (two plates lying side by side) and nothing penetrates; true as
/// well where it leaves a vertex into the open. The ends lie on the surfaces, often on edges shared
/// with neighbours: only crossings inside the segment count. A null function means that no other
/// surface exists. Called at most once a pair.
/// Thread    [contact].
struct SegmentProbe {
  bool (*separates)(const void* context, const ProbeSegment& segment) noexcept = nullptr;
  const void* context = nullptr;
};

enum class PairContactStatus : std::uint8_t {
  apart,  // farther than the tolerance: no contact; depth is minus a lower bound of the separation
  separated,    // depth <= 0 is minus the separation of the original triangles
  penetrating,  // depth is the overlap along normal, at most half the thickness of the thinner
                // patch
  deep,         // the same, beyond that: see pair_contact
  grazing,      // through, but still mostly side by side: depth <= 0, between minus the
                // separation and the overlap
};

/// depth = normal . (witness_a - witness_b), and witness_a - witness_b is parallel to normal.
struct PairContact {
  PairContactStatus status = PairContactStatus::apart;
  bool backs_facing = false;        // the probe was needed (whatever it said)
  std::int16_t triangle_pairs = 0;  // original triangle pairs measured, for statistics
  double depth = 0.0;               // [m]
  double separation = 0.0;          // of the original triangles, 0 where they intersect [m]
  std::uint32_t feature_a = 0, feature_b = 0;  // masks of the hull vertices that span the closest
                                               // features; 0 where triangles intersect
  Vec3 normal = Vec3::UnitZ();                 // unit, out of a [frame of a]
  Vec3 witness_a = Vec3::Zero();               // [m; frame of a]
  Vec3 witness_b = Vec3::Zero();
};

/// How far the backs of two patches face each other: the least sine by which the direction from the
/// closest point of a to that of b lies behind the real faces that hold the points; where it lies
/// before one, any sine that says so, not above 0. > 0: only pair_contact, with its probe, can tell
/// through from side by side. A caller with a faster way to closest points asks this before it
/// calls a pair separated.
///
/// feature_a, feature_b  masks of the hull vertices that span the closest features
/// direction             unit, from the closest point of a to that of b [frame of a]
/// Thread                [contact]; no failure, no allocation.
double backs_facing(const HullPair& pair, std::uint32_t feature_a, std::uint32_t feature_b,
                    const Vec3& direction) noexcept;

/// Contact of two finest patches: original triangles, not hulls, decide.
///
/// Separated. The original triangles share no point and do not face each other back to back: depth
/// is minus their separation, normal the direction from the closest point of a to that of b.
///
/// Penetrating. Original triangles intersect; or a is through b: the closest points see each other
/// from behind every real face that holds them, and those over convex edges that do (RealEdge), on
/// both sides, and the probe finds nothing in between. A patch is thin, so pairs are through at
/// once; a pair is judged by its pose alone and needs no history.
///
/// Depth of a penetrating pair: the largest normal . p over the vertices p of a, minus the least
/// over those of b (hulls and triangles share the vertices), along the allowed direction of least
/// depth. Allowed are normals of real faces of a, minus normals of real faces of b, and crosses of
/// a real edge of each that lie within both edges' cones of real normals. Never along a virtual
/// face, so never out through the back. At the border of a patch the cone reaches to the normal of
/// the face beyond (RealEdge), at least 17 degrees outwards. Depth is 0 at touch from the front,
/// and depth * normal is continuous there.
///
/// Grazing. A pair that is through, with its closest points far apart sideways, turns gradually, in
/// proportion to how far the line between the points opposes that direction: depth goes from minus
/// the separation to the overlap, normal from the direction between the points to the allowed one,
/// witnesses lie on both sides of the middle of the points. While depth <= 0 its status is
/// `grazing`.
///
/// Deep. depth exceeds half the thickness of the thinner patch: overlap and direction are reported
/// as above, but the patch alone no longer bounds the way out; a caller with memory keeps
/// last_normal, one without may ask a thicker ancestor. Triangles and coplanar patches have
/// thickness 0, so every penetration of theirs is deep.
///
/// Deep inside. A body far inside another has no surfaces within the tolerance: no contact. Where
/// its front comes within the tolerance of the other's back (about to leave), the pair is separated
/// and pushes it back in.
///
/// pair         views with faces, edges and triangles
/// tolerance    d: pairs with a larger separation are `apart` [m]
/// cache        of the pair, read and written; results do not depend on it beyond rounding
/// last_normal  null, or the normal this pair reported last, frame of a: among directions within
///              5 % of the least overlap (itself included) the one nearest to it is kept
/// probe        asked only for pairs whose backs face each other within the tolerance
/// returns      witnesses: separated, the closest points; through, the two ends of the overlap
///              along normal through the middle of the closest points (or of the intersections), on
///              the supporting planes of a and b
/// Thread       [contact]; no failure, no allocation. Without last_normal the result is a function
///              of the pose.
/// Source       Sec. 3.4.2 asks for the local penetration; the contract is this project's.
PairContact pair_contact(const HullPair& pair, double tolerance, GjkCache& cache,
                         const Vec3* last_normal, const SegmentProbe& probe) noexcept;

/// The same for a caller that has measured the triangles: `gap` is patch_separation of the two with
/// `tolerance` as its stop.
PairContact pair_contact(const HullPair& pair, double tolerance, const PatchSeparation& gap,
                         const Vec3* last_normal, const SegmentProbe& probe) noexcept;

}  // namespace thigma
