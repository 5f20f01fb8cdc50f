#include "thigma/contact/exact/exact_query.h"

#include <algorithm>

#include "thigma/contact/detail/carry_contacts.h"
#include "thigma/contact/detail/front_nodes.h"
#include "thigma/contact/exact/exact_front.h"
#include "thigma/contact/exact/held_contacts.h"
#include "thigma/contact/surface_crossing.h"

namespace thigma::detail {
namespace {

// What the measurement of leaf pairs needs.
struct ExactQuery {
  QueryFrame& frame;
  SegmentProbe probe;
  bool is_unordered = false;  // some contacts came from a traversal without memory
};

// Reports the contact that a leaf pair, place i of the front, carries; false: it has to be
// measured.
bool report_carried(QueryFrame& frame, const FrontNode& node, std::int32_t i) noexcept {
  MeasuredContact carried;
  if (!carry_contact(frame, node, i, carried)) return false;
  if (-carried.pair.depth > frame.query.tolerance) return false;
  Contact contact = make_contact(frame, node, carried.pair);
  contact.bound = carried.bound;
  report(frame, contact);
  return true;
}

// Measures a leaf pair, reports it when it is a contact, returns its slack (<= 0 for a contact).
double measure_leaf(const ExactQuery& exact, FrontNode& node) noexcept {
  QueryFrame& frame = exact.frame;
  const PatchPair pair = measure_leaf_pair(frame, node, exact.probe);
  if (pair.status == PairContactStatus::apart) return -pair.depth - frame.query.tolerance;
  report(frame, make_contact(frame, node, pair));
  return 0.0;
}

// The same of a leaf pair, place i of the front, that carries its contact, or whose contact may be.
double carry_leaf(const ExactQuery& exact, FrontNode& node, std::int32_t i) noexcept {
  QueryFrame& frame = exact.frame;
  if (report_carried(frame, node, i)) return 0.0;
  double least = 0.0;
  if (frame.is_holding && is_certain(frame, i, least) && hold_pair(frame, i, least)) return 0.0;
  const PatchPair pair = measure_leaf_pair(frame, node, exact.probe);
  keep_contact(frame, i, hull_view(frame.object, node.a), hull_view(frame.scene, node.b),
               {.pair = pair, .nearest = -pair.depth});
  if (pair.status == PairContactStatus::apart) return -pair.depth - frame.query.tolerance;
  report(frame, make_contact(frame, node, pair));
  return 0.0;
}

std::int64_t packed(std::int32_t a, std::int32_t b) noexcept {
  return (static_cast<std::int64_t>(a) << 32) | static_cast<std::uint32_t>(b);
}

// Everything below a pair that the front has no room for. The stack was reserved for the depth of
// both trees.
void traverse_below(const ExactQuery& exact, std::int32_t a, std::int32_t b) noexcept {
  QueryFrame& frame = exact.frame;
  std::vector<std::int64_t>& stack = frame.front.exact.stack;
  stack.clear();
  stack.push_back(packed(a, b));
  while (!stack.empty()) {
    FrontNode node;
    node.a = static_cast<std::int32_t>(stack.back() >> 32);
    node.b = static_cast<std::int32_t>(stack.back() & 0xffffffff);
    stack.pop_back();
    if (is_leaf_pair(frame, node.a, node.b)) {
      measure_leaf(exact, node);
      continue;
    }
    if (slack_of(frame, node) > 0.0) continue;
    const bool of_a = splits_a(frame, node.a, node.b);
    const ClodNode& parent = of_a ? node_a(frame, node.a) : node_b(frame, node.b);
    for (std::int32_t c = 0; c < parent.child_count; ++c) {
      const std::int32_t child = parent.first_child + c;
      stack.push_back(of_a ? packed(child, node.b) : packed(node.a, child));
    }
  }
}

std::int64_t key_of(const QueryFrame& frame, std::int32_t i) noexcept {
  const FrontNode& node = frame.front.nodes[i];
  return packed(node_a(frame, node.a).patch, node_b(frame, node.b).patch);
}

// Measures the active leaf pairs in the order of their patches; those that left the tolerance fall
// asleep.
void measure_active(const ExactQuery& exact) noexcept {
  QueryFrame& frame = exact.frame;
  ContactFront& front = frame.front;
  ExactFront& lists = front.exact;
  std::sort(lists.incoming.begin(), lists.incoming.end(),
            [&](std::int32_t x, std::int32_t y) { return key_of(frame, x) < key_of(frame, y); });
  lists.next_active.clear();
  std::size_t old = 0, fresh = 0;
  while (old < lists.active.size() || fresh < lists.incoming.size()) {
    const bool take_old = fresh == lists.incoming.size() ||
                          (old < lists.active.size() &&
                           key_of(frame, lists.active[old]) < key_of(frame, lists.incoming[fresh]));
    const std::int32_t i = take_old ? lists.active[old++] : lists.incoming[fresh++];
    FrontNode& node = front.nodes[i];
    const double slack = frame.is_carrying ? carry_leaf(exact, node, i) : measure_leaf(exact, node);
    if (slack > 0.0) {
      front.nodes[i].is_active = false;
      set_timer(front, i, slack);
    } else {
      lists.next_active.push_back(i);
    }
  }
  lists.active.swap(lists.next_active);
  lists.incoming.clear();
}

void traverse_saturated(ExactQuery& exact) noexcept {
  QueryFrame& frame = exact.frame;
  ContactFront& front = frame.front;
  std::size_t kept = 0;
  for (const std::int32_t i : front.exact.saturated) {
    FrontNode& node = front.nodes[i];
    const double slack = slack_of(frame, node);
    if (slack > 0.0) {
      node.is_saturated = false;
      set_timer(front, i, slack);
      continue;
    }
    traverse_below(exact, node.a, node.b);
    exact.is_unordered = true;
    if (front.alive < front.capacity / 2) {  // room again: split it next frame
      node.is_saturated = false;
      // by what it is too near: with a smaller tolerance it may be far enough
      set_timer(front, i, slack);
    } else {
      front.exact.saturated[kept++] = i;
    }
  }
  front.exact.saturated.resize(kept);
}

}  // namespace

void query_exact(QueryFrame& frame) noexcept {
  if (!track_exact(frame)) return;
  const ContactFront& front = frame.front;
  const CrossingContext crossing{&frame.object, &frame.scene, frame.pose, front.object_closed,
                                 front.scene_closed};
  ExactQuery exact{frame, crossing_probe(crossing)};
  frame.is_holding = frame.is_holding && begin_holding(frame);
  measure_active(exact);
  if (frame.is_holding) fill_held(frame, exact.probe);
  traverse_saturated(exact);
  std::vector<Contact>& contacts = frame.set.contacts;
  const auto begin = contacts.begin() + static_cast<std::ptrdiff_t>(frame.first);
  if (frame.is_full || exact.is_unordered) std::sort(begin, contacts.end(), is_before);
  frame.set.stats.front += front.alive - front.split;
}

}  // namespace thigma::detail
