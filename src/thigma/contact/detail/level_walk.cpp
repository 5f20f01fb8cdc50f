#include "thigma/contact/detail/level_walk.h"

#include <algorithm>

namespace thigma::detail {
namespace {

// of s* / s0: below, a pair speaks for itself; from 1 on, its children do
constexpr double kBlendFrom = 0.8;

double child_resolution(const ClodHierarchy& h, const ClodNode& node) noexcept {
  return h.levels[static_cast<std::size_t>(node.level - 1)].resolution;
}

// Whether a pair that is not both finest has to be looked at: the culling test, when its last
// answer may be outdated.
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
  const PatchPair pair =
      measure_patches(hull_view(t.object, n.a), hull_view(t.scene, n.b), t.pose, t.query.tolerance,
                      t.query.keep_directions, probe, n, t.set.stats);
  n.decision = FrontNode::Decision::unknown;
  if (pair.status == PairContactStatus::apart) end_apart(q, n, i, -pair.depth - t.query.tolerance);
  return pair;
}

}  // namespace

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

Blend blend(const LevelQuery& q, double priority) noexcept {
  if (!q.t.query.resolution.interpolates) return priority > 1.0 ? Blend{0.0, 1.0} : Blend{1.0, 0.0};
  const double x = std::min(std::max((priority - kBlendFrom) / (1.0 - kBlendFrom), 0.0), 1.0);
  const double below = x * x * (3.0 - 2.0 * x);
  return {1.0 - below, below};
}

void drop_children(ContactFront& f, std::int32_t i) noexcept {
  if (f.nodes[i].first_child < 0) return;
  const std::size_t base = f.work.size();
  f.work.push_back(i);
  while (f.work.size() > base) {
    const std::int32_t k = f.work.back();
    f.work.pop_back();
    for (std::int32_t c = f.nodes[k].first_child; c >= 0;) {
      const std::int32_t next = f.nodes[c].next_sibling;
      // its links outlive its place in the list
      if (f.nodes[c].first_child >= 0)
        f.work.push_back(c);
      else
        free_node(f, c);
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

Found look_at(LevelQuery& q, FrontNode& n, std::int32_t i, PatchPair& finest) noexcept {
  ++q.t.set.stats.front;
  if (i >= 0 && n.decision == FrontNode::Decision::apart && !is_due(q, i)) return Found::nothing;
  if (is_leaf_pair(q.t, n.a, n.b)) {
    finest = measure_finest(q, n, i);
    return finest.status == PairContactStatus::apart ? Found::nothing : Found::finest;
  }
  return is_open(q, n, i) ? Found::open : Found::nothing;
}

void push_children(LevelQuery& q, FrontNode& n, std::int32_t i, double weight) noexcept {
  Traversal& t = q.t;
  --t.set.stats.front;
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

Contact level_contact(const LevelQuery& q, const FrontNode& n, const LevelPair& m,
                      double weight) noexcept {
  Contact c = make_contact(q.t, n, m.pair);
  c.bound = m.bound;
  c.decided_by = m.decided_by;
  c.weight = weight;
  return c;
}

}  // namespace thigma::detail
