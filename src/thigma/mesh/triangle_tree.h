#pragma once
// A tree of boxes over triangles, for searches over one mesh.

#include <cstdint>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

struct TreeBox {
  Vec3 min = Vec3::Zero(), max = Vec3::Zero();
  bool overlaps(const TreeBox& o) const noexcept {
    return min.x() <= o.max.x() && o.min.x() <= max.x() && min.y() <= o.max.y() &&
           o.min.y() <= max.y() && min.z() <= o.max.z() && o.min.z() <= max.z();
  }
};

/// The smallest box around both.
inline TreeBox united(const TreeBox& a, const TreeBox& b) noexcept {
  return {a.min.cwiseMin(b.min), a.max.cwiseMax(b.max)};
}

/// A squared distance to a box this many times that to a triangle is larger, however both were
/// rounded: what is in the box is farther.
inline constexpr double kFarther = 1.0 + 1e-9;

/// Squared distance from a point to a box, 0 inside.
inline double squared_distance(const TreeBox& box, const Vec3& p) noexcept {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(Vec3::Zero()).squaredNorm();
}

struct TreeNode {
  TreeBox box;
  std::int32_t right = -1;            // inner: the left child follows the node
  std::int32_t first = 0, count = 0;  // leaf: into order; count 0 for an inner node
};

/// Invariant: node 0 is the root; boxes are exact, closed, and hold everything below.
struct TriangleTree {
  std::vector<TreeNode> nodes;
  std::vector<std::int32_t> order;  // triangles, leaf by leaf
  std::vector<TreeBox> boxes;       // of each triangle of the mesh
};

/// Tree over some triangles of a mesh (finite positions, valid indices).
TriangleTree build_triangle_tree(const TriangleMesh& mesh, std::vector<std::int32_t> triangles);

}  // namespace thigma
