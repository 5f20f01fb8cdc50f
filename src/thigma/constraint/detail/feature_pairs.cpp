// Which features of two patches may touch: by their balls, the slab of the contact, cones of
// normals.

#include <algorithm>
#include <array>
#include <cmath>

#include "thigma/constraint/detail/edge_cones.h"
#include "thigma/constraint/detail/edge_planes.h"
#include "thigma/constraint/detail/feature_distance.h"
#include "thigma/constraint/detail/pair_lists.h"
#include "thigma/constraint/detail/vertex_sides.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// A half space: beyond `most` along an axis.
struct Beyond {
  Vec3 axis = Vec3::Zero();
  double most = 0.0;
};

bool is_beyond(const SurfaceTriangle& triangle, const Beyond& beyond) noexcept {
  return beyond.axis.dot(triangle.center) - triangle.radius > beyond.most;
}

void add_pair(RowSearch& search, const RowScratch::FeaturePair& pair,
              RowScratch& scratch) noexcept {
  if (scratch.listed.size() == scratch.listed.capacity()) {
    ++search.left_out;
    return;
  }
  scratch.listed.push_back(pair);
}

/// Whether a point is as near to a triangle of one patch as it has to be.
bool is_near(const SurfaceFeatures& planes, const SurfaceTriangle& triangle, const Vec3& p,
             const PairReach& reach) noexcept {
  const double ball = triangle.radius + reach.travel;
  if ((p - triangle.center).squaredNorm() > ball * ball) return false;
  const Vec3& a = planes.vertices[idx(triangle.vertex[0])];
  if (std::fabs(triangle.normal.dot(p - a)) > reach.travel) return false;
  if (!reach.is_kept) return true;
  const Vec3 nearest = nearest_on_triangle(p, a, planes.vertices[idx(triangle.vertex[1])],
                                           planes.vertices[idx(triangle.vertex[2])]);
  return (p - nearest).squaredNorm() <= reach.travel * reach.travel;
}

/// Whether an edge is within reach of a ball.
bool is_in_reach(const Vec3& middle, double half, const PatchBall& ball, double travel) noexcept {
  const double balls = half + ball.radius + travel;
  return (middle - ball.center).squaredNorm() <= balls * balls;
}

/// Whether two edges are as near as they have to be; the object's where it is.
bool are_near(const RowSearch& search, const Vec3& tail, const Vec3& head, std::int32_t scene,
              double travel) noexcept {
  const SurfaceFeatures& b = *search.scene.features;
  const Vec3& other = b.vertices[idx(b.edges[idx(scene)].tail)];
  const Vec3 along = head - tail, other_along = b.vertices[idx(b.edges[idx(scene)].head)] - other;
  const NearestOnSegments at = nearest_on_segments(tail, along, other, other_along);
  const Vec3 way = other + at.second * other_along - (tail + at.first * along);
  return way.squaredNorm() <= travel * travel;
}

}  // namespace

void list_vertices(RowSearch& search, FeatureKind kind, const Contact& contact, const Slab& slab,
                   const PairReach& reach, RowScratch& scratch) noexcept {
  const bool is_object = kind == FeatureKind::object_vertices;
  const Sides sides = sides_of(search, is_object ? PointsOf::object : PointsOf::scene);
  const std::int32_t points_patch = is_object ? contact.object_patch : contact.scene_patch;
  const std::int32_t planes_patch = is_object ? contact.scene_patch : contact.object_patch;
  auto& vertices = is_object ? scratch.near_object : scratch.near_scene;
  if (is_object)
    keep_near(sides.points, points_patch, slab.object_axis, slab.object_least, vertices);
  else
    keep_near(sides.points, points_patch, -slab.scene_axis, -slab.scene_most, vertices);
  if (vertices.empty()) return;
  const Beyond beyond = is_object ? Beyond{slab.scene_axis, slab.scene_most}
                                  : Beyond{-slab.object_axis, -slab.object_least};
  const SurfaceFeatures& planes = sides.planes;
  const PatchBall& ball = planes.patch_balls[idx(planes_patch)];
  const PatchNormals& normals = planes.patch_normals[idx(planes_patch)];
  const Mat3 points_from_planes = sides.rotation.transpose();
  const Vec3 axis = points_from_planes * normals.axis;
  std::array<Vec3, kMostNear> points;
  std::size_t count = 0;
  for (const std::int32_t v : vertices) {
    const Vec3 p = sides.placed(v);
    if (!is_in_reach(p, 0.0, ball, reach.travel) ||
        !may_touch(sides.points, v, axis, reach.slack + normals.spread))
      continue;
    vertices[count] = v;
    points[count++] = p;
  }
  if (count == 0) return;
  for (const std::int32_t t :
       part_of(planes.patch_triangles, planes.first_triangle, planes_patch)) {
    const SurfaceTriangle& triangle = planes.triangles[idx(t)];
    if (is_beyond(triangle, beyond)) continue;
    for (std::size_t i = 0; i < count; ++i) {
      if (!is_near(planes, triangle, points[i], reach)) continue;
      const std::int32_t v = vertices[i];
      if (!may_touch(sides.points, v, points_from_planes * triangle.normal, reach.slack)) continue;
      add_pair(search, is_object ? RowScratch::FeaturePair{v, t} : RowScratch::FeaturePair{t, v},
               scratch);
    }
  }
}

