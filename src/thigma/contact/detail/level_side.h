#pragma once
// One side of a pair of patches of any levels, and what the hierarchy says about a place on it.

#include <algorithm>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/resolution.h"

namespace thigma::detail {

/// A patch and its node.
struct Side {
  const ClodHierarchy& h;
  const ClodNode& node;
  HullView view;            // the patch
  const LevelPatch* patch;  // null: finest
  bool is_finest() const noexcept { return patch == nullptr; }
  double deviation() const noexcept { return patch != nullptr ? patch->deviation : 0.0; }
  double hausdorff() const noexcept { return patch != nullptr ? patch->hausdorff : 0.0; }
  double from_below() const noexcept { return patch != nullptr ? patch->from_below : 0.0; }
  double resolution() const noexcept {
    return h.levels[static_cast<std::size_t>(node.level)].resolution;
  }
  /// The hull of the node is one of points of the original.
  bool is_culling_hull() const noexcept {
    return patch == nullptr || node.first_vertex != patch->first_vertex;
  }
  /// How far whatever is below reaches outside the patch.
  double reach() const noexcept {
    return patch != nullptr ? std::max(patch->hausdorff, patch->from_below) : 0.0;
  }
};

Side side_of(const ClodHierarchy& h, std::int32_t node) noexcept;

/// A place on the triangles of a patch.
struct Place {
  int corner[3] = {0, 0, 0};
  Vec3 weight = Vec3::UnitX();
  int triangle = -1;
};

/// Where on its patch a closest point lies.
/// feature  the hull vertices that span it, 0 unknown
/// p        the point [m; body frame]
Place find_place(const HullView& view, std::uint32_t feature, const Vec3& p) noexcept;

/// D there, interpolated over the corners [m^2].
double support_area(const Side& side, const Place& place, SupportReading reading) noexcept;

/// c: how far the finest triangles below may be from a place of the patch, at most [m].
double distance_to_below(const Side& side, const Place& place, const Vec3& p) noexcept;

}  // namespace thigma::detail
