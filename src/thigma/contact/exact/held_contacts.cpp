#include "thigma/contact/exact/held_contacts.h"

#include <algorithm>

#include "thigma/contact/detail/carry_contacts.h"
#include "thigma/contact/detail/support_sets.h"
#include "thigma/core/index.h"

// Rows are made of features, and ask contacts which patches are near and how near the nearest are.
// Two hulls are no farther from each other than the two points that were nearest last time, where
// they are now, and no nearer than their gap along the normal of that time. As long as the gap is
// above 0, so that they are still apart, and the points are within the tolerance, nothing else has
// to be known of them: the set of pairs is the one that measuring all would give. A travel m, after
// which D is within D - m and D + m, says the same of a slow pair in fewer operations.

namespace thigma::detail {
namespace {

// Of the distance that is known, times the size of the pair and the tolerance: rounding, and that
// of measuring in another way than last time.
constexpr double kMargin = 1e-9;

double margin_of(const QueryFrame& frame) noexcept {
  return kMargin * (frame.query.tolerance + frame.object.radius + frame.scene.radius);
}

double distance_of(const Contact& contact) noexcept { return -contact.depth; }

// Of the two points that were nearest.
double farthest(const QueryFrame& frame, const CarriedContact& known) noexcept {
  return (frame.pose.rotation * known.on_b + frame.pose.translation - known.on_a).norm();
}

// As far as what was found of it last time says.
Nearness known_nearness(const QueryFrame& frame, std::int32_t i, double& least) noexcept {
  const ContactFront& front = frame.front;
  if (!has_carried(front.carried, i)) return Nearness::unknown;
  const CarriedContact& known = carried_of(front.carried, i);
  if (!known.is_of_hulls) return Nearness::unknown;
  const double moved = front.travel - known.travel, margin = margin_of(frame);
  least = known.nearest - moved - margin;
  if (least > frame.query.tolerance) return Nearness::beyond;
  if (least > std::max(front.carried.nearest, 0.0) &&
      known.nearest + moved + margin <= frame.query.tolerance)
    return Nearness::within;
  const FrontNode& node = front.nodes[i];
  const HullView a = bare_hull(frame.object, node_a(frame, node.a));
  const HullView b = bare_hull(frame.scene, node_b(frame, node.b));
  const PlacedHulls hulls = place(a, b, frame.pose);
  float axis[3];
  for (int k = 0; k < 3; ++k) axis[k] = static_cast<float>(known.normal[k]);
  least = axis_gap(hulls, frame.pose, axis) - margin;
  if (!(least > 0.0)) return Nearness::unknown;
  if (least > frame.query.tolerance) return Nearness::beyond;
  return farthest(frame, known) + margin <= frame.query.tolerance ? Nearness::within
                                                                  : Nearness::unknown;
}

// No pair is farther than this that is nearest.
double nearest_at_most(const QueryFrame& frame) noexcept {
  double most = kInfinity;
  const ContactFront& front = frame.front;
  std::size_t next = 0;
  const std::vector<HeldPair>& held = front.carried.held;
  for (std::size_t k = frame.first; k < frame.set.contacts.size(); ++k) {
    if (next < held.size() && held[next].contact == k) {
      const HeldPair& pair = held[next++];
      if (pair.least < most)
        most = std::min(most, farthest(frame, carried_of(front.carried, pair.node)));
    } else {
      most = std::min(most, distance_of(frame.set.contacts[k]));
    }
  }
  return most;
}

// Measures a held pair for its contact in the set.
void measure_held(QueryFrame& frame, const HeldPair& held, const SegmentProbe& probe) noexcept {
  FrontNode& node = frame.front.nodes[held.node];
  PatchPair pair = measure_leaf_pair(frame, node, probe);
  keep_contact(frame, held.node, hull_view(frame.object, node.a), hull_view(frame.scene, node.b),
               {.pair = pair, .nearest = -pair.depth});
  if (pair.status == PairContactStatus::apart) pair.depth = -frame.query.tolerance;  // by rounding
  frame.set.contacts[held.contact] = make_contact(frame, node, pair);
}

void fill(QueryFrame& frame, const HeldPair& held, double nearest) noexcept {
  MeasuredContact moved;
  move_contact(frame, carried_of(frame.front.carried, held.node), moved);
  PatchPair& pair = moved.pair;
  const double known = std::clamp(-pair.depth, std::max(held.least, nearest),
                                  std::max(nearest, frame.query.tolerance));
  const Vec3 middle = 0.5 * (pair.witness_a + pair.witness_b);
  pair.depth = -known;
  pair.witness_a = middle - 0.5 * known * pair.normal;
  pair.witness_b = middle + 0.5 * known * pair.normal;
  Contact& contact = frame.set.contacts[held.contact];
  contact = make_contact(frame, frame.front.nodes[held.node], pair);
  contact.bound = moved.bound;
}

}  // namespace

bool may_hold(const QueryFrame& frame) noexcept {
  const ContactQuery& query = frame.query;
  return query.holds_near && query.measures_hulls && query.resolution.is_exact;
}

bool begin_holding(QueryFrame& frame, std::size_t leaves) noexcept {
  // Of the way that contacts are carried: measured once, they are carried for some frames.
  constexpr double kSlow = 0.25;
  frame.front.carried.held.clear();
  const bool is_slow =
      frame.front.last_step < kSlow * frame.query.resolution.carry * frame.query.tolerance;
  return !is_slow && frame.set.contacts.capacity() - frame.set.contacts.size() >= leaves;
}

void keep_hulls(QueryFrame& frame, std::int32_t i, const Separation& hulls) noexcept {
  const FrontNode& node = frame.front.nodes[i];
  const HullView a = hull_view(frame.object, node.a), b = hull_view(frame.scene, node.b);
  if (hulls.status != GjkStatus::separated || !(hulls.distance > kNear * (a.radius + b.radius)))
    return;
  PatchPair pair;
  pair.status = PairContactStatus::separated;
  pair.depth = -hulls.distance;
  pair.separation = hulls.distance;
  pair.normal = (hulls.witness_b - hulls.witness_a) / hulls.distance;
  pair.witness_a = hulls.witness_a;
  pair.witness_b = hulls.witness_b;
  pair.is_of_hulls = true;
  keep_contact(frame, i, a, b, {.pair = pair, .nearest = hulls.distance, .is_of_search = true});
}

Nearness nearness_of(QueryFrame& frame, std::int32_t i, double& least) noexcept {
  const Nearness known = known_nearness(frame, i, least);
  if (known != Nearness::unknown) return known;
  FrontNode& node = frame.front.nodes[i];
  ++frame.set.stats.tests;
  ++frame.set.stats.pair_queries;
  const HullView a = hull_view(frame.object, node.a), b = hull_view(frame.scene, node.b);
  const Separation hulls = closest_points(a, b, frame.pose, kInfinity, node.gjk);
  if (hulls.status != GjkStatus::separated) return Nearness::unknown;
  keep_hulls(frame, i, hulls);
  return known_nearness(frame, i, least);
}

bool hold_pair(QueryFrame& frame, std::int32_t i, double least) noexcept {
  std::vector<HeldPair>& held = frame.front.carried.held;
  if (held.size() == held.capacity()) return false;
  held.push_back({least, i, frame.set.contacts.size()});
  frame.set.contacts.emplace_back();
  return true;
}

void fill_held(QueryFrame& frame, const SegmentProbe& probe) noexcept {
  std::vector<HeldPair>& held = frame.front.carried.held;
  double nearest = nearest_at_most(frame);
  const auto first_far = std::partition(held.begin(), held.end(),
                                        [&](const HeldPair& h) { return h.least <= nearest; });
  std::sort(held.begin(), first_far, [](const HeldPair& x, const HeldPair& y) {
    return x.least != y.least ? x.least < y.least : x.contact < y.contact;
  });
  auto next = held.begin();
  for (; next != first_far && next->least <= nearest; ++next) {
    measure_held(frame, *next, probe);
    nearest = std::min(nearest, distance_of(frame.set.contacts[next->contact]));
  }
  for (; next != held.end(); ++next) fill(frame, *next, nearest);
  frame.front.carried.nearest = nearest;
}

}  // namespace thigma::detail
