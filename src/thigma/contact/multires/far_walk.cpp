#include "thigma/contact/multires/far_walk.h"

#include <algorithm>

#include "thigma/contact/detail/support_sets.h"
#include "thigma/contact/multires/pair_walk.h"
#include "thigma/contact/multires/patch_at_level.h"

// Coarse surfaces may be through each other where the finest are far apart, and measuring how much
// is dear. So a coarse pair is judged by the hulls of its nodes alone: all that is below is within
// h of them. Along the axis between their closest points they are as far apart as they are at all,
// and a turn of the object about its middle makes no more of that than the turn times the radius.

namespace thigma::detail {
namespace {

// Of distances of hulls, times the size of the pair.
constexpr double kRounding = 1e-10;

// What the hulls of a pair have to be apart to stay coarse, and to be no contact.
struct FarLimits {
  double coarse = 0.0, apart = 0.0;  // [m]
};

FarLimits limits_of(const MultiresQuery& query, const FrontNode& node) noexcept {
  const ClodNode& a = node_a(query.frame, node.a);
  const double out_of_hull = a.hausdorff + node_b(query.frame, node.b).hausdorff;
  const Resolution& r = query.resolution;
  return {out_of_hull + r.exact_within + r.turn * (a.radius + a.hausdorff),
          out_of_hull + query.frame.query.tolerance};
}

// Closest points of the hulls where they are far enough apart to stay coarse; distance 0 where not.
// Bits do not depend on what is remembered. i: as of is_known_near; the timer is wound again.
SupportedDistance closest_hulls(QueryFrame& frame, FrontNode& node, std::int32_t i,
                                const FarLimits& limits) noexcept {
  const HullView a = hull_view(frame.object, node.a), b = hull_view(frame.scene, node.b);
  const Placement place(a, b, frame.pose);
  SupportedDistance found;
  ++frame.set.stats.pair_queries;
  Separation s = closest_points(a, b, frame.pose, kInfinity, node.gjk);
  if (s.status == GjkStatus::gave_up) return found;
  const double distance = s.status == GjkStatus::separated ? s.distance : 0.0;
  const double rounding = kRounding * place.size;
  if (i >= 0 && distance + rounding < limits.apart)
    set_timer(frame.front, i, limits.apart - distance - rounding);
  if (distance <= limits.coarse - rounding) return found;
  const SupportSets sets = support_sets(place, s.witness_a - a.center, s.witness_b - a.center);
  if (!closest_by_support(place, sets, Features::any, found)) {
    GjkCache fresh;
    ++frame.set.stats.pair_queries;
    s = closest_points(a, b, frame.pose, kInfinity, fresh);
    if (s.status != GjkStatus::separated) return {};
    found = {s.distance, s.witness_a - a.center, s.witness_b - a.center,
             (s.witness_b - s.witness_a) / s.distance};
  }
  return found.distance > limits.coarse + rounding ? found : SupportedDistance{};
}

// How far the finest triangles below a node may be from a point of its hull, at most.
double surface_near(const PatchAtLevel& patch, const HullView& hull, const Vec3& point) noexcept {
  double least = kInfinity;
  for (int i = 0; i < hull.vertex_count; ++i)
    least = std::min(least, (hull.vertices[i] - point).squaredNorm());
  return std::sqrt(least) + (patch.is_culling_hull() ? 0.0 : patch.level_patch->to_below);
}

Contact far_contact(const MultiresQuery& query, const FrontNode& node,
                    const SupportedDistance& found) noexcept {
  const QueryFrame& frame = query.frame;
  const HullView a = hull_view(frame.object, node.a), b = hull_view(frame.scene, node.b);
  LevelPair level;
  level.pair.status = PairContactStatus::separated;
  level.pair.depth = -found.distance;
  level.pair.normal = found.normal;
  level.pair.witness_a = found.p + a.center;
  level.pair.witness_b = found.q + a.center;
  const RelativePose& x = frame.pose;
  const Vec3 on_b = x.rotation.transpose() * (level.pair.witness_b - x.translation);
  const double out_of_hull = node_a(frame, node.a).hausdorff + node_b(frame, node.b).hausdorff;
  level.bound = std::max(
      out_of_hull, surface_near(patch_at_level(frame.object, node.a), a, level.pair.witness_a) +
                       surface_near(patch_at_level(frame.scene, node.b), b, on_b));
  level.bound += kRounding * (a.radius + b.radius + found.distance);
  level.decided_by = LevelDecision::haptic;
  return level_contact(query, node, level, 1.0);
}

// Whether an open pair, place i of the front, is known to be too near to stay coarse: its hulls are
// no farther apart than what is left of its timer says.
bool is_known_near(const MultiresQuery& query, const FarLimits& limits, std::int32_t i) noexcept {
  if (i < 0) return false;
  const ContactFront& front = query.frame.front;
  const double left = static_cast<double>(front.expires[i]) - front.travel;
  return limits.apart - left <= limits.coarse;
}

void visit_far(MultiresQuery& query, const PendingPair& entry) noexcept {
  QueryFrame& frame = query.frame;
  const std::int32_t i = entry.node;
  FrontNode none;
  FrontNode& node = node_of(frame.front, entry, none);
  PatchPair finest;
  const Found found = classify_pair(query, node, i, finest);
  if (found == Found::nothing) return;
  if (found == Found::finest)
    return report(frame, level_contact(query, node, {.pair = finest}, 1.0));
  if (is_always_refined(query, node)) return push_children(query, node, i, 1.0);
  const FarLimits limits = limits_of(query, node);
  if (is_known_near(query, limits, i)) return push_children(query, node, i, 1.0);
  ++frame.set.stats.tests;
  const SupportedDistance hulls = closest_hulls(frame, node, i, limits);
  if (!(hulls.distance > 0.0)) return push_children(query, node, i, 1.0);
  if (hulls.distance > limits.apart)
    return end_apart(query, node, i, hulls.distance - limits.apart);
  report(frame, far_contact(query, node, hulls));
  if (i >= 0) drop_children(frame.front, i);
}

/// How many contacts there may be. With more, the walk begins again with a smaller tolerance: an
/// object that comes fast has looked no farther than what was free before, and there may be
/// anything.
class FarLimit {
 public:
  explicit FarLimit(const MultiresQuery& query) noexcept
      : dropped_(query.frame.set.dropped),
        front_(query.frame.set.stats.front),
        most_(static_cast<std::int64_t>(query.frame.query.most_pairs)) {}

