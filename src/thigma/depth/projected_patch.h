#pragma once
// One side of a contact as a height field: coarse triangles with their texture, seen along the
// contact normal.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {

using Mat2 = Eigen::Matrix2d;

/// The rotated reference system {u, v, n} of a contact. Invariant: right-handed, u x v = n.
struct ContactFrame {
  Vec3 origin = Vec3::Zero();                  // [m; world]
  Mat3 world_from_contact = Mat3::Identity();  // columns u, v, n
};

/// A frame about a point; u and v are a function of n alone.
/// Thread    [contact]; no failure for |normal| = 1.
/// Source    Sec. 4.1.1; right-handed, where the text is not (docs/sources.md, 4.1).
ContactFrame contact_frame(const Vec3& origin, const Vec3& normal) noexcept;

/// Which way a patch looks: the object's surface along n, the scene's against it.
enum class Facing : std::int8_t { along = 1, against = -1 };

/// A rectangle of the plane (u, v) [m]; empty when low > high in a component.
struct PlaneBox {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = Vec2::Constant(-std::numeric_limits<double>::infinity());
  bool is_empty() const noexcept { return !(low.x() < high.x() && low.y() < high.y()); }
};

inline const PlaneBox kWholePlane{Vec2::Constant(-std::numeric_limits<double>::infinity()),
                                  Vec2::Constant(std::numeric_limits<double>::infinity())};

inline PlaneBox intersection(const PlaneBox& a, const PlaneBox& b) noexcept {
  return {a.low.cwiseMax(b.low), a.high.cwiseMin(b.high)};
}

