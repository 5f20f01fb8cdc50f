#pragma once
// What all ways to a depth on the processor begin and end with.

#include "thigma/depth/depth.h"
#include "thigma/depth/detail/near_surface.h"

namespace thigma::detail {

/// Where the last point was found.
struct NearTriangles {
  std::int32_t object = -1, scene = -1;
};

/// An edge of a projected triangle by its vertices: 3 x triangle + corner it starts from.
struct PatchEdge {
  std::int32_t low = -1, high = -1, edge = -1;
};

/// A contact in its own frame: both sides projected, and where they may meet.
struct PreparedContact {
  ContactFrame frame;
  ProjectedPatch object, scene;
  PlaneBox box;                         // the patches' boxes and the reach, intersected
  double texel = 0.0;                   // side of a texel of the finer side that has relief [m]
  HeightMap fine_object, fine_scene;    // memory of a closer look
  NearSurface near_object, near_scene;  // and of a climb
  std::vector<float> sums;              // of both maps
  std::vector<PatchEdge> edges;         // of one side
};

/// Projects both sides of a contact, the object along n and the scene against it; over: as of
/// project_patch.
void project_sides(const DepthContact& contact, const ContactFrame& frame, const PlaneBox& over,
                   ProjectedPatch& object, ProjectedPatch& scene) noexcept;

/// Side of a texel of the finer side, with relief or without [m].
double finer_texel(const DepthContact& contact) noexcept;

/// Projects both sides. False, and nothing to compute, when they share no part of the plane or a
/// number is not finite.
bool prepare_contact(const DepthContact& contact, PreparedContact& prepared) noexcept;

/// The same without what lies beside the box: for those who look nowhere else.
bool prepare_within_box(const DepthContact& contact, PreparedContact& prepared) noexcept;

/// The object once more, at a configuration; the scene and the box stay.
void project_moved(const DepthContact& contact, const Pose& motion,
                   PreparedContact& prepared) noexcept;

/// Depth at a point of the plane [m]; kNoDepth where one of the sides does not lie.
double depth_at(const PreparedContact& prepared, const Vec2& at, NearTriangles& near) noexcept;

/// The same within a billionth of the relief, many times beside each other: after bind_near.
double depth_near(const PreparedContact& prepared, const Vec2& at, NearFeet& feet) noexcept;
void bind_near(PreparedContact& prepared) noexcept;

/// Climbs from a point to a local maximum of the depth within the box: steps along both axes and
/// diagonals, from `spacing` halved down to an eighth of a texel; where triangles end or change
/// also along their edges. After bind_near.
///
/// at       start and result
/// returns  the depth there, of the start if it is no number
double climb(const PreparedContact& prepared, const Vec2& spacing, Vec2& at) noexcept;

/// Whether both fine surfaces are height fields at a point: each one sheet that does not turn over,
/// and nothing above it.
bool is_upright(const PreparedContact& prepared, const Vec2& at) noexcept;

}  // namespace thigma::detail
