#include "thigma/contact/multires/budget.h"

#include <algorithm>

#include "thigma/contact/multires/pair_walk.h"
#include "thigma/core/cpu_clock.h"

namespace thigma::detail {
namespace {

constexpr double kForgets =
    0.98;  // a query: the cost of the most expensive refinement halves in 35

struct Budget {
  std::int64_t first = 0;  // tests of the set before this query
  std::int64_t tests = 0;  // at most; 0: no limit
  double deadline = 0.0;   // of the thread's CPU clock; 0: none [s]
  double now = 0.0;        // of that clock, when it was looked at last; 0: not yet [s]
};

bool is_less_urgent(const PendingPair& x, const PendingPair& y) noexcept {
  if (x.priority != y.priority) return x.priority < y.priority;
  return x.a != y.a ? x.a > y.a : x.b > y.b;
}

std::int32_t keep(MultiresQuery& query, const FrontNode& node, const LevelPair& measured,
                  double weight) noexcept {
  std::vector<Contact>& found = query.frame.front.multires.found;
  if (found.size() == found.capacity()) {
    ++query.frame.set.dropped;
    return -1;
  }
  found.push_back(level_contact(query, node, measured, weight));
  return static_cast<std::int32_t>(found.size()) - 1;
}

// As visit, but whatever has a patch is measured, and what deserves refinement waits in the queue.
void visit_within(MultiresQuery& query, const PendingPair& entry) noexcept {
  QueryFrame& frame = query.frame;
  ContactFront& front = frame.front;
  MultiresFront& lists = front.multires;
  const std::int32_t i = entry.node;
  FrontNode none;
  FrontNode& node = node_of(front, entry, none);
  PatchPair finest;
  const Found found = classify_pair(query, node, i, finest);
  if (found == Found::nothing) return;
  if (found == Found::finest) {
    keep(query, node, {.pair = finest}, entry.weight);
    return;
  }
  if (is_free(node_a(frame, node.a)) || is_free(node_b(frame, node.b)))
    return push_children(query, node, i, entry.weight);
  const LevelPair measured = measure_level_pair(query, node, i);
  if (measured.pair.status == PairContactStatus::apart)
    return end_apart(query, node, i, -measured.pair.depth - measured.reach);
  const std::int32_t contact =
      measured.nearest <= frame.query.tolerance ? keep(query, node, measured, entry.weight) : -1;
  if (i >= 0 && blend(query, measured.priority).below > 0.0) {
    lists.queue.push_back({measured.priority, entry.weight, i, node.a, node.b, contact});
    std::push_heap(lists.queue.begin(), lists.queue.end(), is_less_urgent);
  }
}

// Tests that refining a pair may take, at most: two a child, none of one that is known to be apart.
std::int64_t most_tests(const MultiresQuery& query, const FrontNode& node) noexcept {
  const QueryFrame& frame = query.frame;
  const bool of_a = splits_object(frame, node.a, node.b);
  if (node.first_child < 0)
    return 2 * (of_a ? node_a(frame, node.a) : node_b(frame, node.b)).child_count;
  std::int64_t most = 0;
  for (std::int32_t c = node.first_child; c >= 0; c = frame.front.nodes[c].next_sibling) {
    const FrontNode& child = frame.front.nodes[c];
    if (child.decision == FrontNode::Decision::unknown || is_due(query, c)) {
      most += is_leaf_pair(frame, child.a, child.b) ? 1 : 2;
    } else if (child.decision == FrontNode::Decision::open) {
      most += 1;
    }
  }
  return most;
}

// Whether there is time for another refinement. What one takes is known when the next one asks; as
// much is held back as the most expensive recent one took, so a query ends late only by one that
// costs more than all before.
bool has_time(MultiresFront& lists, Budget& budget) noexcept {
  const double before = budget.now;
  budget.now = thread_cpu_seconds();
  if (before > 0.0) lists.refine_cost = std::max(lists.refine_cost, budget.now - before);
  const double finish = static_cast<double>(lists.found.size()) * lists.finish_cost;
  return budget.now + finish + lists.refine_cost <= budget.deadline;
}

bool has_room(MultiresQuery& query, Budget& budget, const PendingPair& top) noexcept {
  QueryFrame& frame = query.frame;
  if (budget.tests > 0) {
    const std::int64_t spent = frame.set.stats.tests - budget.first;
    if (spent + most_tests(query, frame.front.nodes[top.node]) > budget.tests) return false;
  }
  if (budget.deadline > 0.0 && !has_time(frame.front.multires, budget)) return false;
  // Every child may add a contact.
  const std::vector<Contact>& found = frame.front.multires.found;
  return found.capacity() - found.size() > 64;
}

void refine(MultiresQuery& query, Budget& budget) noexcept {
  ContactFront& front = query.frame.front;
  MultiresFront& lists = front.multires;
  while (!lists.queue.empty()) {
    const PendingPair top = lists.queue.front();
    if (!has_room(query, budget, top)) return;
    std::pop_heap(lists.queue.begin(), lists.queue.end(), is_less_urgent);
    lists.queue.pop_back();
    const Blend share = blend(query, top.priority);
    if (top.contact >= 0) lists.found[static_cast<std::size_t>(top.contact)].weight *= share.own;
    push_children(query, front.nodes[top.node], top.node, top.weight * share.below);
    walk(query, visit_within);
  }
}

}  // namespace

void walk_within_budget(MultiresQuery& query) noexcept {
  QueryFrame& frame = query.frame;
  MultiresFront& lists = frame.front.multires;
  const Resolution& r = query.resolution;
  Budget budget{.first = frame.set.stats.tests, .tests = r.budget_tests};
  if (r.budget_cpu > 0.0) budget.deadline = thread_cpu_seconds() + r.budget_cpu;
  lists.found.clear();
  lists.queue.clear();
  lists.refine_cost *= kForgets;
  walk(query, visit_within);
  frame.set.stats.mandatory_tests += frame.set.stats.tests - budget.first;
  refine(query, budget);
  for (const PendingPair& left : lists.queue) {
    if (left.contact < 0 || !(left.priority > 1.0)) continue;
    ++frame.set.stats.unrefined;
    lists.found[static_cast<std::size_t>(left.contact)].decided_by = LevelDecision::budget;
  }
  const double start = budget.deadline > 0.0 ? thread_cpu_seconds() : 0.0;
  for (const Contact& c : lists.found) {
    if (c.weight > 0.0) report(frame, c);
  }
  if (budget.deadline > 0.0 && !lists.found.empty()) {
    lists.finish_cost =
        2.0 * (thread_cpu_seconds() - start) / static_cast<double>(lists.found.size());
  }
}

}  // namespace thigma::detail
