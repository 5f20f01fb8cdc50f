// Vertices against triangles, of the object against the scene and the other way round.

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "thigma/constraint/detail/feature_distance.h"
#include "thigma/constraint/detail/plane_choice.h"
#include "thigma/constraint/detail/row_search.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// The surface with the vertices and the one with the planes.
struct Sides {
  const SurfaceFeatures& points;
  const SurfaceFeatures& planes;
  Pose planes_from_points;
  PointsOf points_of;

  Vec3 point(std::int32_t vertex) const noexcept {
    return transform_point(planes_from_points, points.vertices[idx(vertex)]);
  }
};

Sides sides_of(const RowSearch& s, PointsOf points_of) noexcept {
  if (points_of == PointsOf::object)
    return {*s.object.features, *s.scene.features, s.scene_from_object, points_of};
  return {*s.scene.features, *s.object.features, s.object_from_scene, points_of};
}

/// Whether the surface about a vertex stays in front of a plane through it, but for what turning
/// may do: only then may the vertex be the first to touch a face of that normal.
bool may_touch(const SurfaceFeatures& points, std::int32_t vertex, const Vec3& normal,
               double slack) noexcept {
  const std::int32_t last = points.first_direction[idx(vertex) + 1];
  for (std::int32_t i = points.first_direction[idx(vertex)]; i < last; ++i)
    if (points.directions[idx(i)].dot(normal) < -slack) return false;
  return true;
}

/// A half space: beyond `most` along an axis.
struct Beyond {
  Vec3 axis = Vec3::Zero();
  double most = 0.0;
};

bool is_beyond(const SurfaceFeatures& features, const SurfaceTriangle& triangle,
               const Beyond& beyond) noexcept {
  for (const std::int32_t v : triangle.vertex)
    if (beyond.axis.dot(features.vertices[idx(v)]) <= beyond.most) return false;
  return true;
}

void gather_side(RowSearch& search, const Sides& sides, std::int32_t patch,
                 std::span<const std::int32_t> vertices, const Beyond& beyond,
                 std::vector<VertexSide::Candidate>& out) noexcept {
  const double travel = search.reach.travel;
  const SurfaceFeatures& planes = sides.planes;
  if (vertices.empty()) return;
  const Mat3 rotation = sides.planes_from_points.orientation.toRotationMatrix();
  const Mat3 points_from_planes = rotation.transpose();
  std::array<Vec3, kMostNear> points;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    points[i] =
        rotation * sides.points.vertices[idx(vertices[i])] + sides.planes_from_points.position;
  for (const std::int32_t t : part_of(planes.patch_triangles, planes.first_triangle, patch)) {
    const SurfaceTriangle& triangle = planes.triangles[idx(t)];
    if (is_beyond(planes, triangle, beyond)) continue;
    const Vec3& a = planes.vertices[idx(triangle.vertex[0])];
    const Vec3 normal_of_points = points_from_planes * triangle.normal;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::int32_t v = vertices[i];
      const Vec3& p = points[i];
      const double ball = triangle.radius + travel;
      if ((p - triangle.center).squaredNorm() > ball * ball) continue;
      const double height = triangle.normal.dot(p - a);
      if (std::fabs(height) > travel) continue;
      if (!may_touch(sides.points, v, normal_of_points, search.cone_slack)) continue;
      const Vec3 nearest = nearest_on_triangle(p, a, planes.vertices[idx(triangle.vertex[1])],
                                               planes.vertices[idx(triangle.vertex[2])]);
      const double distance = (p - nearest).norm();
      if (!(distance <= travel)) continue;
      if (out.size() == out.capacity()) {
        ++search.left_out;
        continue;
      }
      out.push_back({distance, v, t, nearest});
      if (height >= 0.0 && distance - height <= search.rounding)
        add_known(search, sides.points_of, triangle.normal, height);
    }
  }
}

bool is_behind(const SurfaceFeatures& features, const SurfaceTriangle& triangle,
               const GuardPlane& plane, double rounding) noexcept {
  for (const std::int32_t v : triangle.vertex)
    if (plane.height(features.vertices[idx(v)]) > rounding) return false;
  return true;
}

/// Whether some plane keeps the vertex from the triangle. One that it has already does, and one
/// that it does not reach. A vertex that is high over a plane of others takes it as its own: each
/// with planes of their own, many far vertices would have no room.
bool is_guarded(RowSearch& search, const Sides& sides, const VertexSide::Candidate& c,
                VertexSide& side, std::vector<FoundRow>& rows) noexcept {
  const SurfaceTriangle& triangle = sides.planes.triangles[idx(c.triangle)];
  const double travel = search.reach.travel;
  const Vec3 p = sides.point(c.vertex);
  std::int32_t best = -1;
  double most = least_shared(search, c.distance);
  for (std::size_t i = 0; i < side.planes.size(); ++i) {
    const GuardPlane& plane = side.planes[i];
    const auto index = static_cast<std::int32_t>(i);
    const double height = plane.height(p);
    const bool is_own = is_member(side, c.vertex, index);
    if (!is_own && height <= std::min(most, travel)) continue;
    if (!is_behind(sides.planes, triangle, plane, search.rounding)) continue;
    if (is_own || height > travel) return true;
    best = index;
    most = height;
  }
  if (best < 0) return false;
  add_member(search, sides.points_of, c.vertex, best, side, rows);
  return true;
}

