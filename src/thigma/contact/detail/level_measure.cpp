#include "thigma/contact/detail/level_measure.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "thigma/contact/error_metric.h"
#include "thigma/convex/triangle_distance.h"

// What a contact of two patches P and Q of any levels says about the finest triangles T and U below their nodes.
//
// Let e bound the distance of T from P (from_below), c that of a place of P from T (to_below), h' the reach of T
// outside the culling hull C of its node; all 0 for a finest patch. delta is the separation of T and U, delta' of P
// and Q, n the normal of the contact.
//   delta' <= delta + e_P + e_Q     the closest points of T and U have neighbours on P and Q within e;
//   delta  >= gap_n(C, D) - h'_P - h'_Q     a gap along any axis bounds the distance from below;
//   delta  <= delta' + c(p) + c(q)     T has a point within c(p) of the closest point p of P, U one within c(q) of q.
// In penetration the depth of T and U along n is sup_T n.x - inf_U n.x. The corners of a culling hull are points of T,
// so sup_T lies between that of C and that plus h'; where a node is bounded by its own patch instead, c takes the place
// of the lower end.
//
// Nor are T and U nearer than the distance of the two culling hulls says, up to h': a contact of coarse patches that
// overlap beyond what is below them is moved out to that distance. Nodes above are culled no sooner than it reaches d:
// a contact fades before it is culled.

