#pragma once
// "Which triangles are near this box", over the tree of mesh/.

#include <array>
#include <cstdint>

#include "thigma/mesh/triangle_tree.h"

namespace thigma {

/// Calls visit(triangle) for every triangle of the tree whose box meets the given one.
template <class Visit>
void visit_triangles(const TriangleTree& tree, const TreeBox& box, Visit visit) {
  if (tree.nodes.empty()) return;
  std::array<std::int32_t, 128> stack;  // one entry a level; the tree halves
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const std::int32_t index = stack[--top];
    const TreeNode& node = tree.nodes[static_cast<std::size_t>(index)];
    if (!node.box.overlaps(box)) continue;
    if (node.count == 0) {
      stack[top++] = node.right;
      stack[top++] = index + 1;
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = tree.order[static_cast<std::size_t>(i)];
      if (tree.boxes[static_cast<std::size_t>(t)].overlaps(box)) visit(t);
    }
  }
}

}  // namespace thigma
