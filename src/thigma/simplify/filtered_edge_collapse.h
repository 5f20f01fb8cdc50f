#pragma once
// The atomic operation of sensation preserving simplification (Sec. 3.3.4).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "thigma/simplify/convexity.h"
#include "thigma/simplify/detail/deviation_guard.h"
#include "thigma/simplify/detail/edge_star.h"
#include "thigma/simplify/detail/simplify_form.h"
#include "thigma/simplify/nearest_feasible.h"
#include "thigma/simplify/patched_surface.h"
#include "thigma/simplify/quadric.h"
#include "thigma/simplify/simplify_params.h"

namespace thigma {

/// Why an edge stayed, in the order in which it is asked.
enum class CollapseOutcome : std::uint8_t {
  collapsed,
  topology,      // the surface would change its kind
  convexity,     // no position keeps the patches convex
  quality,       // a triangle would turn over or become a sliver
  deviation,     // too far from the original surface
  volume,        // the object would lose or gain too much
  intersection,  // the surface would cross itself
  protrusion,    // a hull would be entered
};
inline constexpr std::size_t kCollapseOutcomes = 8;

/// Where a vertex may lie for the volume under its star to stay what it was: normal . p = offset.
struct VolumePlane {
  Vec3 normal = Vec3::Zero();  // twice the vector area of the ring [m^2]
  double offset = 0.0;         // [m^3]
};

/// What the object's volume grows by when the vertex lies at p [m^3].
inline double volume_change(const VolumePlane& plane, const Vec3& p) {
  return (plane.normal.dot(p) - plane.offset) / 6.0;
}

/// How far the volume may drift from the original's. An open surface has none: limit infinite.
struct VolumeGuard {
  double original = 0.0, now = 0.0;                        // [m^3]
  double limit = std::numeric_limits<double>::infinity();  // [m^3]
};

/// Whether the volume may change by so much [m^3]. A step back towards the original's is always
/// allowed.
inline bool keeps_within(const VolumeGuard& guard, double change) {
  return std::fabs(guard.now + change - guard.original) <=
         std::max(guard.limit, std::fabs(guard.now - guard.original));
}

/// What the volume guard was asked while a position was sought, and what it said.
struct VolumeAnswer {
  double change = 0.0;  // [m^3]
  bool is_kept = false;
};

/// What an attempt found: where the vertex goes, and what its patches are then.
struct CollapseFinding {
  CollapseOutcome outcome = CollapseOutcome::topology;
  Vec3 position = Vec3::Zero();  // of the vertex, where it can go [m]
  detail::EdgeStar star;
  VolumePlane volume;
  std::vector<std::vector<std::int32_t>> patch_vertices;  // of the patches of the star, afterwards
  std::vector<std::vector<HalfSpace>> half_spaces;
  std::vector<TreeBox> patch_box;
  Vec3 hulls_at = Vec3::Zero();  // position of the vertex for which half_spaces are
  bool has_all_hulls = false;
  std::vector<TreeBox> seen;   // beside the patches of the star, triangles that none of these meets
                               // were not looked at,
  std::vector<TreeBox> tried;  // nor hulls that none of these meets
  std::vector<VolumeAnswer> answers;  // of the volume guard, in order
};

/// Scratch of one attempt, reused so that attempts do not allocate. Each thread has its own.
struct CollapseScratch : CollapseFinding {
  std::vector<RingTriangle> ring;
  detail::DeviationSearch search;
  std::vector<LinearConstraint> constraints;
  std::vector<Vec3> new_normal;  // of the triangles of the star, at the position on trial
  std::vector<double> new_height, old_quality;
  std::vector<TreeBox> new_box;
  std::vector<int> divisions;      // of the new triangles' edges, by samples
  std::vector<std::int32_t> mark;  // of each triangle: epoch when in the star, -epoch when removed
  std::vector<std::int32_t> patch_mark;  // of each patch: epoch when it is of the star
  std::int32_t epoch = 0;
  Quickhull hull;
  int old_crossings = -1, old_folds = -1;  // of the star before, -1 not yet counted
  double worst_old_quality = 0.0;
  CollapseOutcome reason = CollapseOutcome::collapsed;  // of the last refusal
};

/// What the operation works on beside the surface.
struct CollapseContext {
  CollapseParams params;
  detail::SimplifyForm form;
  std::vector<Quadric> quadric;  // of each vertex
  detail::DeviationGuard guard;
  VolumeGuard volume;
  CollapseScratch scratch;
};

/// Quadrics of the triangles around each vertex, weighted by area; along a boundary also of planes
/// that stand upright on it.
/// Thread    [offline].
std::vector<Quadric> vertex_quadrics(const PatchedSurface& surface);

/// Looks for where the vertex of a collapsed edge may go, within scratch.search.limit of the
/// original. Changes nothing but the scratch: threads may look at the same time.
///
/// The start is the point of least quadric error; where no position near it keeps the patches
/// convex, the ends of the edge, and then the position of least quadric error that does. On a
/// boundary the vertex stays at an end that is on it. The
/// vertex then moves towards the relaxed position, first that moved along the normal of its ring
/// until the volume is what it was, as far as the convexity of its patches allows,
/// and back until no triangle becomes a sliver or turns over, the surface stays near the original,
/// crosses itself no more than before, and no hull is entered.
///
/// returns    collapsed where it can be, or the last reason
/// Thread     [offline]; deterministic. Source Sec. 3.3.4, Eqs. 3.2-3.4.
/// halfedge   -1: refused for topology
CollapseOutcome find_collapse(const PatchedSurface& surface, const CollapseContext& context,
                              std::int32_t halfedge, CollapseScratch& scratch);

/// Collapses the edge of context.scratch.star as was found there; nothing that was seen has changed
/// since.
///
/// successor  of each patch: entries of patches that vanish are set to a patch beside them
/// Thread     [offline]; deterministic.
void commit_collapse(PatchedSurface& surface, CollapseContext& context,
                     std::vector<std::int32_t>& successor);

/// Both, one after the other; a refused attempt leaves everything as it was. After a collapse
/// context.scratch.star is what it was.
CollapseOutcome filtered_edge_collapse(PatchedSurface& surface, CollapseContext& context,
                                       std::int32_t halfedge, std::vector<std::int32_t>& successor);

}  // namespace thigma
