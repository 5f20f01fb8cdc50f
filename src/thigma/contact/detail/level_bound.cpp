#include "thigma/contact/detail/level_bound.h"

#include <algorithm>
#include <cmath>

#include "thigma/contact/detail/support_sets.h"
#include "thigma/convex/patch_separation.h"

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
Range hull_gap(const Traversal& t, const FrontNode& n, const Vec3& normal) noexcept {
  const NodePair pair = place(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose);
  const float axis[3] = {static_cast<float>(normal.x()), static_cast<float>(normal.y()),
                         static_cast<float>(normal.z())};
  const double low = axis_gap(pair, t.pose, axis);
  const double rounding =
      1e-6 * std::fabs(low) + kLaneRounding * (pair.a.radius + pair.b.radius) + pair.rounding;
  return {low, low + 3.0 * rounding};
}

// The nodes' hulls are no nearer than this, where it is more than `enough`, else 0: a contact of
// coarse patches is moved out to it. Its bits do not depend on what is remembered, which only tells
// when it need not be known.
double hull_distance(LevelQuery& q, FrontNode& n, std::int32_t i, double enough) noexcept {
  Traversal& t = q.t;
  const double reach = t.query.tolerance + node_a(t, n.a).hausdorff + node_b(t, n.b).hausdorff;
  ContactFront& f = t.front;
  if (i >= 0 && reach - (static_cast<double>(f.expires[i]) - f.travel) <= enough) return 0.0;
  const HullView a = hull_view(t.object, n.a), b = hull_view(t.scene, n.b);
  const Placement place(a, b, t.pose);
  ++t.set.stats.pair_queries;
  const Separation s = closest_points(a, b, t.pose, kInfinity, n.gjk);
  if (s.status != GjkStatus::gave_up) {
    const double slack = reach - s.distance - kDistanceRounding * place.size;
    if (i >= 0 && slack > 0.0) set_timer(f, i, slack);
    if (s.distance <= enough + kDistanceRounding * place.size) return 0.0;
  }
  SupportedDistance found;
  const SupportSets sets = support_sets(place, s.witness_a - a.center, s.witness_b - a.center);
  if (s.status == GjkStatus::separated && closest_by_support(place, sets, Features::any, found))
    return found.distance;
  GjkCache fresh;
  ++t.set.stats.pair_queries;
  const Separation again = closest_points(a, b, t.pose, kInfinity, fresh);
  return again.status == GjkStatus::separated ? again.distance : 0.0;
}

// Separation of two finest patches below a pair that are likely the nearest: an upper bound of that
// of all. Goes down to the child whose ball reaches farthest towards the other's centre.
double near_pair_distance(const Traversal& t, std::int32_t a, std::int32_t b,
                          double limit) noexcept {
  while (!is_leaf_pair(t, a, b)) {
    const ClodNode& na = node_a(t, a);
    const ClodNode& nb = node_b(t, b);
    const bool of_a = na.child_count > 0 && (nb.child_count == 0 || na.radius >= nb.radius);
    const Vec3 other = of_a ? Vec3(t.pose.rotation * nb.center + t.pose.translation)
                            : Vec3(t.pose.rotation.transpose() * (na.center - t.pose.translation));
    const ClodNode& parent = of_a ? na : nb;
    double least = kInfinity;
    std::int32_t next = parent.first_child;
    for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
      const ClodNode& child = of_a ? node_a(t, c) : node_b(t, c);
      const double gap = std::sqrt((child.center - other).squaredNorm()) - child.radius;
      if (!(gap < least)) continue;
      least = gap;
      next = c;
    }
    (of_a ? a : b) = next;
  }
  GjkCache fresh;
  return patch_separation(hull_view(t.object, a), hull_view(t.scene, b), t.pose, limit, fresh)
      .distance;
}

void move_apart(PatchPair& pair, double separation) noexcept {
  const Vec3 step = 0.5 * (separation + pair.depth) * pair.normal;
  pair.witness_a -= step;
  pair.witness_b += step;
  pair.depth = -separation;
}

}  // namespace

void bound_separated(LevelQuery& q, const Side& a, const Side& b, double below, FrontNode& n,
                     std::int32_t i, LevelPair& out) noexcept {
  PatchPair& pair = out.pair;
  double farthest = pair.separation + below;
  if (q.t.query.resolution.tightens_bounds) {
    farthest = std::min(farthest, near_pair_distance(q.t, n.a, n.b, farthest));
  }
  const double out_of_hull = a.node.hausdorff + b.node.hausdorff;
  double nearest = std::max(pair.separation - a.from_below() - b.from_below(),
                            hull_gap(q.t, n, pair.normal).low - out_of_hull);
  if (pair.status == PairContactStatus::separated && a.is_culling_hull() && b.is_culling_hull()) {
    // Beyond rounding, which must not show whether it was measured.
    const double least = pair.separation + 1e-9 * (a.node.radius + b.node.radius);
    const double apart = hull_distance(q, n, i, pair.separation);
    if (apart > least) {
      nearest = std::max(nearest, apart - out_of_hull);
      move_apart(pair, apart);
    }
  }
  const double rounding = kBoundRounding * (a.node.radius + b.node.radius + pair.separation);
  out.nearest = nearest - rounding;
  out.bound = std::max(-pair.depth - nearest, farthest + pair.depth) + rounding;
}

void bound_penetrating(const LevelQuery& q, const Side& a, const Side& b, const FrontNode& n,
                       LevelPair& out) noexcept {
  const Range gap = hull_gap(q.t, n, out.pair.normal);
  const double most = a.node.hausdorff + b.node.hausdorff - gap.low;
  const double less = (a.is_culling_hull() ? 0.0 : a.patch->to_below) +
                      (b.is_culling_hull() ? 0.0 : b.patch->to_below);
  const double least = -gap.high - less;
  const double rounding =
      kBoundRounding * (a.node.radius + b.node.radius + std::fabs(out.pair.depth));
  out.nearest = -most - rounding;
  out.bound = std::max(out.pair.depth - least, most - out.pair.depth) + rounding;
}

}  // namespace thigma::detail
