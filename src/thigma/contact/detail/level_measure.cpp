#include "thigma/contact/detail/level_measure.h"

#include <algorithm>
#include <cmath>

#include "thigma/contact/detail/level_bound.h"
#include "thigma/contact/detail/level_side.h"
#include "thigma/contact/error_metric.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

double speed_at(const LevelQuery& q, const Vec3& on_scene) noexcept {
  if (!q.has_last) return 0.0;
  const RelativePose& x = q.t.pose;
  const Vec3 now = x.rotation * on_scene + x.translation;
  const Vec3 before = q.last.rotation * on_scene + q.last.translation;
  return (now - before).norm() / q.t.query.resolution.step_time;
}

// s0, and whose it is.
struct Threshold {
  double value = kInfinity;  // [m]
  LevelDecision by = LevelDecision::haptic;
  void offer(double other, LevelDecision whose) noexcept {
    if (other < value) *this = {other, whose};
  }
};

// The least of the metrics that are on.
Threshold threshold_at(const LevelQuery& q, const Vec3& on_object, const Vec3& on_scene) noexcept {
  if (q.is_haptic_alone) return {q.threshold, LevelDecision::haptic};
  const RefinementMetric& metric = q.t.query.resolution.metric;
  Threshold least;
  if (metric.haptic > 0.0) least.value = q.threshold;
  if (metric.velocity > 0.0)
    least.offer(metric.velocity * speed_at(q, on_scene), LevelDecision::velocity);
  if (metric.view.pixels > 0.0) {
    ViewThreshold view = metric.view;
    if (metric.has_eye) {
      view.distance = (q.t.world_rotation * on_object + q.t.world_position - metric.eye).norm();
    }
    least.offer(view_threshold(view), LevelDecision::view);
  }
  return least;
}

// How far a pair is beyond its limits, above 1 to be refined, and the limit that is nearest or
// exceeded most.
struct Urgency {
  double priority = 0.0;
  LevelDecision by = LevelDecision::haptic;
};

Urgency urgency_of(const LevelQuery& q, const Side& a, const Side& b, const Place& on_a,
                   const Place& on_b, const Vec3& on_object, const Vec3& on_scene) noexcept {
  const Resolution& r = q.t.query.resolution;
  const double weighted = weighted_deviation(
      {a.deviation(), a.resolution(), support_area(a, on_a, r.reading), false},
      {b.deviation(), b.resolution(), support_area(b, on_b, r.reading), false}, r.area);
  const Threshold threshold = threshold_at(q, on_object, on_scene);
  const double over_cap = (a.deviation() + b.deviation()) / q.deviation_cap;
  const double over_threshold = threshold.value > 0.0 ? weighted / threshold.value : kInfinity;
  return {over_cap > 1.0 ? std::max(over_cap, over_threshold) : over_threshold,
          over_cap > over_threshold ? LevelDecision::cap : threshold.by};
}

// The probe of pairs that are not both finest: a coarse patch lies off the surface by up to s, so
// the surface it stands for may be crossed that far from the ends of the segment without anything
// in between.
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
  return exact.separates(exact.context, from + (probe.margin_a / length) * way,
                         to - (probe.margin_b / length) * way);
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
  LevelDecision by = LevelDecision::haptic;

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
  const Urgency urgency = urgency_of(d.q, d.a, d.b, d.on_a, d.on_b, point_a, d.point_b);
  d.priority = urgency.priority;
  d.by = urgency.by;
  return d.needs_contact();
}

}  // namespace

LevelQuery make_level_query(Traversal& t) noexcept {
  const RefinementMetric& metric = t.query.resolution.metric;
  const double smaller = std::min(t.object.radius, t.scene.radius);
  LevelQuery q{
      t, {&t.object, &t.scene, t.pose, t.front.object_closed, t.front.scene_closed}, t.front.last};
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
    const HullView view = level_surface(h, static_cast<std::int32_t>(i));
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
  if (std::max(na.level, nb.level) > q.t.query.resolution.coarsest_level) return true;
  const double sa = na.contact >= 0 ? q.t.object.level_patches[at(na.contact)].deviation : 0.0;
  const double sb = nb.contact >= 0 ? q.t.scene.level_patches[at(nb.contact)].deviation : 0.0;
  if (sa + sb > q.deviation_cap) return true;
  if (!q.is_haptic_alone) return false;
  const double area = largest_area(q, n);
  const SupportArea either = SupportArea::larger;
  return weighted_deviation({sa, q.t.object.levels[at(na.level)].resolution, area, false},
                            {sb, q.t.scene.levels[at(nb.level)].resolution, area, false},
                            either) > q.threshold;
}

LevelPair measure_level_pair(LevelQuery& q, FrontNode& n, std::int32_t i) noexcept {
  Traversal& t = q.t;
  ++t.set.stats.tests;
  const Side a = side_of(t.object, n.a), b = side_of(t.scene, n.b);
  LevelPair out;
  out.reach = t.query.tolerance + a.reach() + b.reach();
  const LevelProbe probe{&q.crossing, a.deviation(), b.deviation()};
  Deciding deciding{q, a, b};
  out.pair = measure_patches(a.view, b.view, t.pose, out.reach, t.query.keep_directions,
                             {&separates, &probe}, {&decide, &deciding}, n, t.set.stats);
  PatchPair& pair = out.pair;
  if (pair.status == PairContactStatus::apart) return out;
  out.priority = deciding.priority;
  out.decided_by = deciding.by;
  if (!deciding.needs_contact()) return out;
  const bool is_apart =
      pair.status == PairContactStatus::separated || pair.status == PairContactStatus::beside;
  if (is_apart) {
    const double below = distance_to_below(a, deciding.on_a, deciding.point_a) +
                         distance_to_below(b, deciding.on_b, deciding.point_b);
    bound_separated(q, a, b, below, n, i, out);
  } else {
    bound_penetrating(q, a, b, n, out);
  }
  // Depth of a pair that is turning from beside to through (see pair_contact) is neither the one
  // nor the other.
  const double limit = a.deviation() + b.deviation() + a.hausdorff() + b.hausdorff();
  if (out.bound > limit * (1.0 + 1e-9)) out.priority = kInfinity;
  return out;
}

}  // namespace thigma::detail
