#include "thigma/mesh/self_intersections.h"

#include <algorithm>

#include "thigma/mesh/predicates.h"
#include "thigma/mesh/triangle_tree.h"
#include "thigma/mesh/triangles_meet.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;

struct Search {
  const TriangleMesh& mesh;
  const TriangleTree& tree;
  SelfIntersections& result;
  bool collect;
  std::int64_t tests_left;
};

void test_leaves(Search& s, const TreeNode& a, const TreeNode& b, bool same) {
  for (std::int32_t i = a.first; i < a.first + a.count; ++i) {
    for (std::int32_t j = same ? i + 1 : b.first; j < b.first + b.count; ++j) {
      const std::int32_t t = s.tree.order[static_cast<std::size_t>(i)];
      const std::int32_t u = s.tree.order[static_cast<std::size_t>(j)];
      --s.tests_left;
      if (!s.tree.boxes[static_cast<std::size_t>(t)].overlaps(
              s.tree.boxes[static_cast<std::size_t>(u)]))
        continue;
      if (!triangles_meet(s.mesh.positions, s.mesh.triangles[static_cast<std::size_t>(t)],
                          s.mesh.triangles[static_cast<std::size_t>(u)]))
        continue;
      ++s.result.pairs;
      if (s.collect) s.result.found.push_back({std::min(t, u), std::max(t, u)});
    }
  }
}

void descend(Search& s, std::int32_t left, std::int32_t right) {
  if (s.tests_left <= 0) return;
  const TreeNode& a = s.tree.nodes[static_cast<std::size_t>(left)];
  const TreeNode& b = s.tree.nodes[static_cast<std::size_t>(right)];
  if (left != right) {
    --s.tests_left;
    if (!a.box.overlaps(b.box)) return;
  }
  if (a.count > 0 && b.count > 0) {
    test_leaves(s, a, b, left == right);
  } else if (left == right) {
    descend(s, left + 1, left + 1);
    descend(s, a.right, a.right);
    descend(s, left + 1, a.right);
  } else if (b.count > 0 || (a.count == 0 && (a.box.max - a.box.min).squaredNorm() >
                                                 (b.box.max - b.box.min).squaredNorm())) {
    descend(s, left + 1, right);
    descend(s, a.right, right);
  } else {
    descend(s, left, right + 1);
    descend(s, left, b.right);
  }
}

}  // namespace

SelfIntersections find_self_intersections(const TriangleMesh& mesh, bool collect) {
  SelfIntersections result;
  std::vector<std::int32_t> with_area;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const Vec3& a = mesh.positions[static_cast<std::size_t>(t[0])];
    const Vec3& b = mesh.positions[static_cast<std::size_t>(t[1])];
    const Vec3& c = mesh.positions[static_cast<std::size_t>(t[2])];
    if (!are_collinear(a, b, c)) with_area.push_back(static_cast<std::int32_t>(i));
  }
  if (with_area.empty()) return result;
  const std::int64_t limit = 100'000'000 + 1000 * static_cast<std::int64_t>(with_area.size());
  const TriangleTree tree = build_triangle_tree(mesh, std::move(with_area));
  Search search{mesh, tree, result, collect, limit};
  descend(search, 0, 0);
  result.complete = search.tests_left > 0;
  std::sort(result.found.begin(), result.found.end());
  return result;
}

}  // namespace thigma
