#include "thigma/contact/multires/multires_query.h"

#include <algorithm>
#include <numeric>

#include "thigma/contact/detail/carry_contacts.h"
#include "thigma/contact/multires/budget.h"
#include "thigma/contact/multires/far_walk.h"
#include "thigma/contact/multires/pair_walk.h"

// Sec. 3.4.2. The tree of pairs is walked from the root each frame. Where a pair was culled, or
// proved open, the walk goes by that until the bodies may have moved far enough to change it, so it
// costs a look at one number; what is measured each frame are the pairs near a contact, from
// nothing but the pose. Every decision is thus a function of the pose alone, and a walk that
// remembers ends where a fresh one does.
//
// A pair is split by a rule that sees the pair alone (free nodes first, then the node with the
// coarser children), so each pair of patches is reached in one way.

namespace thigma::detail {
namespace {

LevelPair as_level(const MeasuredContact& contact) noexcept {
  LevelPair level;
  level.pair = contact.pair;
  level.bound = contact.bound;
  level.nearest = contact.nearest;
  level.decided_by = contact.decided_by;
  return level;
}

// Reports the contact that a pair carries; false: it has to be looked at.
bool report_carried(MultiresQuery& query, const FrontNode& node,
                    const PendingPair& entry) noexcept {
  QueryFrame& frame = query.frame;
  MeasuredContact carried;
  if (!carry_contact(frame, node, entry.node, carried)) return false;
  // Exact contacts are no farther than the tolerance.
  if (is_leaf_pair(frame, node.a, node.b) && -carried.pair.depth > frame.query.tolerance)
    return false;
  ++frame.set.stats.front;
  if (carried.nearest <= frame.query.tolerance)
    report(frame, level_contact(query, node, as_level(carried), entry.weight));
  return true;
}

void keep(MultiresQuery& query, const FrontNode& node, std::int32_t i,
          const LevelPair& level) noexcept {
  keep_contact(query.frame, i, level_surface(query.frame.object, node.a),
               level_surface(query.frame.scene, node.b),
               {level.pair, level.bound, level.nearest, level.decided_by});
}

void visit(MultiresQuery& query, const PendingPair& entry) noexcept {
  QueryFrame& frame = query.frame;
  const std::int32_t i = entry.node;
  FrontNode none;
  FrontNode& node = node_of(frame.front, entry, none);
  const bool is_carrying = query.is_carrying && i >= 0;
  if (is_carrying) {
    if (report_carried(query, node, entry)) return;
    drop_carried(frame.front.carried, i);
  }
  PatchPair finest;
  const Found found = classify_pair(query, node, i, finest);
  if (found == Found::nothing) return;
  if (found == Found::finest) {
    if (is_carrying) keep(query, node, i, {.pair = finest, .nearest = -finest.depth});
    return report(frame, level_contact(query, node, {.pair = finest}, entry.weight));
  }
  if (is_always_refined(query, node)) return push_children(query, node, i, entry.weight);
  const LevelPair measured = measure_level_pair(query, node, i);
  if (measured.pair.status == PairContactStatus::apart)
    return end_apart(query, node, i, -measured.pair.depth - measured.reach);
  const Blend share = blend(query, measured.priority);
  if (share.own > 0.0 && measured.nearest <= frame.query.tolerance)
    report(frame, level_contact(query, node, measured, entry.weight * share.own));
  if (share.below > 0.0) return push_children(query, node, i, entry.weight * share.below);
  if (i >= 0) drop_children(frame.front, i);
  if (is_carrying) keep(query, node, i, measured);
}

// In the order of their patches. Contacts are large: places are sorted, then each contact moves
// once.
void sort_contacts(QueryFrame& frame) noexcept {
  Contact* contacts = frame.set.contacts.data() + frame.first;
  const std::size_t count = frame.set.contacts.size() - frame.first;
  std::vector<std::int32_t>& order = frame.front.multires.order;
  if (count > order.capacity()) {
    std::sort(contacts, contacts + count, is_before);
    return;
  }
  order.resize(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t x, std::int32_t y) { return is_before(contacts[x], contacts[y]); });
  for (std::size_t i = 0; i < count; ++i) {
    if (order[i] == static_cast<std::int32_t>(i)) continue;
    const Contact first = contacts[i];
    std::size_t to = i;
    while (order[to] != static_cast<std::int32_t>(i)) {
      const auto from = static_cast<std::size_t>(order[to]);
      contacts[to] = contacts[from];
      order[to] = static_cast<std::int32_t>(to);
      to = from;
    }
    contacts[to] = first;
    order[to] = static_cast<std::int32_t>(to);
  }
}

}  // namespace

void query_multires(QueryFrame& frame) noexcept {
  ContactFront& front = frame.front;
  const FrontState state = advance_front(frame, true);
  if (state == FrontState::no_memory) return;
  // Where nothing has levels there is nothing to leave coarse.
  const bool has_levels = !frame.object.level_patches.empty() || !frame.scene.level_patches.empty();
  MultiresQuery query = make_multires_query(frame);
  query.has_last = state == FrontState::kept;
  query.is_carrying = is_carrying(frame);
  if (state == FrontState::empty) {
    take_node(front);
    front.nodes[0].a = front.nodes[0].b = 0;
  }
  front.multires.pending.clear();
  front.multires.unremembered = query.resolution.exact_within > 0.0 ? kInfinity : 0.0;
  front.work.clear();
  front.multires.pending.push_back({.node = 0});
  const Resolution& r = query.resolution;
  if (r.exact_within > 0.0)
    walk_far(query);
  else if (has_levels && (r.budget_tests > 0 || r.budget_cpu > 0.0))
    walk_within_budget(query);
  else
    walk(query, visit);
  front.last = frame.pose;
  sort_contacts(frame);
}

}  // namespace thigma::detail
