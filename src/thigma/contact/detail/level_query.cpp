#include "thigma/contact/detail/level_query.h"

#include <algorithm>
#include <numeric>

#include "thigma/contact/detail/level_budget.h"
#include "thigma/contact/detail/level_walk.h"

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

void visit(LevelQuery& q, const PendingPair& entry) noexcept {
  Traversal& t = q.t;
  const std::int32_t i = entry.node;
  FrontNode none;
  FrontNode& n = node_of(t.front, entry, none);
  PatchPair finest;
  const Found found = look_at(q, n, i, finest);
  if (found == Found::nothing) return;
  if (found == Found::finest) return report(t, level_contact(q, n, {.pair = finest}, entry.weight));
  if (is_always_refined(q, n)) return push_children(q, n, i, entry.weight);
  const LevelPair m = measure_level_pair(q, n, i);
  if (m.pair.status == PairContactStatus::apart) return end_apart(q, n, i, -m.pair.depth - m.reach);
  const Blend share = blend(q, m.priority);
  if (share.own > 0.0 && m.nearest <= t.query.tolerance)
    report(t, level_contact(q, n, m, entry.weight * share.own));
  if (share.below > 0.0) return push_children(q, n, i, entry.weight * share.below);
  if (i >= 0) drop_children(t.front, i);
}

// In the order of their patches. Contacts are large: places are sorted, then each contact moves
// once.
void sort_contacts(Traversal& t) noexcept {
  Contact* contacts = t.set.contacts.data() + t.first;
  const std::size_t count = t.set.contacts.size() - t.first;
  std::vector<std::int32_t>& order = t.front.order;
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

void query_levels(Traversal& t) noexcept {
  ContactFront& f = t.front;
  const FrontState state = advance_front(t, true);
  if (state == FrontState::no_memory) return;
  LevelQuery q = make_level_query(t);
  q.has_last = state == FrontState::kept;
  if (state == FrontState::empty) {
    take_node(f);
    f.nodes[0].a = f.nodes[0].b = 0;
  }
  f.pending.clear();
  f.work.clear();
  f.pending.push_back({.node = 0});
  const Resolution& r = t.query.resolution;
  if (r.budget_tests > 0 || r.budget_cpu > 0.0)
    walk_within_budget(q);
  else
    walk(q, visit);
  f.last = t.pose;
  sort_contacts(t);
}

}  // namespace thigma::detail
