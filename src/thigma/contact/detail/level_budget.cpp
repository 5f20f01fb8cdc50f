#include "thigma/contact/detail/level_budget.h"

#include <algorithm>

#include "thigma/contact/detail/level_walk.h"
#include "thigma/core/cpu_clock.h"

namespace thigma::detail {
namespace {

constexpr double kForgets = 0.98;  // a query: the cost of the dearest refinement halves in 35

struct Budget {
  std::int64_t first = 0;  // tests of the set before this query
  std::int64_t tests = 0;  // at most; 0: no limit
  double deadline = 0.0;   // of the thread's CPU clock; 0: none [s]
  double now = 0.0;        // of that clock, when it was looked at last; 0: not yet [s]
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
  FrontNode& n = node_of(f, entry, none);
  PatchPair finest;
  const Found found = look_at(q, n, i, finest);
  if (found == Found::nothing) return;
  if (found == Found::finest) {
    keep(q, n, {.pair = finest}, entry.weight);
    return;
  }
  if (is_free(node_a(t, n.a)) || is_free(node_b(t, n.b)))
    return push_children(q, n, i, entry.weight);
  const LevelPair m = measure_level_pair(q, n, i);
  if (m.pair.status == PairContactStatus::apart) return end_apart(q, n, i, -m.pair.depth - m.reach);
  const std::int32_t contact = m.nearest <= t.query.tolerance ? keep(q, n, m, entry.weight) : -1;
  if (i >= 0 && blend(q, m.priority).below > 0.0) {
    f.queue.push_back({m.priority, entry.weight, i, n.a, n.b, contact});
    std::push_heap(f.queue.begin(), f.queue.end(), is_less_urgent);
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

// Whether there is time for another refinement. What one takes is known when the next one asks; as
// much is held back as the dearest of late took, so that a query ends late only by what is dearer
// than all before.
bool has_time(ContactFront& f, Budget& budget) noexcept {
  const double before = budget.now;
  budget.now = thread_cpu_seconds();
  if (before > 0.0) f.refine_cost = std::max(f.refine_cost, budget.now - before);
  const double finish = static_cast<double>(f.found.size()) * f.finish_cost;
  return budget.now + finish + f.refine_cost <= budget.deadline;
}

bool has_room(LevelQuery& q, Budget& budget, const PendingPair& top) noexcept {
  Traversal& t = q.t;
  if (budget.tests > 0) {
    const std::int64_t spent = t.set.stats.tests - budget.first;
    if (spent + most_tests(q, t.front.nodes[top.node]) > budget.tests) return false;
  }
  if (budget.deadline > 0.0 && !has_time(t.front, budget)) return false;
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
    push_children(q, f.nodes[top.node], top.node, top.weight * share.below);
    walk(q, visit_within);
  }
}

}  // namespace

void walk_within_budget(LevelQuery& q) noexcept {
  Traversal& t = q.t;
  ContactFront& f = t.front;
  const Resolution& r = t.query.resolution;
  Budget budget{.first = t.set.stats.tests, .tests = r.budget_tests};
  if (r.budget_cpu > 0.0) budget.deadline = thread_cpu_seconds() + r.budget_cpu;
  f.found.clear();
  f.queue.clear();
  f.refine_cost *= kForgets;
  walk(q, visit_within);
  t.set.stats.mandatory_tests += t.set.stats.tests - budget.first;
  refine(q, budget);
  for (const PendingPair& left : f.queue) {
    if (left.contact < 0 || !(left.priority > 1.0)) continue;
    ++t.set.stats.unrefined;
    f.found[static_cast<std::size_t>(left.contact)].decided_by = LevelDecision::budget;
  }
  const double start = budget.deadline > 0.0 ? thread_cpu_seconds() : 0.0;
  for (const Contact& c : f.found) {
    if (c.weight > 0.0) report(t, c);
  }
  if (budget.deadline > 0.0 && !f.found.empty()) {
    f.finish_cost = 2.0 * (thread_cpu_seconds() - start) / static_cast<double>(f.found.size());
  }
}

}  // namespace thigma::detail
