#include "thigma/contact/multires/measure_pair.h"

#include <algorithm>
#include <cmath>

#include "thigma/contact/error_metric.h"
#include "thigma/contact/multires/bound_pair.h"
#include "thigma/contact/multires/patch_at_level.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

double speed_at(const MultiresQuery& query, const Vec3& on_scene) noexcept {
  if (!query.has_last) return 0.0;
  const RelativePose& x = query.frame.pose;
  const Vec3 now = x.rotation * on_scene + x.translation;
  const Vec3 before = query.last.rotation * on_scene + query.last.translation;
  return (now - before).norm() / query.resolution.step_time;
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
Threshold threshold_at(const MultiresQuery& query, const Vec3& on_object,
                       const Vec3& on_scene) noexcept {
  if (query.is_haptic_alone) return {query.threshold, LevelDecision::haptic};
  const RefinementMetric& metric = query.resolution.metric;
  Threshold least;
  if (metric.haptic > 0.0) least.value = query.threshold;
  if (metric.velocity > 0.0)
    least.offer(metric.velocity * speed_at(query, on_scene), LevelDecision::velocity);
  if (metric.view.pixels > 0.0) {
    ViewThreshold view = metric.view;
    if (metric.has_eye) {
      view.distance =
          (query.frame.world_rotation * on_object + query.frame.world_position - metric.eye).norm();
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

// D of one side: of its place, or of its patch. of_nodes: of its hierarchy.
double area_of(const PatchAtLevel& patch, const SurfaceLocation& location, SupportReading reading,
               const std::vector<std::array<double, kSupportReadings>>& of_nodes) noexcept {
  if (reading != SupportReading::patch) return support_area(patch, location, reading);
  if (of_nodes.empty()) return 0.0;
  const auto node = static_cast<std::size_t>(&patch.node - patch.hierarchy.nodes.data());
  return of_nodes[node][static_cast<std::size_t>(reading)];
}

Urgency urgency_of(const MultiresQuery& query, const PairAtLevel& pair) noexcept {
  const Resolution& r = query.resolution;
  const PatchAtLevel &a = pair.a, &b = pair.b;
  const MultiresFront& front = query.frame.front.multires;
  const double area_a = area_of(a, pair.on_a, r.reading, front.object_support);
  const double area_b = area_of(b, pair.on_b, r.reading, front.scene_support);
  const double weighted =
      weighted_deviation({a.deviation(), a.resolution(), area_a, false},
                         {b.deviation(), b.resolution(), area_b, false}, r.area);
  const Threshold threshold = threshold_at(query, pair.point_a, pair.point_b);
  const double over_cap = (a.deviation() + b.deviation()) / query.deviation_cap;
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

bool separates(const void* context, const ProbeSegment& whole) noexcept {
  const auto& probe = *static_cast<const LevelProbe*>(context);
  const Vec3 segment = whole.to - whole.from;
  const double length = std::sqrt(segment.squaredNorm());
  if (!(length > probe.margin_a + probe.margin_b)) return false;
  const SegmentProbe exact = crossing_probe(*probe.crossing);
  const ProbeSegment inner{whole.from + (probe.margin_a / length) * segment,
                           whole.to - (probe.margin_b / length) * segment};
  return exact.separates(exact.context, inner);
}

// D of the pair, at most: by the largest areas of its patches, or by theirs.
double largest_area(const MultiresQuery& query, const FrontNode& node) noexcept {
  const MultiresFront& front = query.frame.front.multires;
  const Resolution& r = query.resolution;
  const auto reading = static_cast<std::size_t>(r.reading);
  const double a = front.object_support.empty() ? 0.0 : front.object_support[idx(node.a)][reading];
  const double b = front.scene_support.empty() ? 0.0 : front.scene_support[idx(node.b)][reading];
  return r.area == SupportArea::larger ? std::max(a, b) : std::min(a, b);
}

// Places and metric of a pair, asked for as soon as its closest points are known.
struct RefinementDecision {
  const MultiresQuery& query;
  PairAtLevel pair;
  Urgency urgency{};

  // What is only split needs no contact of its own; with a budget it may have to do with it.
  bool needs_contact() const noexcept {
    const Resolution& r = query.resolution;
    if (r.budget_tests > 0 || r.budget_cpu > 0.0) return true;
    return is_blended(query) ? urgency.priority < 1.0 : !(urgency.priority > 1.0);
  }
};

bool decide(void* context, std::uint32_t feature_a, std::uint32_t feature_b, const Vec3& point_a,
            const Vec3& point_b) noexcept {
  auto& decision = *static_cast<RefinementDecision*>(context);
  PairAtLevel& pair = decision.pair;
  const RelativePose& x = decision.query.frame.pose;
  pair.point_a = point_a;
  pair.point_b = x.rotation.transpose() * (point_b - x.translation);
  pair.on_a = locate(pair.a.view, feature_a, pair.point_a);
  pair.on_b = locate(pair.b.view, feature_b, pair.point_b);
  decision.urgency = urgency_of(decision.query, pair);
  return decision.needs_contact();
}

// Harmonic mean of D over the area of a patch; 0 where it has no area, or a part without support.
double harmonic_support(const HullView& view, const std::array<double, 2>* support) noexcept {
  constexpr auto kFlood = static_cast<std::size_t>(SupportReading::flood);
  double area = 0.0, per_support = 0.0;
  for (int i = 0; i < view.triangle_count; ++i) {
    const auto& corner = view.triangles[i].corner;
    const Vec3& p = view.vertices[corner[0]];
    const double share = (view.vertices[corner[1]] - p).cross(view.vertices[corner[2]] - p).norm();
    const double mean =
        (support[corner[0]][kFlood] + support[corner[1]][kFlood] + support[corner[2]][kFlood]) /
        3.0;
    if (!(share > 0.0)) continue;
    area += share;
    per_support += share / mean;
  }
  return area > 0.0 ? area / per_support : 0.0;
}

}  // namespace

MultiresQuery make_multires_query(QueryFrame& frame) noexcept {
  const Resolution& resolution = frame.query.resolution;
  const RefinementMetric& metric = resolution.metric;
  const ContactFront& front = frame.front;
  const double smaller = std::min(frame.object.radius, frame.scene.radius);
  MultiresQuery query{
      frame,
      resolution,
      {&frame.object, &frame.scene, frame.pose, front.object_closed, front.scene_closed},
      front.last};
  query.is_haptic_alone = !(metric.velocity > 0.0) && !(metric.view.pixels > 0.0);
  query.is_of_pair = query.is_haptic_alone && resolution.reading == SupportReading::patch;
  query.threshold = std::max(metric.haptic, 0.0) * smaller;
  query.deviation_cap = resolution.deviation_cap * smaller;
  query.now = static_cast<float>(front.travel * (1.0 + 1e-6));
  return query;
}

std::vector<std::array<double, kSupportReadings>> support_of_nodes(const ClodHierarchy& hierarchy) {
  std::vector<std::array<double, kSupportReadings>> of_nodes;
  if (hierarchy.support.empty()) return of_nodes;
  of_nodes.assign(hierarchy.nodes.size(), {});
  for (std::size_t i = 0; i < hierarchy.nodes.size(); ++i) {
    if (is_free(hierarchy.nodes[i])) continue;
    const HullView view = level_surface(hierarchy, static_cast<std::int32_t>(i));
    const std::array<double, 2>* support =
        hierarchy.support.data() + (view.vertices - hierarchy.vertices.data());
    for (int v = 0; v < view.vertex_count; ++v) {
      for (std::size_t k = 0; k < 2; ++k) of_nodes[i][k] = std::max(of_nodes[i][k], support[v][k]);
    }
    of_nodes[i][static_cast<std::size_t>(SupportReading::patch)] = harmonic_support(view, support);
  }
  return of_nodes;
}

bool is_always_refined(const MultiresQuery& query, const FrontNode& node) noexcept {
  const ClodNode& na = node_a(query.frame, node.a);
  const ClodNode& nb = node_b(query.frame, node.b);
  if (is_free(na) || is_free(nb)) return true;
  if (std::max(na.level, nb.level) > query.resolution.coarsest_level) return true;
  const double sa =
      na.contact >= 0 ? query.frame.object.level_patches[idx(na.contact)].deviation : 0.0;
  const double sb =
      nb.contact >= 0 ? query.frame.scene.level_patches[idx(nb.contact)].deviation : 0.0;
  if (sa + sb > query.deviation_cap) return true;
  if (!query.is_haptic_alone) return false;
  const double area = largest_area(query, node);
  const SupportArea either = SupportArea::larger;
  return weighted_deviation({sa, query.frame.object.levels[idx(na.level)].resolution, area, false},
                            {sb, query.frame.scene.levels[idx(nb.level)].resolution, area, false},
                            either) > query.threshold;
}

LevelPair measure_level_pair(MultiresQuery& query, FrontNode& node, std::int32_t i) noexcept {
  QueryFrame& frame = query.frame;
  ++frame.set.stats.tests;
  RefinementDecision decision{
      query, {patch_at_level(frame.object, node.a), patch_at_level(frame.scene, node.b)}};
  const PatchAtLevel &a = decision.pair.a, &b = decision.pair.b;
  LevelPair out;
  out.reach = frame.query.tolerance + a.reach() + b.reach();
  const LevelProbe probe{&query.crossing, a.deviation(), b.deviation()};
  out.pair = measure_patches({.a = a.view,
                              .b = b.view,
                              .a_from_b = frame.pose,
                              .tolerance = out.reach,
                              .keeps_direction = frame.query.keep_directions,
                              .probe = {&separates, &probe},
                              .early = {&decide, &decision}},
                             node, frame.set.stats);
  const PatchPair& pair = out.pair;
  if (pair.status == PairContactStatus::apart) return out;
  out.priority = decision.urgency.priority;
  out.decided_by = decision.urgency.by;
  if (!decision.needs_contact()) return out;
  const bool is_apart =
      pair.status == PairContactStatus::separated || pair.status == PairContactStatus::grazing;
  if (is_apart)
    bound_separated(query, decision.pair, node, i, out);
  else
    bound_penetrating(query, decision.pair, node, out);
  // Depth of a pair that is turning from grazing to through (see pair_contact) is neither the one
  // nor the other.
  const double limit = a.deviation() + b.deviation() + a.hausdorff() + b.hausdorff();
  if (out.bound > limit * (1.0 + 1e-9)) out.priority = kInfinity;
  return out;
}

}  // namespace thigma::detail
