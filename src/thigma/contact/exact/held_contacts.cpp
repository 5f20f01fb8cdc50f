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

// Of the distance that is known, times the size of the bodies and the tolerance: what measuring in
// another way may find instead, for which vertices count as of a plane a hair of the size off it.
constexpr double kMargin = 3e-8;

double margin_of(const QueryFrame& frame) noexcept {
  constexpr double kRounding = 1e-13;  // of coordinates
  return kMargin * (frame.query.tolerance + frame.object.radius + frame.scene.radius) +
         kRounding * (frame.object.center.lpNorm<1>() + frame.scene.center.lpNorm<1>() +
                      frame.pose.translation.lpNorm<1>());
}

double distance_of(const Contact& contact) noexcept { return -contact.depth; }

// Of the two points that were nearest.
double farthest(const QueryFrame& frame, const CarriedContact& known) noexcept {
  return (frame.pose.rotation * known.on_b + frame.pose.translation - known.on_a).norm();
}

// As far as what was found of them last time says.
bool is_known_certain(const QueryFrame& frame, std::int32_t i, double& least) noexcept {
  const ContactFront& front = frame.front;
  if (!has_carried(front.carried, i)) return false;
  const CarriedContact& known = carried_of(front.carried, i);
  if (!known.is_of_hulls) return false;
  const double moved = front.travel - known.travel, margin = frame.margin;
  const double apart = kNear * (frame.object.radius + frame.scene.radius);
  least = known.nearest - moved - margin;
  if (least > std::max(front.carried.nearest, apart) &&
      known.nearest + moved + margin <= frame.query.tolerance)
    return true;
  const FrontNode& node = front.nodes[i];
  const HullView a = bare_hull(frame.object, node_a(frame, node.a));
  const HullView b = bare_hull(frame.scene, node_b(frame, node.b));
  const PlacedHulls hulls = place(a, b, frame.pose);
  float axis[3];
  for (int k = 0; k < 3; ++k) axis[k] = static_cast<float>(known.normal[k]);
  least = axis_gap(hulls, frame.pose, axis) - margin;
  return least > kNear * (a.radius + b.radius) &&
         farthest(frame, known) + margin <= frame.query.tolerance;
}

// Of the contacts that are not held.
double nearest_of_others(const QueryFrame& frame) noexcept {
  const std::vector<HeldPair>& held = frame.front.carried.held;
  const std::vector<Contact>& contacts = frame.set.contacts;
  double nearest = kInfinity;
  std::size_t next = 0;
  for (std::size_t k = frame.first; k < contacts.size(); ++k) {
    if (next < held.size() && held[next].contact == k)
      ++next;
    else
      nearest = std::min(nearest, distance_of(contacts[k]));
  }
  return nearest;
}

// No held pair that is farther is the nearest of all.
double nearest_at_most(const QueryFrame& frame, double of_others) noexcept {
  const CarriedContacts& carried = frame.front.carried;
  double most = of_others;
  for (const HeldPair& pair : carried.held)
    if (pair.least < most)
      most = std::min(most, farthest(frame, carried_of(carried, pair.node)) + frame.margin);
  return most;
}

void fill(QueryFrame& frame, const HeldPair& held, double nearest) noexcept {
  MeasuredContact moved;
  move_contact(frame, carried_of(frame.front.carried, held.node), moved);
  PatchPair& pair = moved.pair;
  const double least = std::max(held.least, nearest);
  const double most = std::max(least, frame.query.tolerance);
  const double known = std::clamp(-pair.depth, least, most);
  const Vec3 middle = 0.5 * (pair.witness_a + pair.witness_b);
  pair.depth = -known;
  pair.witness_a = middle - 0.5 * known * pair.normal;
  pair.witness_b = middle + 0.5 * known * pair.normal;
  Contact& contact = frame.set.contacts[held.contact];
  contact = make_contact(frame, frame.front.nodes[held.node], pair);
  contact.bound = std::min(moved.bound, most - least + frame.margin);
}

// Measures a held pair for its contact in the set. One that measuring finds no contact of, by
// rounding, stays as it was.
void measure_held(QueryFrame& frame, const HeldPair& held, const SegmentProbe& probe,
                  double nearest) noexcept {
  FrontNode& node = frame.front.nodes[held.node];
  const PatchPair pair = measure_leaf_pair(frame, node, probe);
  if (pair.status == PairContactStatus::apart)
    return fill(frame, held, std::min(nearest, frame.query.tolerance));
  keep_contact(frame, held.node, hull_view(frame.object, node.a), hull_view(frame.scene, node.b),
               {.pair = pair, .nearest = -pair.depth});
  frame.set.contacts[held.contact] = make_contact(frame, node, pair);
}

}  // namespace

bool may_hold(const QueryFrame& frame) noexcept {
  const ContactQuery& query = frame.query;
  return query.holds_near && query.measures_hulls && !query.keep_directions &&
         query.resolution.is_exact;
}

bool begin_holding(QueryFrame& frame) noexcept {
  // Of the way that contacts are carried: measured once, they are carried for some frames.
  constexpr double kSlow = 0.25;
  frame.front.carried.held.clear();
  frame.margin = margin_of(frame);
  const bool is_slow =
      frame.front.last_step < kSlow * frame.query.resolution.carry * frame.query.tolerance;
  const ExactFront& lists = frame.front.exact;
  const std::size_t room = frame.set.contacts.capacity() - frame.set.contacts.size();
  // What is below saturated nodes is not known.
  return !is_slow && lists.saturated.empty() && room >= lists.active.size() + lists.incoming.size();
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

bool is_certain(QueryFrame& frame, std::int32_t i, double& least) noexcept {
  if (is_known_certain(frame, i, least)) return true;
  const CarriedContacts& carried = frame.front.carried;
  if (!has_carried(carried, i) && carried.free.empty()) return false;
  FrontNode& node = frame.front.nodes[i];
  ++frame.set.stats.tests;
  ++frame.set.stats.pair_queries;
  const HullView a = hull_view(frame.object, node.a), b = hull_view(frame.scene, node.b);
  const Separation hulls = closest_points(a, b, frame.pose, kInfinity, node.gjk);
  if (hulls.status != GjkStatus::separated) return false;
  keep_hulls(frame, i, hulls);
  return is_known_certain(frame, i, least);
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
  double nearest = nearest_of_others(frame);
  const double most = nearest_at_most(frame, nearest);
  const auto first_far =
      std::partition(held.begin(), held.end(), [&](const HeldPair& h) { return h.least <= most; });
  std::sort(held.begin(), first_far, [](const HeldPair& x, const HeldPair& y) {
    return x.least != y.least ? x.least < y.least : x.contact < y.contact;
  });
  auto next = held.begin();
  for (; next != first_far && next->least <= nearest; ++next) {
    measure_held(frame, *next, probe, nearest);
    nearest = std::min(nearest, distance_of(frame.set.contacts[next->contact]));
  }
  for (; next != held.end(); ++next) fill(frame, *next, nearest);
  frame.front.carried.nearest = nearest;
}

}  // namespace thigma::detail
