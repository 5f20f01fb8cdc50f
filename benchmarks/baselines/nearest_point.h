#pragma once
// The point of a triangle nearest to another, and on which side of the surface that one lies.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bench {

/// Where on a triangle.
enum class TrianglePart : std::uint8_t {
  corner0,
  corner1,
  corner2,
  edge01,
  edge12,
  edge20,
  inside
};

struct NearestPoint {
  Vec3 point = Vec3::Zero();
  double distance2 = 0.0;  // [m^2]
  TrianglePart part = TrianglePart::inside;
};

/// Nearest point of a triangle of the mesh to p.
NearestPoint nearest_point(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& p);

/// Normals whose sign against the way from the nearest point tells inside from outside (Baerentzen
/// and Aanaes 2005): of faces, sums of the two at an edge, sums by angle at a vertex. Not unit.
struct SurfaceNormals {
  std::vector<Vec3> face, vertex;
  std::vector<std::array<Vec3, 3>> edge;  // 01, 12, 20 of each triangle
};
SurfaceNormals surface_normals(const TriangleMesh& mesh);

/// Whether p, whose nearest point of the mesh is q on that triangle, lies outside.
bool is_outside(const SurfaceNormals& normals, const TriangleMesh& mesh, std::int32_t triangle,
                const NearestPoint& q, const Vec3& p);

}  // namespace thigma::bench