namespace thigma::detail {
namespace {

// Of bounds against measured distances, times the size of the pair: far above the rounding of either.
constexpr double kBoundRounding = 1e-11;

std::size_t at(std::int32_t i) noexcept { return static_cast<std::size_t>(i); }

// One side of a pair.
struct Side {
  const ClodHierarchy& h;
  const ClodNode& node;
  HullView view;                        // the patch
  const ClodContactPatch* patch;        // null: finest
  bool is_finest() const noexcept { return patch == nullptr; }
  double deviation() const noexcept { return patch != nullptr ? patch->deviation : 0.0; }
  double hausdorff() const noexcept { return patch != nullptr ? patch->hausdorff : 0.0; }
  double from_below() const noexcept { return patch != nullptr ? patch->from_below : 0.0; }
  double resolution() const noexcept { return h.levels[at(node.level)].resolution; }
  // The hull of the node is one of points of the original.
  bool is_culling_hull() const noexcept { return patch == nullptr || node.first_vertex != patch->first_vertex; }
  // How far whatever is below reaches outside the patch.
  double reach() const noexcept { return patch != nullptr ? std::max(patch->hausdorff, patch->from_below) : 0.0; }
};

Side side_of(const ClodHierarchy& h, std::int32_t i) noexcept {
  const ClodNode& node = h.nodes[at(i)];
  return {h, node, contact_view(h, i), node.contact >= 0 ? &h.contact_patches[at(node.contact)] : nullptr};
}

// ---- places on a patch ------------------------------------------------------------------------------------------

// Weights of the corners of a triangle for the point of its plane below p, clamped to the triangle.
Vec3 clamped_weights(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const Vec3 n = (b - a).cross(c - a);
  const double area2 = n.squaredNorm();
  if (!(area2 > 0.0)) return Vec3::Constant(1.0 / 3.0);
  const double u = std::max((c - b).cross(p - b).dot(n), 0.0);
  const double v = std::max((a - c).cross(p - c).dot(n), 0.0);
  const double w = std::max((b - a).cross(p - a).dot(n), 0.0);
  return Vec3(u, v, w) / (u + v + w);
}

struct Place {
  int corner[3] = {0, 0, 0};
  Vec3 weight = Vec3::UnitX();
  int triangle = -1;
};

// Where on its patch a closest point lies. feature: the hull vertices that span it, 0 unknown.
Place find_place(const HullView& view, std::uint32_t feature, const Vec3& p) noexcept {
  Place place;
  if (std::popcount(feature) == 1) {
    place.corner[0] = std::countr_zero(feature);
    return place;
  }
  if (std::popcount(feature) == 2) {
    place.corner[0] = std::countr_zero(feature);
    place.corner[1] = 31 - std::countl_zero(feature);
    const Vec3 e = view.vertices[place.corner[1]] - view.vertices[place.corner[0]];
    const double length2 = e.squaredNorm();
    const double t = length2 > 0.0 ? (p - view.vertices[place.corner[0]]).dot(e) / length2 : 0.5;
    const double clamped = std::min(std::max(t, 0.0), 1.0);
    place.weight = Vec3(1.0 - clamped, clamped, 0.0);
    return place;
  }
  double least = kInfinity;
  for (int t = 0; t < view.triangle_count; ++t) {
    const HullTriangle& tri = view.triangles[t];
    if (feature != 0 && (tri.mask & feature) != tri.mask) continue;
    const Vec3 &a = view.vertices[tri.corner[0]], &b = view.vertices[tri.corner[1]], &c = view.vertices[tri.corner[2]];
    const Vec3 weight = clamped_weights(p, a, b, c);
    const double d2 = (weight.x() * a + weight.y() * b + weight.z() * c - p).squaredNorm();
    if (!(d2 < least)) continue;
    least = d2;
    place = {{tri.corner[0], tri.corner[1], tri.corner[2]}, weight, t};
  }
  return place;
}

double support_area(const Side& side, const Place& place, SupportReading reading) noexcept {
  if (side.h.support.empty()) return 0.0;  // no simplified levels
  const std::array<double, 2>* first = side.h.support.data() + (side.view.vertices - side.h.vertices.data());
  const auto r = static_cast<std::size_t>(reading);
  double area = 0.0;
  for (int k = 0; k < 3; ++k) {
    if (place.weight[k] > 0.0) area += place.weight[k] * first[place.corner[k]][r];
  }
  return area;
}

// c: how far the finest triangles below may be from a place of the patch.
double distance_to_below(const Side& side, const Place& place, const Vec3& p) noexcept {
  if (side.is_finest()) return 0.0;
  const float* vertex = side.h.vertex_to_below.data() + side.patch->first_vertex;
  if (place.weight.x() == 1.0) return vertex[place.corner[0]];
  double least = side.patch->to_below;
  if (place.triangle >= 0) {
    least = side.h.triangle_to_below[at(side.patch->patch.first_triangle + place.triangle)];
  }
  for (int k = 0; k < 3; ++k) {  // distances change no faster than the place
    if (!(place.weight[k] > 0.0)) continue;
    least = std::min(least, vertex[place.corner[k]] + (p - side.view.vertices[place.corner[k]]).norm());
  }
  return least;
}

// ---- refinement -------------------------------------------------------------------------------------------------

double speed_at(const LevelQuery& q, const Vec3& on_scene) noexcept {
  if (!q.has_last) return 0.0;
  const RelativePose& x = q.t.pose;
  const Vec3 now = x.rotation * on_scene + x.translation;
  const Vec3 before = q.last.rotation * on_scene + q.last.translation;
  return (now - before).norm() / q.t.query.resolution.step_time;
}

// s0: the least of the metrics that are on.
double threshold_at(const LevelQuery& q, const Vec3& on_object, const Vec3& on_scene) noexcept {
  if (q.is_haptic_alone) return q.threshold;
  const RefinementMetric& metric = q.t.query.resolution.metric;
  double least = metric.haptic > 0.0 ? q.threshold : kInfinity;
  if (metric.velocity > 0.0) least = std::min(least, metric.velocity * speed_at(q, on_scene));
  if (metric.view.pixels > 0.0) {
    ViewThreshold view = metric.view;
    if (metric.has_eye) {
      view.distance = (q.t.world_rotation * on_object + q.t.world_position - metric.eye).norm();
    }
    least = std::min(least, view_threshold(view));
  }
  return least;
}

double priority_of(const LevelQuery& q, const Side& a, const Side& b, const Place& on_a, const Place& on_b,
                   const Vec3& on_object, const Vec3& on_scene) noexcept {
  const Resolution& r = q.t.query.resolution;
  const double weighted =
      weighted_deviation({a.deviation(), a.resolution(), support_area(a, on_a, r.reading), false},
                         {b.deviation(), b.resolution(), support_area(b, on_b, r.reading), false}, r.area);
  const double threshold = threshold_at(q, on_object, on_scene);
  const double over_cap = (a.deviation() + b.deviation()) / q.deviation_cap;
  const double over_threshold = threshold > 0.0 ? weighted / threshold : kInfinity;
  return over_cap > 1.0 ? std::max(over_cap, over_threshold) : over_threshold;
}

// ---- bounds -----------------------------------------------------------------------------------------------------

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
  const double rounding = 1e-6 * std::fabs(low) + kLaneRounding * (pair.a.radius + pair.b.radius) + pair.rounding;
  return {low, low + 3.0 * rounding};
}

// The nodes' hulls are no nearer than this: a contact of coarse patches is moved out to it. Measured afresh, so that
// its bits do not depend on what is remembered; not at all where the front knows that it is below `enough`.
double hull_distance(LevelQuery& q, const FrontNode& n, std::int32_t i, double enough) noexcept {
  Traversal& t = q.t;
  const double reach = t.query.tolerance + node_a(t, n.a).hausdorff + node_b(t, n.b).hausdorff;
  ContactFront& f = t.front;
  if (i >= 0 && reach - (static_cast<double>(f.expires[i]) - f.travel) <= enough) return 0.0;
  const NodePair pair = place(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose);
  GjkCache fresh;
  ++t.set.stats.pair_queries;
  const Separation s = closest_points(pair.a, pair.b, t.pose, kInfinity, fresh);
  if (i >= 0) {
    const double slack = reach - s.distance - pair.rounding - 1e-11 * (pair.a.radius + pair.b.radius);
    if (slack > 0.0) set_timer(f, i, slack);
  }
  return s.status == PairStatus::separated ? s.distance : 0.0;
}

// Separation of two finest patches below a pair that are likely the nearest: an upper bound of that of all. Goes down
// to the child whose ball reaches farthest towards the other's centre.
double near_pair_distance(const Traversal& t, std::int32_t a, std::int32_t b, double limit) noexcept {
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
  return patch_separation(hull_view(t.object, a), hull_view(t.scene, b), t.pose, limit, fresh).distance;
}

void move_apart(PatchPair& pair, double separation) noexcept {
  const Vec3 step = 0.5 * (separation + pair.depth) * pair.normal;
  pair.witness_a -= step;
  pair.witness_b += step;
  pair.depth = -separation;
}

void bound_separated(LevelQuery& q, const Side& a, const Side& b, double below, const FrontNode& n, std::int32_t i,
                     LevelPair& out) noexcept {
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

void bound_penetrating(const LevelQuery& q, const Side& a, const Side& b, const FrontNode& n, LevelPair& out) noexcept {
  const Range gap = hull_gap(q.t, n, out.pair.normal);
  const double most = a.node.hausdorff + b.node.hausdorff - gap.low;
  const double less = (a.is_culling_hull() ? 0.0 : a.patch->to_below) + (b.is_culling_hull() ? 0.0 : b.patch->to_below);
  const double least = -gap.high - less;
  const double rounding = kBoundRounding * (a.node.radius + b.node.radius + std::fabs(out.pair.depth));
  out.nearest = -most - rounding;
  out.bound = std::max(out.pair.depth - least, most - out.pair.depth) + rounding;
}

// The probe of pairs that are not both finest: a coarse patch lies off the surface by up to s, so the surface it stands
// for may be crossed that far from the ends of the segment without anything in between.
struct LevelProbe {
  const CrossingContext* crossing;
  double margin_a, margin_b;
};

bool separates(const void* context, const Vec3& from, const Vec3& to) noexcept {
  const auto& probe = *static_cast<const LevelProbe*>(context);
  const Vec3 way = to - from;
  const double length = std::sqrt(way.squaredNorm());
  if (!(length > probe.margin_a + probe.margin_b)) return false;
  const SegmentProbe exact = crossing_probe(*probe.crossing);
  return exact.separates(exact.context, from + (probe.margin_a / length) * way, to - (probe.margin_b / length) * way);
}

// D of the pair, at most: by the largest areas of its patches.
double largest_area(const LevelQuery& q, const FrontNode& n) noexcept {
  const ContactFront& f = q.t.front;
  const Resolution& r = q.t.query.resolution;
  const auto reading = static_cast<std::size_t>(r.reading);
  const double a = f.object_support.empty() ? 0.0 : f.object_support[at(n.a)][reading];
  const double b = f.scene_support.empty() ? 0.0 : f.scene_support[at(n.b)][reading];
  return r.area == SupportArea::larger ? std::max(a, b) : std::min(a, b);
}

// Metric and place of a pair, asked for as soon as its closest points are known.
struct Deciding {
  const LevelQuery& q;
  const Side& a;
  const Side& b;
  Place on_a{}, on_b{};
  Vec3 point_a = Vec3::Zero(), point_b = Vec3::Zero();  // each in the frame of its own body
  double priority = 0.0;

  // What is only split needs no contact of its own; with a budget it may have to do with it.
  bool needs_contact() const noexcept {
    const Resolution& r = q.t.query.resolution;
    if (r.budget_tests > 0 || r.budget_cpu > 0.0) return true;
    return r.interpolates ? priority < 1.0 : !(priority > 1.0);
  }
};

bool decide(void* context, std::uint32_t feature_a, std::uint32_t feature_b, const Vec3& point_a,
            const Vec3& point_b) noexcept {
  auto& d = *static_cast<Deciding*>(context);
  const RelativePose& x = d.q.t.pose;
  d.point_a = point_a;
  d.point_b = x.rotation.transpose() * (point_b - x.translation);
  d.on_a = find_place(d.a.view, feature_a, d.point_a);
  d.on_b = find_place(d.b.view, feature_b, d.point_b);
  d.priority = priority_of(d.q, d.a, d.b, d.on_a, d.on_b, point_a, d.point_b);
  return d.needs_contact();
}

}  // namespace

LevelQuery make_level_query(Traversal& t) noexcept {
  const RefinementMetric& metric = t.query.resolution.metric;
  const double smaller = std::min(t.object.radius, t.scene.radius);
  LevelQuery q{t, {&t.object, &t.scene, t.pose, t.front.object_closed, t.front.scene_closed}, t.front.last};
  q.is_haptic_alone = !(metric.velocity > 0.0) && !(metric.view.pixels > 0.0);
  q.threshold = std::max(metric.haptic, 0.0) * smaller;
  q.deviation_cap = t.query.resolution.deviation_cap * smaller;
  q.now = static_cast<float>(t.front.travel * (1.0 + 1e-6));
  return q;
}

std::vector<std::array<double, 2>> largest_support(const ClodHierarchy& h) {
  std::vector<std::array<double, 2>> largest;
  if (h.support.empty()) return largest;
  largest.assign(h.nodes.size(), {0.0, 0.0});
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    if (is_free(h.nodes[i])) continue;
    const HullView view = contact_view(h, static_cast<std::int32_t>(i));
    const std::array<double, 2>* support = h.support.data() + (view.vertices - h.vertices.data());
    for (int v = 0; v < view.vertex_count; ++v) {
      for (std::size_t k = 0; k < 2; ++k) largest[i][k] = std::max(largest[i][k], support[v][k]);
    }
  }
  return largest;
}

