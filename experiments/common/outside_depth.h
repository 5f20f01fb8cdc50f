#pragma once
// How deep one closed surface is in another, by nothing of the engine but its vector types: what
// the engine says of itself is not asked.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::experiments {

/// A closed surface with what its distance and its inside need.
struct DepthSurface {
  struct Node {
    Vec3 low, high;                      // of the box [m]
    std::int32_t left = -1, right = -1;  // -1: a leaf
    std::int32_t first = 0, count = 0;   // into `order`
  };
  TriangleMesh mesh;
  std::vector<Vec3> face_normals, vertex_normals;  // vertices: weighted by angle
  std::vector<std::array<Vec3, 3>> edge_normals;   // by triangle: of its edges, sums of two faces
  std::vector<std::int32_t> order;
  std::vector<Node> nodes;
};

DepthSurface make_depth_surface(const TriangleMesh& mesh);

/// Distance of a point to the surface, negative inside [m]: the nearest triangle by its tree, the
/// side by the normal of the feature the nearest point lies on (Baerentzen and Aanaes 2005).
double signed_distance(const DepthSurface& surface, const Vec3& point);

/// What is known of two surfaces from looks at other poses. Empty before the first.
struct DepthMemory {
  struct Side {
    std::vector<Vec3> points;      // the vertices when they were last measured [m; other's frame]
    std::vector<double> distance;  // at least that, by vertex [m]; negative inside
    std::size_t deepest = 0;       // vertex
  };
  Side of_a, of_b;
};

/// The largest distance of a point of one surface inside the other from that other surface, 0 where
/// they are apart [m]. Points looked at: every vertex of both, and `samples` points on every edge
/// that passes through a triangle of the other. `b` is at rest in the world.
///
/// memory  of the same two surfaces: a distance changes no faster than its point moves, so that
///         what cannot be the deepest is not measured again. Of closed surfaces the result is the
///         same without; where the side of a point is not known it may be another
double outside_depth(const DepthSurface& a, const Pose& world_from_a, const DepthSurface& b,
                     DepthMemory& memory, int samples = 16);
double outside_depth(const DepthSurface& a, const Pose& world_from_a, const DepthSurface& b,
                     int samples = 16);

}  // namespace thigma::experiments
