#include "thigma/constraint/detail/edge_planes.h"

#include <algorithm>

#include "thigma/constraint/detail/plane_choice.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// Calls back with the planes that an end has rows with and the other edge lies behind.
template <class Visit>
void each_own_plane(const RowSearch& search, const EdgeEnds& ends, const VertexSide& side,
                    const Visit& visit) noexcept {
  for (const std::int32_t end : {ends.tail, ends.head}) {
    for (std::int32_t m = side.first_member[idx(end)]; m >= 0; m = side.members[idx(m)].next) {
      const std::int32_t index = side.members[idx(m)].plane;
      const GuardPlane& plane = side.planes[idx(index)];
      if (plane.height(ends.other_tail) > search.rounding ||
          plane.height(ends.other_head) > search.rounding)
        continue;
      if (visit(plane, index)) return;
    }
  }
}

/// How much lower over a plane an end may come. Points of the object go by the travel. Planes of
/// the object reach farther than its surface: at a point of the scene they go by the travel of the
/// object's point beside it, and by what turning adds up to there.
double reach_of(const RowSearch& search, const EdgeEnds& ends, const Vec3& at) noexcept {
  if (ends.points_of == PointsOf::object) return search.reach.travel;
  return search.reach.travel + search.reach.turn * (at - ends.other_nearest).norm();
}

/// What rows of both ends with a plane forbid; infinite where it would push an end.
double forbidden_to_ends(const RowSearch& search, const EdgeEnds& ends, double distance,
                         const VertexSide& side, const EdgeGuard& guard) noexcept {
  double most = -kInfinity;
  const auto add = [&](std::int32_t end, const Vec3& at) {
    const double height = guard.plane.height(at);
    const double reach = reach_of(search, ends, at);
    if (guard.index >= 0 ? is_kept(side, end, guard.index, height, reach) : height > reach) return;
    most = std::max(most, may_keep(search, height, distance)
                              ? forbidden(search, ends.points_of, at, end, side, guard.plane)
                              : kInfinity);
  };
  add(ends.tail, ends.at_tail);
  add(ends.head, ends.at_head);
  return most;
}

constexpr std::int32_t kPlanes = 4;   // of an edge
constexpr std::int32_t kBetween = 3;  // of these, the one square to the way

/// Number of a plane through an edge, other than that of any triangle.
std::int32_t feature_of(std::int32_t edge, std::int32_t which) noexcept {
  return ~(kPlanes * edge + which);
}

}  // namespace

bool is_kept(const VertexSide& side, std::int32_t vertex, std::int32_t plane, double height,
             double reach) noexcept {
  return height > reach || is_member(side, vertex, plane);
}

bool is_guarded_from_patch(const RowSearch& search, const VertexSide& side,
                           std::span<const std::int32_t> planes, const ConvexEdge& edge,
                           const Vec3& tail, const Vec3& head) noexcept {
  for (const std::int32_t i : planes) {
    const GuardPlane& plane = side.planes[idx(i)];
    if (is_kept(side, edge.tail, i, plane.height(tail), search.reach.travel) &&
        is_kept(side, edge.head, i, plane.height(head), search.reach.travel))
      return true;
  }
  return false;
}

bool is_kept_apart(RowSearch& search, const EdgeEnds& ends, double distance, VertexSide& side,
                   std::vector<FoundRow>& rows) noexcept {
  const double least = least_shared(search, distance);
  const double of_tail = reach_of(search, ends, ends.at_tail);
  const double of_head = reach_of(search, ends, ends.at_head);
  for (std::size_t i = 0; i < side.planes.size(); ++i) {
    const GuardPlane& plane = side.planes[i];
    if (plane.height(ends.other_tail) > search.rounding ||
        plane.height(ends.other_head) > search.rounding)
      continue;
    const double tail = plane.height(ends.at_tail), head = plane.height(ends.at_head);
    const auto index = static_cast<std::int32_t>(i);
    const bool keeps_tail = is_kept(side, ends.tail, index, tail, of_tail);
    if (!keeps_tail && tail <= least) continue;
    const bool keeps_head = is_kept(side, ends.head, index, head, of_head);
    if (!keeps_head && head <= least) continue;
    if (!keeps_tail) add_member(search, ends.points_of, ends.tail, index, side, rows);
    if (!keeps_head) add_member(search, ends.points_of, ends.head, index, side, rows);
    return true;
  }
  return false;
}

void choose_plane(const RowSearch& search, const EdgeEnds& ends, double distance,
                  const VertexSide& side, EdgeGuard& best) noexcept {
  const auto compare = [&](const GuardPlane& plane, std::int32_t index) {
    EdgeGuard guard{0.0, plane, index, &ends};
    guard.forbids = forbidden_to_ends(search, ends, distance, side, guard);
    if (guard.forbids < best.forbids - kEqual * search.reach.travel) best = guard;
    return false;
  };
  each_own_plane(search, ends, side, compare);
  const Vec3 between = (ends.nearest - ends.other_nearest) / distance;
  compare({between, between.dot(ends.other_nearest), feature_of(ends.other_index, kBetween)}, -1);
  const EdgePlanes through =
      planes_through(*ends.other, ends.other_tail, ends.at_tail, ends.at_head);
  std::int32_t which = 0;
  for (const Vec3& normal : through.normal) {
    const std::int32_t feature = feature_of(ends.other_index, which++);
    if (normal.isZero(0.0)) continue;
    const double offset = std::max(normal.dot(ends.other_tail), normal.dot(ends.other_head));
    compare({normal, offset, feature}, -1);
  }
}

bool is_between(const EdgeGuard& guard) noexcept {
  const std::int32_t feature = guard.plane.feature;
  return guard.ends != nullptr && feature < 0 && ~feature % kPlanes == kBetween;
}

void keep_ends(RowSearch& search, const EdgeGuard& guard, VertexSide& side,
               std::vector<FoundRow>& rows) noexcept {
  std::int32_t index = guard.index;
  if (index < 0) {
    if (side.planes.size() == side.planes.capacity()) {
      ++search.left_out;
      return;
    }
    side.planes.push_back(guard.plane);
    index = static_cast<std::int32_t>(side.planes.size()) - 1;
  }
  const EdgeEnds& ends = *guard.ends;
  if (!is_kept(side, ends.tail, index, guard.plane.height(ends.at_tail),
               reach_of(search, ends, ends.at_tail)))
    add_member(search, ends.points_of, ends.tail, index, side, rows);
  if (!is_kept(side, ends.head, index, guard.plane.height(ends.at_head),
               reach_of(search, ends, ends.at_head)))
    add_member(search, ends.points_of, ends.head, index, side, rows);
}

}  // namespace thigma::detail
