#include "thigma/constraint/coarse_rows.h"

#include <algorithm>

#include "thigma/contact/contact_node.h"
#include "thigma/core/index.h"
#include "thigma/math/infinity.h"

namespace thigma {
namespace {

constexpr double kRounding = 1e-12;  // of a height, times the coordinates that it is made of

/// Largest value of axis . v over the vertices of a node [m; body frame].
double most_along(const ClodHierarchy& hierarchy, const ClodNode& node, const Vec3& axis) noexcept {
  double most = -kInfinity;
  for (std::int32_t i = 0; i < node.vertex_count; ++i)
    most = std::max(most, axis.dot(hierarchy.vertices[idx(node.first_vertex + i)]));
  return most;
}

std::uint64_t id_of(const Contact& contact) noexcept {
  std::uint64_t h = 0xd6e8feb86659fd93u * (static_cast<std::uint64_t>(contact.body) + 1);
  for (const std::int32_t part : {contact.object_patch, contact.scene_patch}) {
    h ^= static_cast<std::uint64_t>(part) + 0x9e3779b97f4a7c15u + (h << 6) + (h >> 2);
    h *= 0xff51afd7ed558ccdu;
  }
  return h;
}

FoundRow row_of(const PlacedHierarchy& object, const SceneBody& body, const Contact& contact,
                double turn) noexcept {
  const ClodNode& a =
      object.hierarchy.nodes[idx(contact_node(object.hierarchy, contact.object_patch))];
  const ClodNode& b =
      body.hierarchy->nodes[idx(contact_node(*body.hierarchy, contact.scene_patch))];
  const Vec3& n = contact.normal;
  const auto in_body = [&](const Pose& pose) -> Vec3 {
    return pose.orientation.conjugate()._transformVector(n);
  };
  const Vec3 middle = transform_point(object.world_from_body, a.center);
  const Vec3 axis = in_body(object.world_from_body);
  const double object_most = n.dot(middle) + most_along(object.hierarchy, a, axis) -
                             axis.dot(a.center) + a.hausdorff + turn * (a.radius + a.hausdorff);
  const double scene_least = n.dot(body.world_from_body.position) -
                             most_along(*body.hierarchy, b, -in_body(body.world_from_body)) -
                             b.hausdorff;
  FoundRow found;
  found.gap = scene_least - object_most -
              kRounding * (middle.lpNorm<1>() + body.world_from_body.position.lpNorm<1>() +
                           a.radius + b.center.lpNorm<1>() + b.radius);
  found.row = make_row(RowKind::scene_plane);
  found.row.id = id_of(contact);
  found.row.object_point = a.center;
  found.row.scene_point = middle + found.gap * n;
  found.row.scene_direction = n;
  found.row.body = -1;
  return found;
}

}  // namespace

void find_coarse_rows(const PlacedHierarchy& object, std::span<const SceneBody> bodies,
                      std::span<const Contact> contacts, const RowReach& reach,
                      std::vector<FoundRow>& rows) noexcept {
  for (const Contact& contact : contacts) {
    if (!is_coarse(contact)) continue;
    const FoundRow found = row_of(object, bodies[idx(contact.body)], contact, reach.turn);
    if (found.gap <= reach.travel) rows.push_back(found);
  }
}

}  // namespace thigma
