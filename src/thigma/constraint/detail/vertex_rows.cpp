// Vertices against triangles, of the object against the scene and the other way round.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "thigma/constraint/detail/feature_distance.h"
#include "thigma/constraint/detail/pair_lists.h"
#include "thigma/constraint/detail/plane_choice.h"
#include "thigma/constraint/detail/row_search.h"
#include "thigma/constraint/detail/vertex_sides.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// A candidate of each pair within reach whose features may touch.
void gather_side(RowSearch& search, const Sides& sides,
                 std::span<const RowScratch::FeaturePair> pairs,
                 std::vector<VertexSide::Candidate>& out) noexcept {
  const double travel = search.reach.travel;
  const SurfaceFeatures& planes = sides.planes;
  const Mat3 points_from_planes = sides.rotation.transpose();
  const bool is_object = sides.points_of == PointsOf::object;
  for (const RowScratch::FeaturePair& pair : pairs) {
    const std::int32_t v = is_object ? pair.of_object : pair.of_scene;
    const std::int32_t t = is_object ? pair.of_scene : pair.of_object;
    const SurfaceTriangle& triangle = planes.triangles[idx(t)];
    const Vec3& a = planes.vertices[idx(triangle.vertex[0])];
    const Vec3 p = sides.placed(v);
    const double height = triangle.normal.dot(p - a);
    if (std::fabs(height) > travel) continue;
    if (!may_touch(sides.points, v, points_from_planes * triangle.normal, search.cone_slack))
      continue;
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

Slab gather_vertices(RowSearch& search, const Contact& contact, RowScratch& scratch) noexcept {
  const RowScratch::PairList* list = keep_list(search, contact, scratch);
  const PairReach reach = exact_reach(search);
  const Slab slab = list == nullptr ? find_slab(search, contact, reach.travel) : Slab{};
  const auto gather = [&](FeatureKind kind, PointsOf points_of, VertexSide& side) {
    if (list == nullptr) {
      scratch.listed.clear();
      list_vertices(search, kind, contact, slab, reach, scratch);
    }
    const auto pairs = list == nullptr ? std::span<const RowScratch::FeaturePair>(scratch.listed)
                                       : pairs_of(*list, kind);
    if (!pairs.empty()) gather_side(search, sides_of(search, points_of), pairs, side.candidates);
  };
  gather(FeatureKind::object_vertices, PointsOf::object, scratch.object);
  gather(FeatureKind::scene_vertices, PointsOf::scene, scratch.scene);
  return slab;
}

void search_vertices(RowSearch& search, RowScratch& scratch, std::vector<FoundRow>& rows) noexcept {
  search_side(search, sides_of(search, PointsOf::object), scratch.object, rows);
  search_side(search, sides_of(search, PointsOf::scene), scratch.scene, rows);
}

}  // namespace thigma::detail