bool is_always_refined(const LevelQuery& q, const FrontNode& n) noexcept {
  const ClodNode& na = node_a(q.t, n.a);
  const ClodNode& nb = node_b(q.t, n.b);
  if (is_free(na) || is_free(nb)) return true;
  const double sa = na.contact >= 0 ? q.t.object.contact_patches[at(na.contact)].deviation : 0.0;
  const double sb = nb.contact >= 0 ? q.t.scene.contact_patches[at(nb.contact)].deviation : 0.0;
  if (sa + sb > q.deviation_cap) return true;
  if (!q.is_haptic_alone) return false;
  const double area = largest_area(q, n);
  const SupportArea either = SupportArea::larger;
  return weighted_deviation({sa, q.t.object.levels[at(na.level)].resolution, area, false},
                            {sb, q.t.scene.levels[at(nb.level)].resolution, area, false}, either) > q.threshold;
}

LevelPair measure_level_pair(LevelQuery& q, FrontNode& n, std::int32_t i) noexcept {
  Traversal& t = q.t;
  ++t.set.stats.tests;
  const Side a = side_of(t.object, n.a), b = side_of(t.scene, n.b);
  LevelPair out;
  out.reach = t.query.tolerance + a.reach() + b.reach();
  const LevelProbe probe{&q.crossing, a.deviation(), b.deviation()};
  Deciding deciding{q, a, b};
  out.pair = measure_patches(a.view, b.view, t.pose, out.reach, t.query.keep_directions, {&separates, &probe},
                             {&decide, &deciding}, n, t.set.stats);
  PatchPair& pair = out.pair;
  if (pair.status == PairContactStatus::apart) return out;
  out.priority = deciding.priority;
  if (!deciding.needs_contact()) return out;
  const bool is_apart = pair.status == PairContactStatus::separated || pair.status == PairContactStatus::beside;
  if (is_apart) {
    const double below = distance_to_below(a, deciding.on_a, deciding.point_a) + distance_to_below(b, deciding.on_b, deciding.point_b);
    bound_separated(q, a, b, below, n, i, out);
  } else {
    bound_penetrating(q, a, b, n, out);
  }
  // Depth of a pair that is turning from beside to through (see pair_contact) is neither the one nor the other.
  const double limit = a.deviation() + b.deviation() + a.hausdorff() + b.hausdorff();
  if (out.bound > limit * (1.0 + 1e-9)) out.priority = kInfinity;
  return out;
}

}  // namespace thigma::detail
