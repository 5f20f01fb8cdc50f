#pragma once
// The fine surface of one side about a place, asked for many points beside each other.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/depth/projected_patch.h"

namespace thigma::detail {

/// Of both sides of a contact.
struct NearFeet {
  SurfaceFoot object, scene;
};

inline std::int32_t triangle_of(const SurfaceFoot& foot) noexcept { return foot.triangle; }

/// A patch with its triangles about a box. Any content is valid to fill.
struct NearSurface {
  const ProjectedPatch* patch = nullptr;
  std::vector<std::int32_t> triangles;  // of patch->triangles whose fine surface may lie over it
  // columns of what takes a displacement to the plane and the facing direction
  std::array<Eigen::Vector4f, 3> turn;
  double close = 0.0;  // so far beside the place wanted a fine point is corrected to it [m]
};

/// Binds a surface to a patch, with no triangle yet.
/// Thread  [contact]; allocates when there are more triangles than ever before.
void bind_surface(const ProjectedPatch& patch, NearSurface& surface) noexcept;

/// Looks up the triangles of a bound surface that may lie over a box.
void look_over(const PlaneBox& box, NearSurface& surface) noexcept;

/// height_at, within a billionth of the relief: over the triangles of the box by one or two texels'
/// facets from the foot before, elsewhere by height_at itself.
///
/// at    in the box [m; contact plane]
/// foot  where to look first, and where it was found; any value is fine. Its sheet is taken where
///       it lies over the place, whatever lies above; without a triangle the highest is
/// Thread [contact]; no failure.
double height_near(const NearSurface& surface, const Vec2& at, SurfaceFoot& foot) noexcept;

}  // namespace thigma::detail
