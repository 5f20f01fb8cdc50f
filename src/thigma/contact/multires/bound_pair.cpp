#include "thigma/contact/multires/bound_pair.h"

#include <algorithm>
#include <cmath>

#include "thigma/contact/detail/support_sets.h"

// What a contact of two patches P and Q of any levels says about the finest triangles T and U below
// their nodes.
//
// Let e bound the distance of T from P (from_below), c that of a place of P from T (to_below), h'
// the reach of T outside the culling hull C of its node; all 0 for a finest patch. delta is the
// separation of T and U, delta' of P and Q, n the normal of the contact.
//   delta' <= delta + e_P + e_Q     the closest points of T and U have neighbours on P and Q within
//   e;
//   delta  >= gap_n(C, D) - h'_P - h'_Q     a gap along any axis bounds the distance from below;
//   delta  <= delta' + c(p) + c(q)     T has a point within c(p) of the closest point p of P, U one
//          within c(q) of q.
// In penetration the depth of T and U along n is sup_T n.x - inf_U n.x. The corners of a culling
// hull are points of T, so sup_T lies between that of C and that plus h'; where a node is bounded
// by its own patch instead, c takes the place of the lower end.
//
// Nor are T and U nearer than the distance of the two culling hulls says, up to h': a contact of
// coarse patches that overlap beyond what is below them is moved out to that distance. Nodes above
// are culled no sooner than it reaches d: a contact fades before it is culled.

namespace thigma::detail {
namespace {

// Of bounds against measured distances, times the size of the pair: far above the rounding of
// either.
constexpr double kBoundRounding = 1e-11;
// Of distances of hulls, times the size of the pair.
constexpr double kDistanceRounding = 1e-10;

// Range of what is true of the original triangles.
struct Range {
  double low, high;
};

// Gap of the nodes' hulls along a unit axis, less and more than the rounding of single precision.
Range hull_gap(const QueryFrame& frame, const FrontNode& node, const Vec3& normal) noexcept {
  const HullView a = bare_hull(frame.object, node_a(frame, node.a));
  const HullView b = bare_hull(frame.scene, node_b(frame, node.b));
  const PlacedHulls hulls = place(a, b, frame.pose);
  const float axis[3] = {static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                         static_cast<float>(normal.z())};
  const double low = axis_gap(hulls, frame.pose, axis);
  const double rounding =
      1e-6 * std::fabs(low) + kLaneRounding * (hulls.a.radius + hulls.b.radius) + hulls.rounding;
  return {low, low + 3.0 * rounding};
}

// The nodes' hulls are no nearer than this, where it is more than `enough`, else 0: a contact of
// coarse patches is moved out to it. Its bits do not depend on what is remembered, which only tells
// when it need not be known.
double hull_distance(MultiresQuery& query, FrontNode& node, std::int32_t i,
                     double enough) noexcept {
  QueryFrame& frame = query.frame;
  const double reach =
      frame.query.tolerance + node_a(frame, node.a).hausdorff + node_b(frame, node.b).hausdorff;
  ContactFront& front = frame.front;
  if (i >= 0 && reach - (static_cast<double>(front.expires[i]) - front.travel) <= enough)
    return 0.0;
  const HullView a = hull_view(frame.object, node.a), b = hull_view(frame.scene, node.b);
  const Placement place(a, b, frame.pose);
  ++frame.set.stats.pair_queries;
  const Separation s = closest_points(a, b, frame.pose, kInfinity, node.gjk);
  if (s.status != GjkStatus::gave_up) {
    const double slack = reach - s.distance - kDistanceRounding * place.size;
    if (i >= 0 && slack > 0.0) set_timer(front, i, slack);
    if (s.distance <= enough + kDistanceRounding * place.size) return 0.0;
  }
  SupportedDistance found;
  const SupportSets sets = support_sets(place, s.witness_a - a.center, s.witness_b - a.center);
  if (s.status == GjkStatus::separated && closest_by_support(place, sets, Features::any, found))
    return found.distance;
  GjkCache fresh;
  ++frame.set.stats.pair_queries;
  const Separation again = closest_points(a, b, frame.pose, kInfinity, fresh);
  return again.status == GjkStatus::separated ? again.distance : 0.0;
}

void move_apart(PatchPair& pair, double separation) noexcept {
  const Vec3 step = 0.5 * (separation + pair.depth) * pair.normal;
  pair.witness_a -= step;
  pair.witness_b += step;
  pair.depth = -separation;
}

}  // namespace

void bound_separated(MultiresQuery& query, const PairAtLevel& at_level, FrontNode& node,
                     std::int32_t i, LevelPair& out) noexcept {
  const PatchAtLevel &a = at_level.a, &b = at_level.b;
  PatchPair& pair = out.pair;
  // How far the original triangles may be behind the closest points, both together.
  const double below = distance_to_below(a, at_level.on_a, at_level.point_a) +
                       distance_to_below(b, at_level.on_b, at_level.point_b);
  const double farthest = pair.separation + below;
  const double out_of_hull = a.node.hausdorff + b.node.hausdorff;
  double nearest = std::max(pair.separation - a.from_below() - b.from_below(),
                            hull_gap(query.frame, node, pair.normal).low - out_of_hull);
  if (pair.status == PairContactStatus::separated && a.is_culling_hull() && b.is_culling_hull()) {
    // Beyond rounding, which must not show whether it was measured.
    const double least = pair.separation + 1e-9 * (a.node.radius + b.node.radius);
    const double apart = hull_distance(query, node, i, pair.separation);
    if (apart > least) {
      nearest = std::max(nearest, apart - out_of_hull);
      move_apart(pair, apart);
    }
  }
  const double rounding = kBoundRounding * (a.node.radius + b.node.radius + pair.separation);
  out.nearest = nearest - rounding;
  out.bound = std::max(-pair.depth - nearest, farthest + pair.depth) + rounding;
}

void bound_penetrating(const MultiresQuery& query, const PairAtLevel& at_level,
                       const FrontNode& node, LevelPair& out) noexcept {
  const PatchAtLevel &a = at_level.a, &b = at_level.b;
  const Range gap = hull_gap(query.frame, node, out.pair.normal);
  const double most = a.node.hausdorff + b.node.hausdorff - gap.low;
  const double less = (a.is_culling_hull() ? 0.0 : a.level_patch->to_below) +
                      (b.is_culling_hull() ? 0.0 : b.level_patch->to_below);
  const double least = -gap.high - less;
  const double rounding =
      kBoundRounding * (a.node.radius + b.node.radius + std::fabs(out.pair.depth));
  out.nearest = -most - rounding;
  out.bound = std::max(out.pair.depth - least, most - out.pair.depth) + rounding;
}

}  // namespace thigma::detail
