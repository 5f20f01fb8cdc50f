#pragma once
// Vertices, edges and triangles of an object's surface with what meets where: all that may touch.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/math/types.h"

namespace thigma {

/// A triangle of the finest surface.
struct SurfaceTriangle {
  std::array<std::int32_t, 3> vertex{};  // counter-clockwise from outside
  Vec3 normal = Vec3::Zero();            // unit, outward
  Vec3 center = Vec3::Zero();            // of a ball about it [m]
  double radius = 0.0;
  // beyond the edge from vertex[k] to the next one; -1 where the surface ends
  std::array<std::int32_t, 3> across{-1, -1, -1};
};

/// An edge where the surface is convex, or ends. Flat and reflex edges never touch anything first
/// and are left out.
struct ConvexEdge {
  std::int32_t tail = -1, head = -1;
  Vec3 direction = Vec3::Zero();  // unit, from tail to head
  Vec3 middle = Vec3::Zero();     // [m]
  double half = 0.0;              // of its length [m]
  // unit, across the edge and into the faces on both sides; zero where the surface ends
  Vec3 into_left = Vec3::Zero(), into_right = Vec3::Zero();
  Vec3 outward = Vec3::Zero();  // sum of the normals of the faces
};

/// A ball about a patch: that of its node.
struct PatchBall {
  Vec3 center = Vec3::Zero();  // [m]
  double radius = 0.0;         // [m]
};

/// The normals of a patch's triangles: none is farther from `axis` than `spread`, as vectors.
struct PatchNormals {
  Vec3 axis = Vec3::Zero();  // unit, or zero where they cancel out
  double spread = 0.0;       // with the rounding of a scalar product
};

/// Features of the finest surface of a hierarchy, in its frame. Immutable while running.
/// Vertices are those of the finest patches, equal positions made one.
struct SurfaceFeatures {
  double size = 0.0;           // of the vertex farthest from the frame's origin [m]
  std::vector<Vec3> vertices;  // [m]
  std::vector<SurfaceTriangle> triangles;
  std::vector<ConvexEdge> edges;
  // by vertex: whether the surface there is a corner, strictly inside some half space; others, in
  // flat, straight, reflex or saddle places, touch no face first
  std::vector<std::uint8_t> is_corner;
  // by vertex: unit directions along the edges that leave it
  std::vector<std::int32_t> first_direction;  // vertices + 1
  std::vector<Vec3> directions;
  // by finest patch: its vertices, triangles and convex edges, borders included
  std::vector<std::int32_t> first_vertex, first_triangle, first_edge;  // patches + 1 each
  std::vector<std::int32_t> patch_vertices, patch_triangles, patch_edges;
  std::vector<PatchBall> patch_balls;
  std::vector<PatchNormals> patch_normals;
};

/// Features of a hierarchy's finest surface.
/// Thread    [offline]; throws std::bad_alloc.
SurfaceFeatures find_features(const ClodHierarchy& hierarchy);

/// What a patch has. Thread [contact].
inline std::span<const std::int32_t> part_of(const std::vector<std::int32_t>& all,
                                             const std::vector<std::int32_t>& first,
                                             std::int32_t patch) noexcept {
  const auto begin = static_cast<std::size_t>(first[static_cast<std::size_t>(patch)]);
  const auto end = static_cast<std::size_t>(first[static_cast<std::size_t>(patch) + 1]);
  return {all.data() + begin, end - begin};
}

}  // namespace thigma
