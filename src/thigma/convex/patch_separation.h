#pragma once
// Distance and intersection of the original triangles of two patches.

#include <cstdint>

#include "thigma/convex/gjk.h"
#include "thigma/convex/hull_view.h"

namespace thigma {

/// Separation of the original triangles of two patches.
struct PatchSeparation {
  bool intersecting = false;    // some pair of original triangles shares a point
  double distance = 0.0;        // least over the triangle pairs, 0 when intersecting [m]
  Vec3 point_a = Vec3::Zero();  // closest points; intersecting: the mean point of the intersections
                                // [frame of a]
  Vec3 point_b = Vec3::Zero();
  int triangle_a = -1,
      triangle_b = -1;  // into the hulls' triangles; -1 farther than stop, points invalid
  // Masks of the hull vertices that span the closest feature, 0 unknown; intersecting: corners of
  // the triangles that do.
  std::uint32_t feature_a = 0, feature_b = 0;
  int triangle_pairs = 0;  // measured
};

/// Least separation of the original triangles of two patches (not of their hulls, which have
/// virtual faces).
///
/// stop      pairs farther apart than this need not be exact: then distance is a lower bound > stop
///           [m]
/// cache     of the hull pair
/// Thread    [contact]; no failure, no allocation.
PatchSeparation patch_separation(const HullPair& pair, double stop, GjkCache& cache) noexcept;

/// Two triangles, one of each patch, that may be the nearest, and whether triangles met; anything
/// is valid.
struct TriangleHint {
  std::uint8_t a = 0xff, b = 0xff;
  bool meet = false;
};

/// The same without looking at the hulls: for a caller who knows that they overlap or nearly do, or
/// that their closest points lie on virtual faces. A function of patches, pose and stop alone, bit
/// for bit, whatever the hint.
///
/// disjoint  the hulls are known not to overlap: triangles are not asked whether they pierce each
///           other
/// hint      read to leave out pairs sooner, and set to the pair found
PatchSeparation triangle_separation(const HullPair& pair, double stop, bool disjoint,
                                    TriangleHint& hint) noexcept;

/// Only whether triangles of the two pierce each other: true exactly where triangle_separation, for
/// hulls not known to be disjoint, finds that, and then `out` is its answer. For a caller who
/// expects it and saves the look at the hulls.
bool triangles_pierce(const HullPair& pair, TriangleHint& hint, PatchSeparation& out) noexcept;

}  // namespace thigma