bool gather_edges(const RowSearch& search, const Contact& contact, const Slab& slab,
                  const PairReach& reach, RowScratch& scratch) noexcept {
  const SurfaceFeatures& b = *search.scene.features;
  PatchBall of_a = search.object.features->patch_balls[idx(contact.object_patch)];
  of_a.center = transform_point(search.scene_from_object, of_a.center);
  scratch.near_edges.clear();
  scratch.near_cones.clear();
  for (const std::int32_t k : part_of(b.patch_edges, b.first_edge, contact.scene_patch)) {
    const ConvexEdge& f = b.edges[idx(k)];
    if (!is_in_reach(f.middle, f.half, of_a, reach.travel)) continue;
    const double least = std::min(slab.scene_axis.dot(b.vertices[idx(f.tail)]),
                                  slab.scene_axis.dot(b.vertices[idx(f.head)]));
    if (least > slab.scene_most || scratch.near_edges.size() == scratch.near_edges.capacity())
      continue;
    scratch.near_edges.push_back({f.middle, f.half, least});
    scratch.near_cones.push_back(cone_of(f, k, search.to_object));
  }
  return !scratch.near_edges.empty();
}

void list_edges(RowSearch& search, const Contact& contact, const Slab& slab, const PairReach& reach,
                std::span<const std::int32_t> planes, RowScratch& scratch) noexcept {
  const SurfaceFeatures& a = *search.object.features;
  const PatchBall& of_b = search.scene.features->patch_balls[idx(contact.scene_patch)];
  const double object_least =
      slab.object_least + slab.scene_axis.dot(search.scene_from_object.position);
  const auto placed = [&](const Vec3& point) -> Vec3 {
    return search.to_scene * point + search.scene_from_object.position;
  };
  for (const std::int32_t i : part_of(a.patch_edges, a.first_edge, contact.object_patch)) {
    const ConvexEdge& e = a.edges[idx(i)];
    const Vec3 middle = placed(e.middle);
    if (!is_in_reach(middle, e.half, of_b, reach.travel)) continue;
    const Vec3 tail = placed(a.vertices[idx(e.tail)]), head = placed(a.vertices[idx(e.head)]);
    const double front = std::max(slab.scene_axis.dot(tail), slab.scene_axis.dot(head));
    if (front < object_least ||
        is_guarded_from_patch(search, scratch.object, planes, e, tail, head))
      continue;
    const double of_e = e.half + reach.travel;
    for (std::size_t k = 0; k < scratch.near_edges.size(); ++k) {
      const RowScratch::NearEdge& f = scratch.near_edges[k];
      const double balls = of_e + f.half;
      if (f.least > front + reach.travel || (middle - f.middle).squaredNorm() > balls * balls)
        continue;
      const RowScratch::EdgeCone& cone = scratch.near_cones[k];
      if (!cones_meet(e, cone, reach.slack)) continue;
      if (reach.is_kept && !are_near(search, tail, head, cone.edge, reach.travel)) continue;
      add_pair(search, {i, cone.edge}, scratch);
    }
  }
}

}  // namespace thigma::detail
