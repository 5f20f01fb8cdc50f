#include "thigma/mesh/box_tree.h"

#include <algorithm>
#include <numeric>

#include "thigma/core/index.h"

namespace thigma {
namespace {

double half_surface(const TreeBox& box) {
  const Vec3 e = box.max - box.min;
  return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

bool holds(const TreeBox& outer, const TreeBox& inner) {
  return (outer.min.array() <= inner.min.array()).all() &&
         (outer.max.array() >= inner.max.array()).all();
}

}  // namespace

std::int32_t BoxTree::new_node() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return static_cast<std::int32_t>(nodes_.size()) - 1;
  }
  const std::int32_t node = free_.back();
  free_.pop_back();
  nodes_[idx(node)] = {};
  return node;
}

std::int32_t BoxTree::build_range(std::span<std::int32_t> leaves, std::span<const TreeBox> boxes) {
  const std::int32_t self = new_node();
  TreeBox box = boxes[idx(leaves[0])];
  for (const std::int32_t leaf : leaves) box = united(box, boxes[idx(leaf)]);
  nodes_[idx(self)].box = box;
  if (leaves.size() == 1) {
    nodes_[idx(self)].leaf = leaves[0];
    node_of_leaf_[idx(leaves[0])] = self;
    return self;
  }
  int axis = 0;
  (box.max - box.min).maxCoeff(&axis);
  const auto middle = leaves.begin() + static_cast<std::ptrdiff_t>(leaves.size() / 2);
  std::nth_element(leaves.begin(), middle, leaves.end(), [&](std::int32_t i, std::int32_t j) {
    const double x = boxes[idx(i)].min[axis] + boxes[idx(i)].max[axis];
    const double y = boxes[idx(j)].min[axis] + boxes[idx(j)].max[axis];
    return x < y || (x == y && i < j);
  });
  const std::int32_t left = build_range({leaves.begin(), middle}, boxes);
  const std::int32_t right = build_range({middle, leaves.end()}, boxes);
  nodes_[idx(self)].left = left;
  nodes_[idx(self)].right = right;
  nodes_[idx(left)].parent = nodes_[idx(right)].parent = self;
  return self;
}

void BoxTree::build(std::span<const TreeBox> boxes) {
  nodes_.clear();
  free_.clear();
  root_ = -1;
  node_of_leaf_.assign(boxes.size(), -1);
  if (boxes.empty()) return;
  nodes_.reserve(2 * boxes.size());
  std::vector<std::int32_t> leaves(boxes.size());
  std::iota(leaves.begin(), leaves.end(), 0);
  root_ = build_range(leaves, boxes);
}

void BoxTree::refit(std::int32_t node) {
  for (; node >= 0; node = nodes_[idx(node)].parent) {
    Node& n = nodes_[idx(node)];
    n.box = united(nodes_[idx(n.left)].box, nodes_[idx(n.right)].box);
  }
}

void BoxTree::insert(std::int32_t node) {
  if (root_ < 0) {
    root_ = node;
    nodes_[idx(node)].parent = -1;
    return;
  }
  const TreeBox box = nodes_[idx(node)].box;
  std::int32_t beside = root_;
  while (nodes_[idx(beside)].left >= 0) {
    const Node& n = nodes_[idx(beside)];
    const double here = half_surface(united(n.box, box));
    const double growth = here - half_surface(n.box);
    const auto cost = [&](std::int32_t child) {
      const Node& c = nodes_[idx(child)];
      const double joint = half_surface(united(c.box, box));
      return growth + (c.left < 0 ? joint : joint - half_surface(c.box));
    };
    const double left = cost(n.left), right = cost(n.right);
    if (here < left && here < right) break;
    beside = left <= right ? n.left : n.right;
  }
  const std::int32_t parent = new_node(), above = nodes_[idx(beside)].parent;
  nodes_[idx(parent)].parent = above;
  nodes_[idx(parent)].left = beside;
  nodes_[idx(parent)].right = node;
  nodes_[idx(beside)].parent = nodes_[idx(node)].parent = parent;
  if (above < 0)
    root_ = parent;
  else
    (nodes_[idx(above)].left == beside ? nodes_[idx(above)].left : nodes_[idx(above)].right) =
        parent;
  refit(parent);
}

void BoxTree::update(std::int32_t leaf, const TreeBox& box) {
  const std::int32_t old = node_of_leaf_[idx(leaf)];
  const TreeBox& kept = nodes_[idx(old)].box;
  if (holds(kept, box) && (box.max - box.min).norm() > 0.7 * (kept.max - kept.min).norm()) return;
  remove(leaf);
  const std::int32_t node = new_node();
  nodes_[idx(node)].box = box;
  nodes_[idx(node)].leaf = leaf;
  node_of_leaf_[idx(leaf)] = node;
  insert(node);
}

void BoxTree::remove(std::int32_t leaf) {
  const std::int32_t node = node_of_leaf_[idx(leaf)], parent = nodes_[idx(node)].parent;
  node_of_leaf_[idx(leaf)] = -1;
  free_.push_back(node);
  if (parent < 0) {
    root_ = -1;
    return;
  }
  const std::int32_t beside =
      nodes_[idx(parent)].left == node ? nodes_[idx(parent)].right : nodes_[idx(parent)].left;
  const std::int32_t above = nodes_[idx(parent)].parent;
  nodes_[idx(beside)].parent = above;
  free_.push_back(parent);
  if (above < 0) {
    root_ = beside;
    return;
  }
  (nodes_[idx(above)].left == parent ? nodes_[idx(above)].left : nodes_[idx(above)].right) = beside;
  refit(above);
}

}  // namespace thigma
