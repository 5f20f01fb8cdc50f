#include "thigma/contact/exact/exact_front.h"

#include <algorithm>

#include <emmintrin.h>

#include "thigma/contact/detail/front_nodes.h"
#include "thigma/contact/exact/held_contacts.h"

// Sec. 3.4.1-3.4.2 with generalized front tracking (Ehmann and Lin 2001). Each decision of the
// traversal (this pair is farther apart than d_ab, that one is not) is kept with the motion it
// survives: a pair that misses its tolerance by s has to be looked at again only when the bodies
// may have moved by s against each other. A frame is then one pass over an array of numbers, tests
// of the few pairs whose time has come, and the contacts themselves, which are measured every frame
// and from nothing but the pose.

namespace thigma::detail {
namespace {

void activate(QueryFrame& frame, std::int32_t i) noexcept {
  ContactFront& front = frame.front;
  front.nodes[i].is_active = true;
  front.expires[i] = kNever;
  front.exact.incoming.push_back(i);
}

// What is near is counted while it is found: surfaces that conform have no pair at one tolerance
// and a million at twice that, and nobody has the time to measure them first.
class PairLimit {
 public:
  /// is_first  nothing is known yet: what is looked at on the way down comes once, not counted
  PairLimit(const QueryFrame& frame, bool is_first) noexcept
      : step_(static_cast<std::int64_t>(frame.query.most_pairs)),
        limit_(step_ + frame.set.stats.tests),
        is_first_(is_first) {}

  /// Halves the tolerance where there are too many. What was found so far is measured with the
  /// smaller one, and sleeps where it is farther.
  void hold(QueryFrame& frame) noexcept {
    if (!may_halve(frame.query, halvings_)) return;
    const ExactFront& lists = frame.front.exact;
    const std::size_t waiting =
        lists.active.size() + lists.incoming.size() + lists.saturated.size();
    const std::int64_t looked_at = is_first_ ? 0 : frame.set.stats.tests;
    const std::int64_t pairs = looked_at + static_cast<std::int64_t>(waiting);
    if (pairs <= limit_) return;
    ++halvings_;
    limit_ = pairs + step_;
    frame.query.tolerance *= 0.5;
    retarget(frame.front, frame.query.tolerance);
  }

 private:
  std::int64_t step_, limit_;
  bool is_first_;
  int halvings_ = 0;
};

// Looks at pair i of the front and everything below it that has to be. front.work above `base` is
// the stack.
void descend(QueryFrame& frame, std::int32_t i, PairLimit& most) noexcept {
  ContactFront& front = frame.front;
  const std::size_t base = front.work.size();
  front.work.push_back(i);
  while (front.work.size() > base) {
    const std::int32_t k = front.work.back();
    front.work.pop_back();
    FrontNode& node = front.nodes[k];
    most.hold(frame);
    Separation found;
    const double slack = slack_of(frame, node, &found);
    if (slack > 0.0) {
      set_timer(front, k, slack);
    } else if (is_leaf_pair(frame, node.a, node.b)) {
      activate(frame, k);
      if (frame.is_holding) keep_hulls(frame, k, found);
    } else if (split(frame, k, splits_a(frame, node.a, node.b))) {
      // It can only rise again once the bodies moved by what it lacks; a quarter of the tolerance
      // keeps it from going back and forth.
      set_timer(front, k, -slack + 0.25 * frame.query.tolerance);
      for (std::int32_t c = front.nodes[k].first_child; c >= 0; c = front.nodes[c].next_sibling)
        front.work.push_back(c);
    } else {
      front.nodes[k].is_saturated = true;
      front.expires[k] = kNever;
      front.exact.saturated.push_back(k);
    }
  }
}

// A split pair rises when all its children are culled and it is itself.
void try_to_rise(QueryFrame& frame, std::int32_t i) noexcept {
  ContactFront& front = frame.front;
  FrontNode& node = front.nodes[i];
  bool all_culled = true;
  for (std::int32_t c = node.first_child; c >= 0 && all_culled; c = front.nodes[c].next_sibling) {
    const FrontNode& child = front.nodes[c];
    all_culled = child.first_child < 0 && !child.is_active && !child.is_saturated;
  }
  const double slack = all_culled ? slack_of(frame, node) : 0.0;
  if (slack <= 0.0) {
    set_timer(front, i, std::max({-slack, 0.25 * frame.query.tolerance, 8.0 * front.last_step}));
    return;
  }
  for (std::int32_t c = node.first_child; c >= 0;) {
    const std::int32_t next = front.nodes[c].next_sibling;
    free_node(front, c);
    c = next;
  }
  node.first_child = -1;
  --front.split;
  set_timer(front, i, slack);
}

// Nodes whose time has come, into front.work.
void collect_expired(ContactFront& front) noexcept {
  const float now = round_up(front.travel);
  const __m128 limit = _mm_set1_ps(now);
  std::int32_t i = 0;
  for (; i + 4 <= front.used; i += 4) {
    int mask = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(front.expires.get() + i), limit));
    for (int k = 0; mask != 0; ++k, mask >>= 1) {
      if (mask & 1) front.work.push_back(i + k);
    }
  }
  for (; i < front.used; ++i) {
    if (front.expires[i] <= now) front.work.push_back(i);
  }
}

