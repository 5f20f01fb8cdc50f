#pragma once
// How often a segment crosses the surface of an object: the answer penetration needs about thin plates.

#include "thigma/clod/hierarchy.h"
#include "thigma/convex/pair.h"
#include "thigma/convex/penetration.h"

namespace thigma {

/// Crossings of the open segment with the original triangles of an object. An edge or vertex shared by triangles
/// counts once (ties are broken by the vertices' coordinates); crossings within 1e-6 of its length of an end do
/// not count.
///
/// from, to  [m; frame of the hierarchy]
/// Thread    [contact]; no failure, no allocation.
int count_crossings(const ClodHierarchy& hierarchy, const Vec3& from, const Vec3& to) noexcept;

/// The two objects of a query, for a probe.
struct CrossingContext {
  const ClodHierarchy* object = nullptr;
  const ClodHierarchy* scene = nullptr;
  RelativePose object_from_scene;
};

/// Probe that answers from the hierarchies. `context` must outlive it. Thread [contact].
SegmentProbe crossing_probe(const CrossingContext& context) noexcept;

}  // namespace thigma