  bool is_over(const QueryFrame& frame) const noexcept {
    const auto held = static_cast<std::int64_t>(frame.set.contacts.size() - frame.first);
    return held + (frame.set.dropped - dropped_) > most_ && may_halve(frame.query, halvings_);
  }

  /// At least a half. As few pairs as were seen yet may all be where surfaces are nearest, so that
  /// no more than a quarter of the limit is to be left of them.
  void start_again(QueryFrame& frame) noexcept {
    std::vector<Contact>& all = frame.set.contacts;
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(frame.first);
    std::int64_t within = 0;
    ContactQuery& asked = frame.query;
    do {
      asked.tolerance *= 0.5;
      ++halvings_;
      within = std::count_if(begin, all.end(),
                             [&](const Contact& c) { return -c.depth <= asked.tolerance; });
    } while (4 * within > most_ && is_over(frame));
    asked.resolution.exact_within = std::min(asked.resolution.exact_within, 0.5 * asked.tolerance);
    all.erase(begin, all.end());
    frame.set.dropped = dropped_;
    frame.set.stats.front = front_;
    frame.is_full = false;
    ContactFront& front = frame.front;
    retarget(front, asked.tolerance);
    front.multires.unremembered = kInfinity;
    front.multires.pending.clear();
    front.multires.pending.push_back({.node = 0});
  }

 private:
  std::int64_t dropped_, front_;  // before this query
  std::int64_t most_;
  int halvings_ = 0;
};

}  // namespace

void walk_far(MultiresQuery& query) noexcept {
  FarLimit limit(query);
  walk(query, [&](MultiresQuery& of, const PendingPair& entry) {
    visit_far(of, entry);
    if (limit.is_over(of.frame)) limit.start_again(of.frame);
  });
}

}  // namespace thigma::detail
