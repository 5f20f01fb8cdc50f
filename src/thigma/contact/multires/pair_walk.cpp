#include "thigma/contact/multires/pair_walk.h"

#include <algorithm>

namespace thigma::detail {
namespace {

// of s* / s0: below, a pair speaks for itself; from 1 on, its children do
constexpr double kBlendFrom = 0.8;

double child_resolution(const ClodHierarchy& hierarchy, const ClodNode& node) noexcept {
  return hierarchy.levels[static_cast<std::size_t>(node.level - 1)].resolution;
}

// Whether a pair that is not both finest has to be looked at: the culling test, when its last
// answer may be outdated.
bool is_open(MultiresQuery& query, FrontNode& node, std::int32_t i) noexcept {
  if (i >= 0 && node.decision == FrontNode::Decision::open && !is_due(query, i)) return true;
  const double slack = slack_of(query.frame, node);
  if (slack > 0.0) {
    end_apart(query, node, i, slack);
    return false;
  }
  if (i >= 0) {
    node.decision = FrontNode::Decision::open;
    set_timer(query.frame.front, i, -slack);
  }
  return true;
}

PatchPair measure_finest(MultiresQuery& query, FrontNode& node, std::int32_t i) noexcept {
  QueryFrame& frame = query.frame;
  const PatchPair pair = measure_leaf_pair(frame, node, crossing_probe(query.crossing));
  node.decision = FrontNode::Decision::unknown;
  if (pair.status == PairContactStatus::apart)
    end_apart(query, node, i, -pair.depth - frame.query.tolerance);
  return pair;
}

}  // namespace

bool splits_object(const QueryFrame& frame, std::int32_t a, std::int32_t b) noexcept {
  const ClodNode& na = node_a(frame, a);
  const ClodNode& nb = node_b(frame, b);
  if (na.child_count == 0) return false;
  if (nb.child_count == 0) return true;
  const bool free_a = is_free(na), free_b = is_free(nb);
  if (free_a != free_b) return free_a;
  const bool is_larger = na.radius + na.hausdorff >= nb.radius + nb.hausdorff;
  if (free_a) return is_larger;
  const double ra = child_resolution(frame.object, na), rb = child_resolution(frame.scene, nb);
  return ra != rb ? ra < rb : is_larger;
}

Blend blend(const MultiresQuery& query, double priority) noexcept {
  if (!is_blended(query)) return priority > 1.0 ? Blend{0.0, 1.0} : Blend{1.0, 0.0};
  const double x = std::min(std::max((priority - kBlendFrom) / (1.0 - kBlendFrom), 0.0), 1.0);
  const double below = x * x * (3.0 - 2.0 * x);
  return {1.0 - below, below};
}

void drop_children(ContactFront& front, std::int32_t i) noexcept {
  if (front.nodes[i].first_child < 0) return;
  const std::size_t base = front.work.size();
  front.work.push_back(i);
  while (front.work.size() > base) {
    const std::int32_t k = front.work.back();
    front.work.pop_back();
    for (std::int32_t c = front.nodes[k].first_child; c >= 0;) {
      const std::int32_t next = front.nodes[c].next_sibling;
      // its links outlive its place in the list
      if (front.nodes[c].first_child >= 0)
        front.work.push_back(c);
      else
        free_node(front, c);
      c = next;
    }
    front.nodes[k].first_child = -1;
    --front.split;
    if (k != i) free_node(front, k);
  }
}

void end_apart(MultiresQuery& query, FrontNode& node, std::int32_t i, double slack) noexcept {
  if (i < 0) return;
  drop_children(query.frame.front, i);
  node.decision = FrontNode::Decision::apart;
  set_timer(query.frame.front, i, slack);
}

Found classify_pair(MultiresQuery& query, FrontNode& node, std::int32_t i,
                    PatchPair& finest) noexcept {
  ++query.frame.set.stats.front;
  if (i >= 0 && node.decision == FrontNode::Decision::apart && !is_due(query, i))
    return Found::nothing;
  if (is_leaf_pair(query.frame, node.a, node.b)) {
    finest = measure_finest(query, node, i);
    return finest.status == PairContactStatus::apart ? Found::nothing : Found::finest;
  }
  return is_open(query, node, i) ? Found::open : Found::nothing;
}

void push_children(MultiresQuery& query, FrontNode& node, std::int32_t i, double weight) noexcept {
  QueryFrame& frame = query.frame;
  --frame.set.stats.front;
  ContactFront& front = frame.front;
  const bool of_a = splits_object(frame, node.a, node.b);
  if (i >= 0 && (node.first_child >= 0 || split(frame, i, of_a))) {
    for (std::int32_t c = node.first_child; c >= 0; c = front.nodes[c].next_sibling) {
      front.multires.pending.push_back({.weight = weight, .node = c});
    }
    return;
  }
  front.multires.unremembered = std::min(front.multires.unremembered, frame.query.tolerance);
  const ClodNode& parent = of_a ? node_a(frame, node.a) : node_b(frame, node.b);
  for (std::int32_t c = parent.first_child; c < parent.first_child + parent.child_count; ++c) {
    front.multires.pending.push_back(
        {.weight = weight, .a = of_a ? c : node.a, .b = of_a ? node.b : c});
  }
}

Contact level_contact(const MultiresQuery& query, const FrontNode& node, const LevelPair& measured,
                      double weight) noexcept {
  Contact c = make_contact(query.frame, node, measured.pair);
  c.bound = measured.bound;
  c.decided_by = measured.decided_by;
  c.weight = weight;
  return c;
}

}  // namespace thigma::detail
