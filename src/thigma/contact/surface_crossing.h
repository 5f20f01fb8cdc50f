#pragma once
// Whether a segment runs through the material of an object: the answer penetration needs about thin
// plates.

#include "thigma/clod/hierarchy.h"
#include "thigma/convex/gjk.h"
#include "thigma/convex/penetration.h"

namespace thigma {

/// Crossings of a ray with the original triangles of an object. An edge or vertex shared by
/// triangles counts once (ties are broken by the vertices' coordinates); crossings within 1e-6 of
/// the segment's length of `from` or `to` do not count.
struct Crossings {
  int between = 0;  // of the open segment
  // leaving the material minus entering it, from `from` to infinity: how often `from` is inside
  int exits_after_from = 0;
  int exits_after_to = 0;  // the same from `to` on
};

/// Crossings of the ray from `from` through `to`.
/// from, to  [m; frame of the hierarchy]; no crossings when they coincide
/// Thread    [contact]; no failure, no allocation.
Crossings count_crossings(const ClodHierarchy& hierarchy, const Vec3& from,
                          const Vec3& to) noexcept;

/// Whether the surface of an object is closed, from its area integrals (relative 1e-6).
/// Thread    [contact].
bool is_closed(const ClodHierarchy& hierarchy) noexcept;

/// The two objects of a query, for a probe.
struct CrossingContext {
  const ClodHierarchy* object = nullptr;
  const ClodHierarchy* scene = nullptr;
  RelativePose object_from_scene;
  bool object_closed = true, scene_closed = true;  // is_closed
};

/// Probe that answers from the hierarchies: a closed object has its material where rays to infinity
/// leave it more often than they enter; an open one behind its surface, up to the next crossing.
/// `context` must outlive the probe. Thread [contact].
SegmentProbe crossing_probe(const CrossingContext& context) noexcept;

}  // namespace thigma
