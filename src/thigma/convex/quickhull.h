#pragma once
// A convex hull that grows by the farthest point outside it: the engine of build_hull and of
// bounded hulls.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "thigma/math/types.h"

namespace thigma {

/// A triangle of a growing hull.
struct GrowingFace {
  std::array<std::int32_t, 3> corner = {-1, -1,
                                        -1};  // into the points, counter-clockwise from outside
  std::array<std::int32_t, 3> neighbor = {-1, -1, -1};  // face across corner[i] -> corner[i + 1]
  Vec3 normal = Vec3::Zero();  // unit; zero when the triangle has no area in doubles
  double offset = 0.0;
  // list of the points that this face keeps out, through Quickhull::next
  std::int32_t first_outside = -1;
  std::int32_t farthest = -1;  // of them
  double farthest_height = 0.0;
  bool is_alive = false;
};

/// A hull of some of the points it was started with, and which of the others are still outside.
/// Reused from hull to hull it allocates nothing. Coordinates are centred and scaled by a power of
/// two.
struct Quickhull {
  std::vector<Vec3> points;
  std::vector<GrowingFace> faces;
  std::vector<std::int32_t> next;  // of each point, in the list of a face; -1 ends it
  // points added so far; in dimension 2 in order around the polygon
  std::vector<std::int32_t> vertices;
  std::vector<std::int32_t> rim;  // dimension 2: every extreme point, in order around the polygon
  std::vector<std::int32_t> face_behind;     // scratch: the new face that starts at a point
  std::vector<std::int32_t> visible, fresh;  // scratch
  Vec3 origin = Vec3::Zero();                // point = origin + points[i] / scale
  double scale = 1.0;
  double tolerance = 0.0;  // height above which a point is outside [scaled]; lower for thin sets
  int dimension = 0;
};

/// Starts a hull: its dimension and its first simplex, of 1 to 4 points.
///
/// points              at least one, finite [m]
/// relative_tolerance  of the extent of the set: points not higher than that over every face are
///                     inside; at least 1e-12
/// Thread              [offline]; no failure.
void start_hull(Quickhull& hull, std::span<const Vec3> points, double relative_tolerance);

/// Adds points until none is outside: each time one that is the farthest of its face.
void complete_hull(Quickhull& hull);

/// Adds the farthest point of all until the hull has max_vertices (4 at least) or none is outside:
/// a good hull for its number of vertices.
void grow_hull(Quickhull& hull, int max_vertices);

/// Largest distance from a point that is still outside to the hull [m], not counting the tolerance.
double outside_distance(const Quickhull& hull);

/// The points that are still outside, ascending.
void list_outside(const Quickhull& hull, std::vector<std::int32_t>& points);

/// Distance from p to triangle a, b, c; degenerate triangles too. Any unit.
double point_triangle_distance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace thigma
