#include "thigma/contact/detail/level_query.h"

#include <algorithm>
#include <numeric>

#include "thigma/contact/detail/level_measure.h"
#include "thigma/core/cpu_clock.h"

// Sec. 3.4.2. The tree of pairs is walked from the root each frame. Where a pair was culled, or proved open, the walk
// goes by that until the bodies may have moved far enough to change it, so it costs a look at one number; what is
// measured each frame are the pairs near a contact, from nothing but the pose. Every decision is thus a function of the
// pose alone, and a walk that remembers ends where a fresh one does.
//
// A pair is split by a rule that sees the pair alone (free nodes first, then the node with the coarser children), so
// each pair of patches is reached in one way.

namespace thigma::detail {
namespace {

constexpr double kBlendFrom = 0.5;  // of s* / s0: below, a pair speaks for itself; from 1 on, its children do

double child_resolution(const ClodHierarchy& h, const ClodNode& node) noexcept {
  return h.levels[static_cast<std::size_t>(node.level - 1)].resolution;
}

// Free nodes first, of two the larger; then the node whose children are coarser.
bool splits_object(const Traversal& t, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode& na = node_a(t, a);
  const ClodNode& nb = node_b(t, b);
  if (na.child_count == 0) return false;
  if (nb.child_count == 0) return true;
  const bool free_a = is_free(na), free_b = is_free(nb);
  if (free_a != free_b) return free_a;
  const bool is_larger = na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
  if (free_a) return is_larger;
  const double ra = child_resolution(t.object, na), rb = child_resolution(t.scene, nb);
  return ra != rb ? ra < rb : is_larger;
}

// Shares of a pair and of its children in the contact (Sec. 3.4.4; the weight is this project's).
struct Blend {
  double own = 1.0, below = 0.0;
};

Blend blend(const LevelQuery& q, double priority) noexcept {
  if (!q.t.query.resolution.interpolates) return priority > 1.0 ? Blend{0.0, 1.0} : Blend{1.0, 0.0};
  const double x = std::min(std::max((priority - kBlendFrom) / (1.0 - kBlendFrom), 0.0), 1.0);
  const double below = x * x * (3.0 - 2.0 * x);
  return {1.0 - below, below};
}

// ---- nodes ------------------------------------------------------------------------------------------------------

bool is_due(const LevelQuery& q, std::int32_t i) noexcept { return q.t.front.expires[i] <= q.now; }

void drop_children(ContactFront& f, std::int32_t i) noexcept {
  if (f.nodes[i].first_child < 0) return;
  const std::size_t base = f.work.size();
  f.work.push_back(i);
  while (f.work.size() > base) {
    const std::int32_t k = f.work.back();
    f.work.pop_back();
    for (std::int32_t c = f.nodes[k].first_child; c >= 0;) {
      const std::int32_t next = f.nodes[c].next_sibling;
      if (f.nodes[c].first_child >= 0) f.work.push_back(c);  // its links outlive its place in the list
      else free_node(f, c);
      c = next;
    }
    f.nodes[k].first_child = -1;
    --f.split;
    if (k != i) free_node(f, k);
  }
}

void end_apart(LevelQuery& q, FrontNode& n, std::int32_t i, double slack) noexcept {
  if (i < 0) return;
  drop_children(q.t.front, i);
  n.decision = FrontNode::Decision::apart;
  set_timer(q.t.front, i, slack);
}

// Whether a pair that is not both finest has to be looked at: the culling test, when its last answer may be outdated.
bool is_open(LevelQuery& q, FrontNode& n, std::int32_t i) noexcept {
  if (i >= 0 && n.decision == FrontNode::Decision::open && !is_due(q, i)) return true;
  const double slack = slack_of(q.t, n);
  if (slack > 0.0) {
    end_apart(q, n, i, slack);
    return false;
  }
  if (i >= 0) {
    n.decision = FrontNode::Decision::open;
    set_timer(q.t.front, i, -slack);
  }
  return true;
}

PatchPair measure_finest(LevelQuery& q, FrontNode& n, std::int32_t i) noexcept {
  Traversal& t = q.t;
  ++t.set.stats.tests;
  const SegmentProbe probe = crossing_probe(q.crossing);
  const PatchPair pair = measure_patches(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose, t.query.tolerance,
                                         t.query.keep_directions, probe, n, t.set.stats);
  n.decision = FrontNode::Decision::unknown;
  if (pair.status == PairContactStatus::apart) end_apart(q, n, i, -pair.depth - t.query.tolerance);
  return pair;
}

// Adds the children of a pair to the stack; without memory where the front has no room for them.
void push_children(LevelQuery& q, FrontNode& n, std::int32_t i, double weight) noexcept {
  Traversal& t = q.t;
  ContactFront& f = t.front;
  const bool of_a = splits_object(t, n.a, n.b);
  if (i >= 0 && (n.first_child >= 0 || split(t, i, of_a))) {
    for (std::int32_t c = n.first_child; c >= 0; c = f.nodes[c].next_sibling) {
      f.pending.push_back({.weight = weight, .node = c});
    }
    return;
  }
  const ClodNode& parent = of_a ? node_a(t, n.a) : node_b(t, n.b);
  for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
    f.pending.push_back({.weight = weight, .a = of_a ? c : n.a, .b = of_a ? n.b : c});
  }
}

Contact level_contact(const LevelQuery& q, const FrontNode& n, const LevelPair& m, double weight) noexcept {
  Contact c = make_contact(q.t, n, m.pair);
  c.bound = m.bound;
  c.weight = weight;
  return c;
}

// ---- without a budget -------------------------------------------------------------------------------------------

void visit(LevelQuery& q, const PendingPair& entry) noexcept {
  Traversal& t = q.t;
  ContactFront& f = t.front;
  const std::int32_t i = entry.node;
  FrontNode none;
  none.a = entry.a;
  none.b = entry.b;
  FrontNode& n = i >= 0 ? f.nodes[i] : none;
  ++t.set.stats.front;  // taken back where the walk goes on below
  if (i >= 0 && n.decision == FrontNode::Decision::apart && !is_due(q, i)) return;
  if (is_leaf_pair(t, n.a, n.b)) {
    const PatchPair pair = measure_finest(q, n, i);
    if (pair.status == PairContactStatus::apart) return;
    report(t, level_contact(q, n, {.pair = pair}, entry.weight));
    return;
  }
  if (!is_open(q, n, i)) return;
  double below = entry.weight;
  if (!is_always_refined(q, n)) {
    const LevelPair m = measure_level_pair(q, n, i);
    if (m.pair.status == PairContactStatus::apart) return end_apart(q, n, i, -m.pair.depth - m.reach);
    const Blend share = blend(q, m.priority);
    if (share.own > 0.0 && m.nearest <= t.query.tolerance) {
      report(t, level_contact(q, n, m, entry.weight * share.own));
    }
    if (!(share.below > 0.0)) {
      if (i >= 0) drop_children(f, i);
      return;
    }
    below *= share.below;
  }
  --t.set.stats.front;
  push_children(q, n, i, below);
}

void walk(LevelQuery& q) noexcept {
  std::vector<PendingPair>& stack = q.t.front.pending;
  while (!stack.empty()) {
    const PendingPair entry = stack.back();
    stack.pop_back();
    visit(q, entry);
  }
}

// ---- within a budget --------------------------------------------------------------------------------------------

struct Budget {
  std::int64_t first = 0;      // tests of the set before this query
  std::int64_t tests = 0;      // at most; 0: no limit
  double deadline = 0.0;       // of the thread's CPU clock; 0: none [s]
  int until_clock = 0;         // refinements until the clock is looked at again
  bool is_spent = false;
};

bool is_less_urgent(const PendingPair& x, const PendingPair& y) noexcept {
  if (x.priority != y.priority) return x.priority < y.priority;
  return x.a != y.a ? x.a > y.a : x.b > y.b;
}

std::int32_t keep(LevelQuery& q, const FrontNode& n, const LevelPair& m, double weight) noexcept {
  std::vector<Contact>& found = q.t.front.found;
  if (found.size() == found.capacity()) return -1;
  found.push_back(level_contact(q, n, m, weight));
  return static_cast<std::int32_t>(found.size()) - 1;
}

// As visit, but whatever has a patch is measured, and what deserves refinement waits in the queue.
void visit_within(LevelQuery& q, const PendingPair& entry) noexcept {
  Traversal& t = q.t;
  ContactFront& f = t.front;
  const std::int32_t i = entry.node;
  FrontNode none;
  none.a = entry.a;
  none.b = entry.b;
  FrontNode& n = i >= 0 ? f.nodes[i] : none;
  ++t.set.stats.front;
  if (i >= 0 && n.decision == FrontNode::Decision::apart && !is_due(q, i)) return;
  if (is_leaf_pair(t, n.a, n.b)) {
    const PatchPair pair = measure_finest(q, n, i);
    if (pair.status != PairContactStatus::apart) keep(q, n, {.pair = pair}, entry.weight);
    return;
  }
  if (!is_open(q, n, i)) return;
  if (is_free(node_a(t, n.a)) || is_free(node_b(t, n.b))) {
    --t.set.stats.front;
    return push_children(q, n, i, entry.weight);
  }
  const LevelPair m = measure_level_pair(q, n, i);
  if (m.pair.status == PairContactStatus::apart) return end_apart(q, n, i, -m.pair.depth - m.reach);
  const std::int32_t contact = m.nearest <= t.query.tolerance ? keep(q, n, m, entry.weight) : -1;
  if (i >= 0 && blend(q, m.priority).below > 0.0) {
    f.queue.push_back({m.priority, entry.weight, i, n.a, n.b, contact});
    std::push_heap(f.queue.begin(), f.queue.end(), is_less_urgent);
  }
}

void walk_within(LevelQuery& q) noexcept {
  std::vector<PendingPair>& stack = q.t.front.pending;
  while (!stack.empty()) {
    const PendingPair entry = stack.back();
    stack.pop_back();
    visit_within(q, entry);
  }
}

// Tests that refining a pair may take, at most: two a child, none of one that is known to be apart.
std::int64_t most_tests(const LevelQuery& q, const FrontNode& n) noexcept {
  const Traversal& t = q.t;
  const bool of_a = splits_object(t, n.a, n.b);
  if (n.first_child < 0) return 2 * (of_a ? node_a(t, n.a) : node_b(t, n.b)).child_count;
  std::int64_t most = 0;
  for (std::int32_t c = n.first_child; c >= 0; c = t.front.nodes[c].next_sibling) {
    const FrontNode& child = t.front.nodes[c];
    if (child.decision == FrontNode::Decision::unknown || is_due(q, c)) {
      most += is_leaf_pair(t, child.a, child.b) ? 1 : 2;
    } else if (child.decision == FrontNode::Decision::open) {
      most += 1;
    }
  }
  return most;
}

bool has_room(LevelQuery& q, Budget& budget, const PendingPair& top) noexcept {
  Traversal& t = q.t;
  if (budget.tests > 0) {
    const std::int64_t spent = t.set.stats.tests - budget.first;
    if (spent + most_tests(q, t.front.nodes[top.node]) > budget.tests) return false;
  }
  if (budget.deadline > 0.0 && --budget.until_clock <= 0) {
    budget.until_clock = 4;
    const double finish = static_cast<double>(t.front.found.size()) * t.front.finish_cost;
    if (thread_cpu_seconds() + finish > budget.deadline) return false;
  }
  // Every child may add a contact.
  return t.front.found.capacity() - t.front.found.size() > 64;
}

void refine(LevelQuery& q, Budget& budget) noexcept {
  ContactFront& f = q.t.front;
  while (!f.queue.empty()) {
    const PendingPair top = f.queue.front();
    if (!has_room(q, budget, top)) {
      budget.is_spent = true;
      return;
    }
    std::pop_heap(f.queue.begin(), f.queue.end(), is_less_urgent);
    f.queue.pop_back();
    const Blend share = blend(q, top.priority);
    if (top.contact >= 0) f.found[static_cast<std::size_t>(top.contact)].weight *= share.own;
    --q.t.set.stats.front;
    push_children(q, f.nodes[top.node], top.node, top.weight * share.below);
    walk_within(q);
  }
}

void walk_within_budget(LevelQuery& q) noexcept {
  Traversal& t = q.t;
  ContactFront& f = t.front;
  const Resolution& r = t.query.resolution;
  Budget budget{.first = t.set.stats.tests, .tests = r.budget_tests};
  if (r.budget_cpu > 0.0) budget.deadline = thread_cpu_seconds() + r.budget_cpu;
  f.found.clear();
  f.queue.clear();
  walk_within(q);
  t.set.stats.mandatory_tests += t.set.stats.tests - budget.first;
  refine(q, budget);
  for (const PendingPair& left : f.queue) t.set.stats.unrefined += left.contact >= 0 && left.priority > 1.0;
  const double start = budget.deadline > 0.0 ? thread_cpu_seconds() : 0.0;
  for (const Contact& c : f.found) {
    if (c.weight > 0.0) report(t, c);
  }
  if (budget.deadline > 0.0 && !f.found.empty()) {
    f.finish_cost = 2.0 * (thread_cpu_seconds() - start) / static_cast<double>(f.found.size());
  }
}

// In the order of their patches. Contacts are large: places are sorted, then each contact moves once.
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
  if (r.budget_tests > 0 || r.budget_cpu > 0.0) walk_within_budget(q);
  else walk(q);
  f.last = t.pose;
  sort_contacts(t);
}

}  // namespace thigma::detail
