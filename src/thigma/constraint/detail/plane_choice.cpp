#include "thigma/constraint/detail/plane_choice.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/infinity.h"

namespace thigma::detail {
namespace {

constexpr double kSame = 0.98;  // cosine of two normals that count as one

// Of the travel: an object that goes on as it does comes that far until the next model. A plane
// that is farther keeps more triangles behind it than those of the triangles, and costs nothing.
constexpr double kLikely = 0.5;

// Of the travel: by how much the object may go beside the way that it is likely to go, at least. If
// the way has changed by more it may change by as much again.
constexpr double kUnsure = 0.25;

/// What a limit leaves of the way along a normal.
double left_by(const KnownLimit& known, const Vec3& normal, double travel) noexcept {
  const double along = known.normal.dot(normal);
  if (!(along > 0.0)) return travel;
  const double across = std::sqrt(std::max(1.0 - along * along, 0.0));
  return std::min(along * std::max(known.gap, 0.0) + across * travel, travel);
}

/// How far the object comes along a normal, at a point, by the way that it is likely to go. In the
/// air it has nothing to slide along: planes upright beside its way would be many.
double likely_along(const RowSearch& search, const Vec3& at, const Vec3& normal) noexcept {
  const LikelyWay& way = search.way;
  if (!way.is_known || is_in_the_air(search)) return kInfinity;
  const double along = normal.dot(way.linear + way.turn.cross(at - way.center));
  return along + std::max(kUnsure * search.reach.travel, way.change);
}

Vec3 out_of_object(const RowSearch& search, PointsOf points, const Vec3& plane_normal) noexcept {
  if (points == PointsOf::object) return -plane_normal;
  return search.scene_from_object.orientation._transformVector(plane_normal);
}

}  // namespace

bool is_in_the_air(const RowSearch& search) noexcept {
  return search.least_gap > kInTheAir * search.reach.travel;
}

void find_known(std::span<const Contact> contacts, RowSearch& search) noexcept {
  search.known.clear();
  search.least_gap = kInfinity;
  const Contact* nearest = nullptr;
  for (const Contact& contact : contacts)
    if (contact.body == search.body && (nearest == nullptr || contact.depth > nearest->depth))
      nearest = &contact;
  if (nearest == nullptr) return;
  const Quat scene_from_world = search.scene.world_from_mesh.orientation.conjugate();
  add_known(search, {scene_from_world._transformVector(nearest->normal), -nearest->depth});
}

void add_known(RowSearch& search, const KnownLimit& limit) noexcept {
  auto& known = search.known;
  search.least_gap = std::min(search.least_gap, limit.gap);
  const double nearer = limit.gap + kEqual * search.reach.travel;
  const auto same = std::find_if(known.begin(), known.end(), [&](const KnownLimit& k) {
    return k.normal.dot(limit.normal) > kSame;
  });
  if (same != known.end()) {
    if (nearer < same->gap) *same = limit;
  } else if (!known.push_back(limit)) {
    const auto farthest = std::max_element(
        known.begin(), known.end(), [](const auto& x, const auto& y) { return x.gap < y.gap; });
    if (nearer < farthest->gap) *farthest = limit;
  }
}

void add_known(RowSearch& search, PointsOf points, const Vec3& plane_normal,
               double height) noexcept {
  add_known(search, {out_of_object(search, points, plane_normal), height});
}

bool is_known(const RowSearch& search, const Vec3& normal) noexcept {
  return std::any_of(search.known.begin(), search.known.end(),
                     [&](const KnownLimit& k) { return k.normal.dot(normal) > kSame; });
}

double forbidden(const RowSearch& search, const Vec3& at, const Vec3& normal,
                 double height) noexcept {
  const double way = kLikely * search.reach.travel;
  double left = std::min(way, likely_along(search, at, normal));
  for (const KnownLimit& known : search.known) left = std::min(left, left_by(known, normal, way));
  return std::max(left - height, 0.0);
}

double forbidden(const RowSearch& search, PointsOf points, const Vec3& point, std::int32_t vertex,
                 const VertexSide& side, const GuardPlane& plane) noexcept {
  const Vec3 normal = out_of_object(search, points, plane.normal);
  const double height = plane.height(point), way = kLikely * search.reach.travel;
  double left = way;
  for (std::int32_t m = side.first_member[idx(vertex)]; m >= 0; m = side.members[idx(m)].next) {
    const GuardPlane& own = side.planes[idx(side.members[idx(m)].plane)];
    const KnownLimit limit{out_of_object(search, points, own.normal), own.height(point)};
    left = std::min(left, left_by(limit, normal, way));
  }
  const Vec3 at =
      points == PointsOf::object ? point : transform_point(search.scene_from_object, point);
  return std::max(std::min(left - height, forbidden(search, at, normal, height)), 0.0);
}

bool may_keep(const RowSearch& search, double height, double distance) noexcept {
  constexpr double kShare = 0.5;  // of what is nearest: nothing comes nearer than that by itself
  return height >= kShare * std::clamp(search.least_gap, 0.0, distance) - search.rounding;
}

double least_shared(const RowSearch& search, double distance) noexcept {
  constexpr double kShare = 0.5;  // of the distance
  return is_in_the_air(search) ? kShare * distance : kLikely * search.reach.travel;
}

EdgePlanes planes_through(const ConvexEdge& edge, const Vec3& on_edge, const Vec3& a,
                          const Vec3& b) noexcept {
  EdgePlanes planes;
  const Vec3 left = edge.direction.cross(edge.into_left);
  const Vec3 right = edge.into_right.cross(edge.direction);
  planes.normal[0] = left;
  planes.normal[1] = right;
  const auto across = [&](const Vec3& point) -> Vec3 {
    const Vec3 from = point - on_edge;
    return from - edge.direction.dot(from) * edge.direction;
  };
  const Vec3 first = across(a), way = across(b) - first;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp(-first.dot(way) / square, 0.0, 1.0) : 0.0;
  const Vec3 middle = first + share * way;
  const double length = middle.norm();
  if (!(length > 0.0)) return planes;
  // Between the faces' normals, where the surface about the edge lies behind it.
  const double turn = left.cross(right).dot(edge.direction);
  if (turn * left.cross(middle).dot(edge.direction) > 0.0 &&
      turn * middle.cross(right).dot(edge.direction) > 0.0)
    planes.normal[2] = middle / length;
  return planes;
}

}  // namespace thigma::detail