/// Whether two closed boxes share a point.
inline bool overlap(const PlaneBox& a, const PlaneBox& b) noexcept {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

/// Whether a point lies in a closed box.
inline bool contains(const PlaneBox& box, const Vec2& at) noexcept {
  return (at.array() >= box.low.array()).all() && (at.array() <= box.high.array()).all();
}

/// A coarse triangle in the plane (u, v); heights are along the facing direction [m].
struct ProjectedTriangle {
  std::array<Vec2, 3> at;  // corners [m]
  // from corner k to the next over twice the area: cross(edges[k], s - at[k]) is the barycentric
  // coordinate of a point s that is 0 along that edge [1/m]
  std::array<Vec2, 3> edges;
  PlaneBox box;   // of the corners, and of what counts as on the triangle by rounding
  PlaneBox fine;  // no fine point of it lies beyond [m]
  // barycentric coordinates of what a fine point of it lies over are no smaller
  std::array<double, 3> least;
  Vec2 texel_origin;  // texture coordinates at a point s of the plane: texel_origin + texel_by_at s
  Mat2 texel_by_at;   // [texels/m]
  Vec2 at_origin;     // and back
  Mat2 at_by_texel;   // [m/texel]
  double height_origin = 0.0;  // of the coarse surface: height_origin + height_by_at . s [m]
  Vec2 height_by_at;
  // what a displacement adds to the height over the coarse point's own place, times it: its part
  // along the facing direction, less what the triangle rises by as far as it goes sideways [body
  // frame]
  Vec3 carried;
  std::int32_t triangle = -1;
};

/// What is left of a triangle that faces the other way or is seen edge-on.
struct HiddenTriangle {
  PlaneBox box;
  double highest = 0.0;  // of its corners, along the facing direction [m]
  std::int32_t triangle = -1;
};

/// A patch prepared for one contact. Any content is valid to project into; vectors keep their
/// memory.
struct ProjectedPatch {
  const HapticTexture* texture = nullptr;
  Facing facing = Facing::along;
  Vec3 direction_body = Vec3::UnitZ();        // the facing direction in the texture's body frame
  Mat3 contact_from_body = Mat3::Identity();  // rotation only
  Vec3 shift = Vec3::Zero();                  // of the body's origin [m; contact frame]
  std::vector<ProjectedTriangle> triangles;   // those that face the right way
  // beside them: seen over `triangles` where their own fine surface is not
  std::vector<ProjectedTriangle> around;
  // those that do not: over these it may be no height field
  std::vector<HiddenTriangle> hidden;
  PlaneBox sideways;  // of what any displacement of the texture moves along the plane [m]
  PlaneBox box;       // of `triangles`
};

/// One side of a contact: part of the coarse surface of a texture, in its place.
struct TexturedPatch {
  const HapticTexture* texture = nullptr;
  std::span<const std::int32_t> triangles;  // of texture->coarse; belongs to the caller
  Pose world_from_body;
  std::span<const std::int32_t> around{};  // the triangles beside them: no part of the contact, but
                                           // their fine surface may lie over `triangles`
};

/// Projects triangles of a textured surface along the normal of a contact; those without area are
/// left out.
///
/// side    the triangles, and those around them, see ProjectedPatch
/// patch   overwritten
/// over    triangles whose fine surface does not reach it are left out; `box` of the patch is of
///         the others
/// Thread  [contact]; no failure; allocates when there are more triangles than ever before.
/// Source  Sec. 4.4.1, the mapping g^ of Eq. 4.9.
void project_patch(const TexturedPatch& side, const ContactFrame& frame, Facing facing,
                   ProjectedPatch& patch, const PlaneBox& over = kWholePlane) noexcept;

/// The box that project_patch gives a patch over the whole plane, without projecting its triangles;
/// no smaller where some of these have no area in the map.
/// Thread  [contact]; no failure.
PlaneBox patch_box(const TexturedPatch& side, const ContactFrame& frame, Facing facing) noexcept;

/// A triangle of a patch by the index that height_at finds: of `triangles`, then of `around`.
inline const ProjectedTriangle& projected_triangle(const ProjectedPatch& patch,
                                                   std::int32_t index) noexcept {
  const std::size_t i = static_cast<std::size_t>(index), own = patch.triangles.size();
  return i < own ? patch.triangles[i] : patch.around[i - own];
}

/// Whether the part of a patch over a box is one: no triangle there looks the other way or is seen
/// edge-on.
bool is_height_field(const ProjectedPatch& patch, const PlaneBox& over) noexcept;

/// Whether a triangle that looks the other way or is seen edge-on reaches above a height at a
/// place: then what is seen there is below it.
///
/// within  of the place along both axes; and so much above does not count [m]
bool is_overhung(const ProjectedPatch& patch, const Vec2& at, double height,
                 double within) noexcept;

inline constexpr double kNoSurface = -std::numeric_limits<double>::infinity();

/// Where the coarse point of a fine one was found.
struct SurfaceFoot {
  std::int32_t triangle = -1;  // as of projected_triangle
  Vec2 aside = Vec2::Zero();   // of the coarse point from the place of the fine one [m]
};

/// Height of the fine surface over a point of the plane along the facing direction (Eq. 4.9) [m];
/// kNoSurface where the patch does not lie, the largest where several sheets do. What the
/// displacement moves sideways is followed back: the fine point is the one over `at`, of whatever
/// coarse point. Beside the end of the patch, where a coarse triangle still lies, it is one of a
/// triangle around, or without one the nearest of its edge. None is found where the fine surface
/// turns over.
///
/// at    [m; contact plane]
/// near  triangle (as of projected_triangle) where to look first, and the one found; any value is
///       fine. Where its sheet lies over the place it is taken, whatever lies above: -1 asks for
///       the highest
/// Thread    [contact]; no failure.
/// Source    Eq. 4.9. Deviates: D86.
double height_at(const ProjectedPatch& patch, const Vec2& at, std::int32_t& near) noexcept;

/// The same from a foot beside, which is fewer steps.
double height_at(const ProjectedPatch& patch, const Vec2& at, SurfaceFoot& near) noexcept;

/// To first order in what the displacement moves sideways, of one projected triangle, inside or
/// not: the displacement of the coarse point over `at`, carried along the triangle, at 45 degrees
/// where that is steeper. What height maps hold.
double height_on(const ProjectedPatch& patch, const ProjectedTriangle& triangle,
                 const Vec2& at) noexcept;

/// No place of a triangle has more of height_on above its coarse height [m].
double most_relief(const ProjectedPatch& patch, const ProjectedTriangle& triangle) noexcept;

/// The coarse point of a triangle whose fine point lies over `at` of the plane: where it lies.
/// False where it is beside the triangle, or where the fine surface turns over on the way.
bool find_below(const ProjectedPatch& patch, const ProjectedTriangle& triangle, const Vec2& at,
                Vec2& place) noexcept;

/// The fine surface over a point, with what derivatives need. Slopes come from central differences
/// of the texels, interpolated: they are continuous, where those of the bilinear facets jump at
/// every texel. Where the fine surface turns over it is that of height_on and no height field.
struct SurfaceJet {
  bool is_covered = false;
  // one sheet only, and the fine surface itself does not turn over here
  bool is_height_field = true;
  double height = kNoSurface;  // along the facing direction [m]
  Vec2 slope = Vec2::Zero();   // d height/d at, texel tangents
  // the same, of the bilinear interpolant itself: its exact derivative
  Vec2 facet_slope = Vec2::Zero();
  Mat2 curvature = Mat2::Zero();  // second derivatives by second differences of texels [1/m]
  Vec3 point = Vec3::Zero();      // of the fine surface [m; contact frame]
};
SurfaceJet surface_jet(const ProjectedPatch& patch, const Vec2& at) noexcept;

/// The same; near: as of height_at. Where the sheet of `near` is taken, further ones are not
/// counted.
SurfaceJet surface_jet(const ProjectedPatch& patch, const Vec2& at, SurfaceFoot& near) noexcept;

}  // namespace thigma
