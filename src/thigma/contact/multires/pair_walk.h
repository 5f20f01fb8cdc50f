#pragma once
// Steps of the walk over the tree of pairs, shared by the one without and the one within a budget.

#include "thigma/contact/multires/measure_pair.h"

namespace thigma::detail {

/// What a pair is before its level is measured.
enum class Found : std::uint8_t {
  nothing,  // known or found to be too far apart
  finest,   // a contact of two finest patches
  open,     // to be measured or split
};

/// The memory of a pair to look at: a node of the front, or `none`, made to stand for one.
inline FrontNode& node_of(ContactFront& front, const PendingPair& entry, FrontNode& none) noexcept {
  if (entry.node >= 0) return front.nodes[entry.node];
  none.a = entry.a;
  none.b = entry.b;
  return none;
}

/// Whether what a node remembers may be outdated.
inline bool is_due(const MultiresQuery& query, std::int32_t i) noexcept {
  return query.frame.front.expires[i] <= query.now;
}

/// Classifies a pair, place i of the front or -1, counts it as part of the front, and measures
/// finest patches.
Found classify_pair(MultiresQuery& query, FrontNode& node, std::int32_t i,
                    PatchPair& finest) noexcept;

/// Ends the pair for as long as the bodies do not move by its slack.
void end_apart(MultiresQuery& query, FrontNode& node, std::int32_t i, double slack) noexcept;

/// Forgets everything below a node.
void drop_children(ContactFront& front, std::int32_t i) noexcept;

/// Which of the two is split: free nodes first, of two the larger; then the node whose children are
/// coarser.
bool splits_object(const QueryFrame& frame, std::int32_t a, std::int32_t b) noexcept;

/// Adds the children of a pair, which is part of the front no more, to the stack; without memory
/// where the front has no room for them.
void push_children(MultiresQuery& query, FrontNode& node, std::int32_t i, double weight) noexcept;

/// Shares of a pair and of its children in the contact (Sec. 3.4.4; the weight is this project's).
struct Blend {
  double own = 1.0, below = 0.0;
};

/// priority  s* / s0 of the pair
Blend blend(const MultiresQuery& query, double priority) noexcept;

Contact level_contact(const MultiresQuery& query, const FrontNode& node, const LevelPair& measured,
                      double weight) noexcept;

/// Visits what is pending, and what the visits make pending.
template <typename Visit>
void walk(MultiresQuery& query, Visit visit) noexcept {
  std::vector<PendingPair>& stack = query.frame.front.multires.pending;
  while (!stack.empty()) {
    const PendingPair entry = stack.back();
    stack.pop_back();
    visit(query, entry);
  }
}

}  // namespace thigma::detail
