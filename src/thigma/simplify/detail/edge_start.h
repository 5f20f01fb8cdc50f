#pragma once
// Where the vertex of a collapsed edge may start from (Sec. 3.3.4 step 2).

#include <array>
#include <optional>

#include "thigma/simplify/filtered_edge_collapse.h"

namespace thigma::detail {

/// A position never starts or relaxes farther than this many edge lengths away from the edge.
inline constexpr double kReach = 2.0;

/// p, or where the way there from `from` is `reach` long.
Vec3 clamped(const Vec3& p, const Vec3& from, double reach);

/// Where the new vertex may lie for the volume under the star to stay what it was.
VolumePlane volume_plane(const PatchedSurface& surface, const EdgeStar& star);

/// p moved onto the plane along its normal, if that is a step worth taking and no leap.
///
/// edge  length of the collapsed edge [m]
Vec3 with_volume(const VolumePlane& plane, const Vec3& p, double edge);

struct Starts {
  std::array<Vec3, 3> position;
  int count = 0;
  bool may_move = true;  // relax from there
};

/// The point of least quadric error and the ends; of an edge with an end on a boundary, that end.
Starts choose_starts(const PatchedSurface& surface, const CollapseContext& context,
                     const EdgeStar& star);

/// Of all positions that keep the patches of the star convex, that of least quadric error; nothing
/// when there is none, or none near the edge. To be called after begin_trials.
std::optional<Vec3> best_convex_start(const PatchedSurface& surface, const CollapseContext& context,
                                      CollapseScratch& scratch);

}  // namespace thigma::detail
