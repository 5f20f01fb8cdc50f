#include "thigma/mesh/triangle_tree.h"

#include <algorithm>

namespace thigma {
namespace {

constexpr std::int32_t kLeafSize = 4;

TreeBox box_of(const TriangleTree& tree, std::int32_t first, std::int32_t last) {
  TreeBox box = tree.boxes[static_cast<std::size_t>(tree.order[static_cast<std::size_t>(first)])];
  for (std::int32_t i = first + 1; i < last; ++i) {
    const TreeBox& b =
        tree.boxes[static_cast<std::size_t>(tree.order[static_cast<std::size_t>(i)])];
    box.min = box.min.cwiseMin(b.min);
    box.max = box.max.cwiseMax(b.max);
  }
  return box;
}

// Halves by count along the longest side: depth is log2 of the size whatever the shape.
void build(TriangleTree& tree, std::int32_t first, std::int32_t last) {
  const std::size_t self = tree.nodes.size();
  tree.nodes.emplace_back();
  tree.nodes[self].box = box_of(tree, first, last);
  if (last - first <= kLeafSize) {
    tree.nodes[self].first = first;
    tree.nodes[self].count = last - first;
    return;
  }
  int axis = 0;
  (tree.nodes[self].box.max - tree.nodes[self].box.min).maxCoeff(&axis);
  const std::int32_t middle = first + (last - first) / 2;
  const auto before = [&](std::int32_t i, std::int32_t j) {
    const TreeBox& a = tree.boxes[static_cast<std::size_t>(i)];
    const TreeBox& b = tree.boxes[static_cast<std::size_t>(j)];
    const double x = a.min[axis] + a.max[axis];
    const double y = b.min[axis] + b.max[axis];
    return x < y || (x == y && i < j);
  };
  std::nth_element(tree.order.begin() + first, tree.order.begin() + middle,
                   tree.order.begin() + last, before);
  build(tree, first, middle);
  tree.nodes[self].right = static_cast<std::int32_t>(tree.nodes.size());
  build(tree, middle, last);
}

}  // namespace

TriangleTree build_triangle_tree(const TriangleMesh& mesh, std::vector<std::int32_t> triangles) {
  TriangleTree tree;
  tree.order = std::move(triangles);
  tree.boxes.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<std::int32_t, 3>& t = mesh.triangles[i];
    const Vec3& a = mesh.positions[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.positions[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.positions[static_cast<std::size_t>(t[2])];
    tree.boxes[i] = {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
  }
  if (!tree.order.empty()) build(tree, 0, static_cast<std::int32_t>(tree.order.size()));
  return tree;
}

}  // namespace thigma
