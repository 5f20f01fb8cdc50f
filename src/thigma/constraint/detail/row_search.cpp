#include "thigma/constraint/detail/row_search.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/elementary.h"
#include "thigma/math/infinity.h"

namespace thigma::detail {
namespace {

double farthest_along(const SurfaceFeatures& features, std::int32_t patch,
                      const Vec3& axis) noexcept {
  double most = -kInfinity;
  for (const std::int32_t v : part_of(features.patch_vertices, features.first_vertex, patch))
    most = std::max(most, axis.dot(features.vertices[idx(v)]));
  return most;
}

/// In the scene's mesh frame, no longer than the travel.
LikelyWay placed_way(const RowReach& reach, const Pose& scene_from_world) noexcept {
  LikelyWay way = reach.way;
  if (!way.is_known) return way;
  const double most = length_of_way(reach);
  const double share = most > reach.travel ? reach.travel / most : 1.0;
  way.linear = share * scene_from_world.orientation._transformVector(way.linear);
  way.turn = share * scene_from_world.orientation._transformVector(way.turn);
  way.center = transform_point(scene_from_world, way.center);
  return way;
}

double size_of(const PlacedFeatures& placed) noexcept {
  return placed.features->size + placed.world_from_mesh.position.norm();
}

}  // namespace

double length_of_way(const RowReach& reach) noexcept {
  const double arm = reach.turn > 0.0 ? reach.travel / reach.turn : 0.0;
  return reach.way.linear.norm() + arm * reach.way.turn.norm();
}

RowSearch make_search(const BodyPair& pair, const RowReach& reach) noexcept {
  const PlacedFeatures &object = pair.object, &scene = pair.scene;
  RowSearch search{.object = object, .scene = scene, .body = pair.body, .reach = reach};
  search.scene_from_object = inverse(scene.world_from_mesh) * object.world_from_mesh;
  search.object_from_scene = inverse(search.scene_from_object);
  search.to_scene = search.scene_from_object.orientation.toRotationMatrix();
  search.to_object = search.object_from_scene.orientation.toRotationMatrix();
  search.way = placed_way(reach, inverse(scene.world_from_mesh));
  // Coordinates are exact to 2^-52 of their size; products of a few lose a little more.
  constexpr double kRounding = 1e-12;
  search.rounding = kRounding * (size_of(object) + size_of(scene));
  constexpr double kWide = 1.5;  // of an angle that leaves nothing of a cone [rad]
  search.cone_slack = sine(std::min(reach.turn, kWide)) + 1e-9;
  return search;
}

Slab find_slab(const RowSearch& search, const Contact& contact, double travel) noexcept {
  const SurfaceFeatures& a = *search.object.features;
  const SurfaceFeatures& b = *search.scene.features;
  const Quat scene_from_world = search.scene.world_from_mesh.orientation.conjugate();
  Slab slab;
  slab.scene_axis = scene_from_world._transformVector(contact.normal);
  slab.object_axis = search.object_from_scene.orientation._transformVector(slab.scene_axis);
  const double shift = slab.scene_axis.dot(search.scene_from_object.position);
  const double object_front = farthest_along(a, contact.object_patch, slab.object_axis) + shift;
  const double scene_front = -farthest_along(b, contact.scene_patch, -slab.scene_axis);
  slab.object_least = scene_front - travel - shift;
  slab.scene_most = object_front + travel;
  return slab;
}

void keep_near(const SurfaceFeatures& features, std::int32_t patch, const Vec3& axis, double least,
               std::vector<std::int32_t>& near) noexcept {
  near.clear();
  for (const std::int32_t v : part_of(features.patch_vertices, features.first_vertex, patch)) {
    if (features.is_corner[idx(v)] != 0 && axis.dot(features.vertices[idx(v)]) >= least &&
        near.size() < kMostNear)
      near.push_back(v);
  }
}

void add_row(RowSearch& search, std::vector<FoundRow>& rows, const FoundRow& row) noexcept {
  if (rows.size() == rows.capacity()) {
    ++search.left_out;
    return;
  }
  rows.push_back(row);
}

std::uint64_t id_of(const RowSearch& search, RowKind kind, std::int32_t a,
                    std::int32_t b) noexcept {
  std::uint64_t h = 0x9e3779b97f4a7c15u * (static_cast<std::uint64_t>(search.body) + 1);
  for (const std::uint64_t part : {static_cast<std::uint64_t>(kind), static_cast<std::uint64_t>(a),
                                   static_cast<std::uint64_t>(b)}) {
    h ^= part + 0x9e3779b97f4a7c15u + (h << 6) + (h >> 2);
    h *= 0xff51afd7ed558ccdu;
  }
  return h;
}

FoundRow plane_row(const RowSearch& search, PointsOf side, std::int32_t vertex,
                   const GuardPlane& plane) noexcept {
  FoundRow found;
  ContactRow& row = found.row;
  row.body = search.body;
  const Pose& world_from_scene = search.scene.world_from_mesh;
  const Vec3 foot = plane.offset * plane.normal;
  if (side == PointsOf::object) {
    row.kind = RowKind::scene_plane;
    row.object_point = search.object.features->vertices[idx(vertex)];
    row.scene_direction = -world_from_scene.orientation._transformVector(plane.normal);
    row.scene_point = transform_point(world_from_scene, foot);
    row.id = id_of(search, row.kind, vertex, plane.feature);
    const Vec3 point = transform_point(search.scene_from_object, row.object_point);
    found.gap = plane.height(point);
  } else {
    const Vec3& point = search.scene.features->vertices[idx(vertex)];
    row.kind = RowKind::object_plane;
    row.object_direction = plane.normal;
    row.object_point = foot;
    row.scene_point = transform_point(world_from_scene, point);
    row.id = id_of(search, row.kind, plane.feature, vertex);
    found.gap = plane.height(transform_point(search.object_from_scene, point));
  }
  return found;
}

bool is_member(const VertexSide& side, std::int32_t vertex, std::int32_t plane) noexcept {
  for (std::int32_t m = side.first_member[idx(vertex)]; m >= 0; m = side.members[idx(m)].next)
    if (side.members[idx(m)].plane == plane) return true;
  return false;
}

void add_member(RowSearch& search, PointsOf points, std::int32_t vertex, std::int32_t plane,
                VertexSide& side, std::vector<FoundRow>& rows) noexcept {
  if (side.members.size() == side.members.capacity()) {
    ++search.left_out;
    return;
  }
  std::int32_t& first = side.first_member[idx(vertex)];
  if (first < 0) side.touched.push_back(vertex);
  side.members.push_back({plane, first});
  first = static_cast<std::int32_t>(side.members.size()) - 1;
  add_row(search, rows, plane_row(search, points, vertex, side.planes[idx(plane)]));
}

}  // namespace thigma::detail
