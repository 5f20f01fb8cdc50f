#pragma once
// A surface in convex patches while it is being simplified.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/convex/clip.h"
#include "thigma/convex/decomposition.h"
#include "thigma/convex/quickhull.h"
#include "thigma/mesh/box_tree.h"
#include "thigma/mesh/halfedge_mesh.h"

namespace thigma {

/// A convex patch: triangles on their common convex hull.
struct SurfacePatch {
  std::vector<std::int32_t> triangles;  // empty once merged into another or collapsed away
  std::vector<std::int32_t> vertices;   // of the triangles, each once
  std::vector<HalfSpace> half_spaces;   // the hull moved inwards by the inset; none of a flat hull
  TreeBox box{Vec3::Zero(), Vec3::Zero()};  // of the vertices [m]
  std::int32_t shell = -1;                  // patches of other shells are no obstacle
};

/// Invariant: every triangle is in one patch; the vertices of a patch are not above the planes of
/// its triangles (by more than `flat`); no triangle of the shell reaches into the hull of a patch
/// it is not in (moved inwards by `inset`).
struct PatchedSurface {
  HalfedgeMesh mesh;
  std::vector<std::int32_t> patch_of;  // of each triangle (m)
  std::vector<Vec3> normal;            // unit; zero for triangles without an area (m)
  std::vector<double> height;          // of a triangle over its longest edge: width of a sliver [m]
  std::vector<TreeBox> box;            // of each triangle: searches look here before at corners (m)
  std::vector<SurfacePatch> patches;
  BoxTree tree;         // of the patches that have triangles
  double radius = 0.0;  // of the smallest ball around the original [m]
  double flat = 0.0;    // [m]
  double inset = 0.0;   // [m]
  int max_vertices = 32;
  std::int32_t patch_count = 0;  // of those with triangles
};

/// Starts from a decomposition of the mesh. Triangles without an area, which it leaves out, join
/// the patch across their longest edge, or make one of their own where it does not take them.
///
/// convexity, protrusion  least tolerances, times the radius; those of the decomposition where
///                        larger
/// Thread  [offline]; deterministic.
PatchedSurface build_patched_surface(const DecomposedSurface& decomposed, double convexity,
                                     double protrusion, CornerAttributes attributes = {});

/// A triangle thinner than the tolerance has no plane worth the name.
inline bool has_plane(const PatchedSurface& surface, std::int32_t t) noexcept {
  return surface.height[static_cast<std::size_t>(t)] > surface.flat;
}

/// Height of p over the triangle's plane [m].
inline double height_over(const PatchedSurface& surface, std::int32_t t, const Vec3& p) {
  const auto i = static_cast<std::size_t>(t);
  const auto first = static_cast<std::size_t>(surface.mesh.triangles[i][0]);
  return surface.normal[i].dot(p - surface.mesh.positions[first]);
}

/// Corners of a triangle at the present positions [m].
inline std::array<Vec3, 3> corners_of(const PatchedSurface& surface, std::int32_t t) {
  const auto& v = surface.mesh.triangles[static_cast<std::size_t>(t)];
  const auto& x = surface.mesh.positions;
  return {x[static_cast<std::size_t>(v[0])], x[static_cast<std::size_t>(v[1])],
          x[static_cast<std::size_t>(v[2])]};
}

inline TreeBox box_of(const std::array<Vec3, 3>& c) {
  return {c[0].cwiseMin(c[1]).cwiseMin(c[2]), c[0].cwiseMax(c[1]).cwiseMax(c[2])};
}

/// Recomputes normal, height and box from the positions.
void refresh_triangle(PatchedSurface& surface, std::int32_t t);

/// Half-spaces of the hull of some vertices moved inwards by the inset, and the box of the
/// vertices. A hull that is flat to the tolerance has none. hull is scratch.
void list_patch_half_spaces(const PatchedSurface& surface,
                            const std::vector<std::int32_t>& vertices, Quickhull& hull,
                            std::vector<HalfSpace>& half_spaces, TreeBox& box);

/// The same of points; one at least, more than a patch may have are left out.
void list_half_spaces_of(const PatchedSurface& surface, std::span<const Vec3> points,
                         Quickhull& hull, std::vector<HalfSpace>& half_spaces, TreeBox& box);

/// Whether the triangle's present position reaches into the half-spaces; none are never reached.
bool intrudes(const PatchedSurface& surface, std::int32_t t,
              const std::vector<HalfSpace>& half_spaces, const TreeBox& box);

/// Gives a patch its new vertices and hull.
void set_patch(PatchedSurface& surface, std::int32_t patch, std::vector<std::int32_t>& vertices,
               std::vector<HalfSpace>& half_spaces, const TreeBox& box);

/// Merges a patch with a neighbour when their union is a convex patch too (Sec. 3.3.3), again and
/// again.
///
/// successor  of each patch: entries of absorbed patches are set to the patch that took them
/// returns    how many patches it absorbed
/// Thread     [offline]; deterministic.
int merge_patch(PatchedSurface& surface, std::int32_t patch, Quickhull& hull,
                std::vector<std::int32_t>& successor);

}  // namespace thigma
