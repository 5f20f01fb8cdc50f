#pragma once
// How deep a point lies inside a surface: the distance to its nearest point, with a sign.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma {

struct HapticTexture;

/// The finest surface of a hierarchy, in its frame. Immutable while running.
struct SolidSurface {
  TriangleMesh mesh;  // equal positions made one
  TriangleTree tree;  // without the boxes of single triangles
  // What tells the side of a point by the part of the surface nearest to it: of each triangle the
  // one across the edge from corner k on, itself at a seam of a texture, -1 at a border, beside
  // which nothing is inside;
  std::vector<std::array<std::int32_t, 3>> across;
  std::vector<Vec3> vertex;  // sum of the faces' normals, by their angles; zero at borders
};

/// Thread    [offline]; throws std::bad_alloc.
SolidSurface make_solid_surface(const ClodHierarchy& hierarchy);

/// The fine surface of a texture: its coarse triangles divided to a texel and displaced.
/// errors    std::invalid_argument for more than 8 million triangles
/// Thread    [offline]; throws std::bad_alloc.
SolidSurface make_solid_surface(const HapticTexture& texture);

/// Where a point lies.
struct PointDepth {
  double depth = 0.0;  // from the surface, > 0 inside [m]
  // unit; along it the depth falls by one a metre
  Vec3 outward = Vec3::UnitZ();
  std::int32_t triangle = -1;  // the nearest
};

/// Depth of a point. Of a closed surface that does not meet itself it is continuous.
///
/// point   [m; frame of the surface]
/// guess   a triangle that may be near, -1: none; which of equally near ones is found may depend on
///         it
/// Thread  [contact]; no failure.
/// Source  Signs by angle-weighted normals: Baerentzen and Aanaes 2005.
PointDepth depth_inside(const SolidSurface& surface, const Vec3& point,
                        std::int32_t guess) noexcept;

}  // namespace thigma
