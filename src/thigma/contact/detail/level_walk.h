#pragma once
// Steps of the walk over the tree of pairs, shared by the one without and the one within a budget.

#include "thigma/contact/detail/level_measure.h"

namespace thigma::detail {

/// What a pair is before its level is measured.
enum class Found : std::uint8_t {
  nothing,  // known or found to be too far apart
  finest,   // a contact of two finest patches
  open,     // to be measured or split
};

/// The memory of a pair to look at: a node of the front, or `none`, made to stand for one.
inline FrontNode& node_of(ContactFront& f, const PendingPair& entry, FrontNode& none) noexcept {
  if (entry.node >= 0) return f.nodes[entry.node];
  none.a = entry.a;
  none.b = entry.b;
  return none;
}

/// Whether what a node remembers may be outdated.
inline bool is_due(const LevelQuery& q, std::int32_t i) noexcept {
  return q.t.front.expires[i] <= q.now;
}

/// Looks at pair n, place i of the front or -1, counts it as part of the front, and measures finest
/// patches.
Found look_at(LevelQuery& q, FrontNode& n, std::int32_t i, PatchPair& finest) noexcept;

/// Ends the pair for as long as the bodies do not move by its slack.
void end_apart(LevelQuery& q, FrontNode& n, std::int32_t i, double slack) noexcept;

/// Forgets everything below a node.
void drop_children(ContactFront& f, std::int32_t i) noexcept;

/// Which of the two is split: free nodes first, of two the larger; then the node whose children are
/// coarser.
bool splits_object(const Traversal& t, std::int32_t a, std::int32_t b) noexcept;

/// Adds the children of a pair, which is part of the front no more, to the stack; without memory
/// where the front has no room for them.
void push_children(LevelQuery& q, FrontNode& n, std::int32_t i, double weight) noexcept;

/// Shares of a pair and of its children in the contact (Sec. 3.4.4; the weight is this project's).
struct Blend {
  double own = 1.0, below = 0.0;
};

/// priority  s* / s0 of the pair
Blend blend(const LevelQuery& q, double priority) noexcept;

Contact level_contact(const LevelQuery& q, const FrontNode& n, const LevelPair& m,
                      double weight) noexcept;

/// Visits what is pending, and what the visits make pending.
template <typename Visit>
void walk(LevelQuery& q, Visit visit) noexcept {
  std::vector<PendingPair>& stack = q.t.front.pending;
  while (!stack.empty()) {
    const PendingPair entry = stack.back();
    stack.pop_back();
    visit(q, entry);
  }
}

}  // namespace thigma::detail