/// Calls back with the triangles beyond the border that a point of a triangle lies on.
template <class Visit>
void each_across(const RowSearch& search, const SurfaceFeatures& surface,
                 const SurfaceTriangle& triangle, const Vec3& on_border,
                 const Visit& visit) noexcept {
  for (std::size_t k = 0; k < 3; ++k) {
    if (triangle.across[k] < 0) continue;
    const Vec3& tail = surface.vertices[idx(triangle.vertex[k])];
    const Vec3& head = surface.vertices[idx(triangle.vertex[(k + 1) % 3])];
    const Vec3 along = head - tail;
    if (along.cross(on_border - tail).norm() <= search.rounding * along.norm())
      visit(triangle.across[k]);
  }
}

/// The plane that keeps a vertex from a triangle: the triangle's own where the vertex is over it.
/// Beside it that one, the plane through the nearest point of its border, or, where the surface is
/// convex there, that of the face beyond the border, whichever forbids least; the whole triangle
/// lies behind each.
bool make_plane(const RowSearch& search, const Sides& sides, const VertexSide::Candidate& c,
                const VertexSide& side, GuardPlane& plane) noexcept {
  const SurfaceTriangle& triangle = sides.planes.triangles[idx(c.triangle)];
  const Vec3 p = sides.point(c.vertex);
  const Vec3& a = sides.planes.vertices[idx(triangle.vertex[0])];
  plane = {triangle.normal, triangle.normal.dot(a), c.triangle};
  const double height = triangle.normal.dot(p - a);
  const bool is_over = std::fabs(std::fabs(height) - c.distance) <= search.rounding;
  if (is_over || c.distance <= search.rounding) {
    // Behind a triangle: through it by an error of the last steps, or on the far side of a thin
    // object, whose near side keeps the vertex.
    const bool is_first = side.first_member[idx(c.vertex)] < 0;
    const double error = is_first ? kError * search.reach.travel : search.rounding;
    return height >= -error;
  }
  const Vec3 normal = (p - c.nearest) / c.distance;
  const GuardPlane border{normal, normal.dot(c.nearest), c.triangle};
  const auto forbids = [&](const GuardPlane& guard) {
    return forbidden(search, sides.points_of, p, c.vertex, side, guard);
  };
  GuardPlane best = border;
  double least = forbids(border);
  const auto compare = [&](const GuardPlane& guard) {
    if (!may_keep(search, guard.height(p), c.distance)) return;
    const double by_guard = forbids(guard);
    if (least - by_guard < kEqual * search.reach.travel) return;
    best = guard;
    least = by_guard;
  };
  compare(plane);
  if (!is_in_the_air(search))
    each_across(search, sides.planes, triangle, c.nearest, [&](std::int32_t beyond) {
      const Vec3& face = sides.planes.triangles[idx(beyond)].normal;
      const GuardPlane guard{face, face.dot(c.nearest), beyond};
      if (is_behind(sides.planes, triangle, guard, search.rounding)) compare(guard);
    });
  plane = best;
  return true;
}

void search_side(RowSearch& search, const Sides& sides, VertexSide& side,
                 std::vector<FoundRow>& rows) noexcept {
  const auto key = [](const auto& c) { return std::tie(c.distance, c.vertex, c.triangle); };
  std::sort(side.candidates.begin(), side.candidates.end(),
            [&](const auto& x, const auto& y) { return key(x) < key(y); });
  std::int32_t vertex = -1, triangle = -1;
  for (const VertexSide::Candidate& c : side.candidates) {
    if (c.vertex == vertex && c.triangle == triangle) continue;  // met in two pairs of patches
    vertex = c.vertex;
    triangle = c.triangle;
    if (is_guarded(search, sides, c, side, rows)) continue;
    GuardPlane plane;
    if (!make_plane(search, sides, c, side, plane)) continue;
    if (side.planes.size() == side.planes.capacity()) {
      ++search.left_out;
      continue;
    }
    side.planes.push_back(plane);
    add_member(search, sides.points_of, c.vertex, static_cast<std::int32_t>(side.planes.size()) - 1,
               side, rows);
  }
}

}  // namespace

void gather_vertices(RowSearch& search, const Contact& contact, const Slab& slab,
                     RowScratch& scratch) noexcept {
  keep_near(*search.object.features, contact.object_patch, slab.object_axis, slab.object_least,
            scratch.near_object);
  keep_near(*search.scene.features, contact.scene_patch, -slab.scene_axis, -slab.scene_most,
            scratch.near_scene);
  gather_side(search, sides_of(search, PointsOf::object), contact.scene_patch, scratch.near_object,
              {slab.scene_axis, slab.scene_most}, scratch.object.candidates);
  gather_side(search, sides_of(search, PointsOf::scene), contact.object_patch, scratch.near_scene,
              {-slab.object_axis, -slab.object_least}, scratch.scene.candidates);
}

void search_vertices(RowSearch& search, RowScratch& scratch, std::vector<FoundRow>& rows) noexcept {
  search_side(search, sides_of(search, PointsOf::object), scratch.object, rows);
  search_side(search, sides_of(search, PointsOf::scene), scratch.scene, rows);
}

}  // namespace thigma::detail
