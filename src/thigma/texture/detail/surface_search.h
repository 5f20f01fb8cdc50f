#pragma once
// Points of a surface near a place or along a line.

#include <cstdint>
#include <limits>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma::detail {

/// A surface to search. Keeps a pointer to the mesh.
struct SurfaceSearch {
  const TriangleMesh* mesh = nullptr;
  TriangleTree tree;
};

SurfaceSearch build_surface_search(const TriangleMesh& mesh);

/// A point of a triangle.
struct SurfacePoint {
  std::int32_t triangle = -1;
  Vec3 weights = Vec3::Zero();                                // of its corners
  Vec3 at = Vec3::Zero();                                     // [m]
  double distance = std::numeric_limits<double>::infinity();  // from what was asked for [m]
};

/// The point of a triangle nearest to p.
SurfacePoint nearest_of_triangle(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& p);

/// The point of the surface nearest to p.
SurfacePoint nearest_point(const SurfaceSearch& search, const Vec3& p);

/// Where the line p + t direction, |t| <= reach, meets a triangle whose normal goes along
/// `direction`, with the least |t|: `distance` is t with its sign, `triangle` -1 when there is
/// none.
///
/// direction  unit
SurfacePoint crossing_point(const SurfaceSearch& search, const Vec3& p, const Vec3& direction,
                            double reach);

}  // namespace thigma::detail
