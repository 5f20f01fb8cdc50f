#pragma once
// Boxes that come and go, and which of them meet a box.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/mesh/triangle_tree.h"

namespace thigma {

/// A binary tree of boxes under changing leaves. Which leaves a search finds, not only how fast,
/// may depend on the past only by boxes kept a little larger than asked: callers test their own.
class BoxTree {
 public:
  /// Leaves 0..boxes.size()-1.
  void build(std::span<const TreeBox> boxes);
  /// Replaces the box of a leaf. A leaf inside its box and not much smaller stays where it is.
  void update(std::int32_t leaf, const TreeBox& box);
  void remove(std::int32_t leaf);

  /// Calls visit(leaf) for every leaf whose box meets the given one. visit must neither change the
  /// tree nor search it. Several threads may search at once.
  template <class Visit>
  void visit(const TreeBox& box, Visit visit) const {
    if (root_ < 0) return;
    thread_local std::vector<std::int32_t> stack;
    stack.assign(1, root_);
    while (!stack.empty()) {
      const Node& node = nodes_[static_cast<std::size_t>(stack.back())];
      stack.pop_back();
      if (!node.box.overlaps(box)) continue;
      if (node.left < 0) {
        visit(node.leaf);
      } else {
        stack.push_back(node.right);
        stack.push_back(node.left);
      }
    }
  }

 private:
  struct Node {
    TreeBox box;
    std::int32_t parent = -1, left = -1, right = -1, leaf = -1;
  };
  std::int32_t build_range(std::span<std::int32_t> leaves, std::span<const TreeBox> boxes);
  void insert(std::int32_t node);
  void refit(std::int32_t node);
  std::int32_t new_node();

  std::vector<Node> nodes_;
  std::vector<std::int32_t> node_of_leaf_, free_;
  std::int32_t root_ = -1;
};

}  // namespace thigma
