#pragma once
// One side of a pair of patches of any levels, and what the hierarchy says about a place on it.

#include <algorithm>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/resolution.h"

namespace thigma::detail {

/// A patch and its node.
struct PatchAtLevel {
  const ClodHierarchy& hierarchy;
  const ClodNode& node;
  HullView view;                  // the patch
  const LevelPatch* level_patch;  // null: finest
  bool is_finest() const noexcept { return level_patch == nullptr; }
  double deviation() const noexcept {
    return level_patch != nullptr ? level_patch->deviation : 0.0;
  }
  double hausdorff() const noexcept {
    return level_patch != nullptr ? level_patch->hausdorff : 0.0;
  }
  double from_below() const noexcept {
    return level_patch != nullptr ? level_patch->from_below : 0.0;
  }
  double resolution() const noexcept {
    return hierarchy.levels[static_cast<std::size_t>(node.level)].resolution;
  }
  /// The hull of the node is one of points of the original.
  bool is_culling_hull() const noexcept {
    return level_patch == nullptr || node.first_vertex != level_patch->first_vertex;
  }
  /// How far whatever is below reaches outside the patch.
  double reach() const noexcept {
    return level_patch != nullptr ? std::max(level_patch->hausdorff, level_patch->from_below) : 0.0;
  }
};

PatchAtLevel patch_at_level(const ClodHierarchy& hierarchy, std::int32_t node) noexcept;

/// A place on the triangles of a patch.
struct SurfaceLocation {
  int corner[3] = {0, 0, 0};
  Vec3 weight = Vec3::UnitX();
  int triangle = -1;
};

/// Two patches, and where they are closest.
struct PairAtLevel {
  PatchAtLevel a, b;
  SurfaceLocation on_a{}, on_b{};
  Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();  // each in the frame of its own body
};

/// Where on its patch a closest point lies.
/// feature  the hull vertices that span it, 0 unknown
/// p        the point [m; body frame]
SurfaceLocation locate(const HullView& view, std::uint32_t feature, const Vec3& p) noexcept;

/// D there, interpolated over the corners [m^2].
double support_area(const PatchAtLevel& patch, const SurfaceLocation& location,
                    SupportReading reading) noexcept;

/// c: how far the finest triangles below may be from a place of the patch, at most [m].
double distance_to_below(const PatchAtLevel& patch, const SurfaceLocation& location,
                         const Vec3& p) noexcept;

}  // namespace thigma::detail