// What the tests of the next nodes read lies far apart in memory. It is asked for some tests ahead:
// the node of the front first, then those of the two bodies that it names, then their corners.
void prefetch_tests(const QueryFrame& frame) noexcept {
  constexpr std::size_t kNode = 7, kBodies = 5, kCorners = 3;  // from the back
  constexpr std::size_t kLine = 64;                            // bytes that come at once
  const ContactFront& front = frame.front;
  const std::size_t waiting = front.work.size();
  const auto ahead = [&](std::size_t k) -> const FrontNode& {
    return front.nodes[front.work[waiting - k]];
  };
  const auto fetch = [](const void* from, std::size_t bytes) {
    const char* line = static_cast<const char*>(from);
    for (std::size_t k = 0; k < bytes; k += kLine) __builtin_prefetch(line + k);
  };
  const auto fetch_corners = [&](const ClodHierarchy& body, const ClodNode& node) {
    fetch(body.lanes.data() + node.first_lane, 3 * sizeof(float) * idx(node.lane_count));
  };
  if (waiting >= kNode) __builtin_prefetch(&ahead(kNode));
  if (waiting >= kBodies && ahead(kBodies).a >= 0) {
    fetch(&node_a(frame, ahead(kBodies).a), sizeof(ClodNode));
    fetch(&node_b(frame, ahead(kBodies).b), sizeof(ClodNode));
  }
  if (waiting >= kCorners && ahead(kCorners).a >= 0) {
    fetch_corners(frame.object, node_a(frame, ahead(kCorners).a));
    fetch_corners(frame.scene, node_b(frame, ahead(kCorners).b));
  }
}

void update_front(QueryFrame& frame, PairLimit& most) noexcept {
  ContactFront& front = frame.front;
  front.work.clear();
  collect_expired(front);
  // From the back: children mostly follow their parents, so a parent sees what became of them.
  while (!front.work.empty()) {
    prefetch_tests(frame);
    const std::int32_t i = front.work.back();
    front.work.pop_back();
    if (front.nodes[i].a < 0 || front.expires[i] == kNever) continue;  // freed meanwhile
    if (front.nodes[i].first_child >= 0)
      try_to_rise(frame, i);
    else
      descend(frame, i, most);
  }
}

}  // namespace

bool splits_a(const QueryFrame& frame, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode& na = node_a(frame, a);
  const ClodNode& nb = node_b(frame, b);
  if (na.child_count == 0) return false;
  if (nb.child_count == 0) return true;
  return na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
}

bool track_exact(QueryFrame& frame) noexcept {
  const FrontState state = advance_front(frame, false);
  if (state == FrontState::no_memory) return false;
  frame.is_carrying = is_carrying(frame);
  frame.is_holding = frame.is_carrying && may_hold(frame);
  PairLimit most(frame, state == FrontState::empty);
  if (state == FrontState::empty) {
    descend(frame, take_node(frame.front), most);
  } else {
    update_front(frame, most);
  }
  frame.front.last = frame.pose;
  return true;
}

}  // namespace thigma::detail
