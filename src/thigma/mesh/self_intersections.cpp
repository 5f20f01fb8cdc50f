#include "thigma/mesh/self_intersections.h"

#include <algorithm>

#include "thigma/mesh/detail/triangle_tree.h"
#include "thigma/mesh/predicates.h"

namespace thigma {
namespace {

using detail::TreeNode;
using detail::TriangleTree;
using Triangle = std::array<std::int32_t, 3>;

struct Search {
  const TriangleMesh& mesh;
  const TriangleTree& tree;
  SelfIntersections& result;
  bool collect;
  std::int64_t tests_left;

  const Vec3& at(std::int32_t v) const { return mesh.positions[static_cast<std::size_t>(v)]; }
  bool meets(std::int32_t p, std::int32_t q, const Triangle& t) const {
    return segment_meets_triangle(at(p), at(q), at(t[0]), at(t[1]), at(t[2]));
  }
};

// Both turned so that the shared vertices come first; returns their number.
int align_shared(Triangle& a, Triangle& b) {
  int shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = static_cast<std::size_t>(shared); j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[i], a[static_cast<std::size_t>(shared)]);
      std::swap(b[j], b[static_cast<std::size_t>(shared)]);
      ++shared;
      break;
    }
  }
  return shared;
}

// Two triangles on one edge overlap when they are coplanar with their third corners on the same
// side of it.
bool share_edge_and_overlap(const Search& s, const Triangle& a, const Triangle& b) {
  if (orient3d(s.at(a[0]), s.at(a[1]), s.at(a[2]), s.at(b[2])) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat = [&](std::int32_t v) {
      return Vec2(s.at(v)[(axis + 1) % 3], s.at(v)[(axis + 2) % 3]);
    };
    const int side = orient2d(flat(a[0]), flat(a[1]), flat(a[2]));
    if (side != 0) return side == orient2d(flat(b[0]), flat(b[1]), flat(b[2]));
  }
  return false;
}

// Sides of the plane of a on which b's corners lie.
std::array<int, 3> sides(const Search& s, const Triangle& a, const Triangle& b) {
  std::array<int, 3> side{};
  for (std::size_t k = 0; k < 3; ++k)
    side[k] = orient3d(s.at(a[0]), s.at(a[1]), s.at(a[2]), s.at(b[k]));
  return side;
}

bool is_one_side(const std::array<int, 3>& side) {
  return side[0] != 0 && side[0] == side[1] && side[0] == side[2];
}

bool disjoint_corners_meet(const Search& s, const Triangle& a, const Triangle& b) {
  const std::array<int, 3> of_b = sides(s, a, b);
  if (is_one_side(of_b)) return false;
  if (of_b == std::array<int, 3>{0, 0, 0}) {
    return coplanar_triangles_meet(s.at(a[0]), s.at(a[1]), s.at(a[2]), s.at(b[0]), s.at(b[1]),
                                   s.at(b[2]));
  }
  if (is_one_side(sides(s, b, a))) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (s.meets(a[k], a[(k + 1) % 3], b) || s.meets(b[k], b[(k + 1) % 3], a)) return true;
  }
  return false;
}

bool pair_intersects(const Search& s, std::int32_t i, std::int32_t j) {
  Triangle a = s.mesh.triangles[static_cast<std::size_t>(i)];
  Triangle b = s.mesh.triangles[static_cast<std::size_t>(j)];
  switch (align_shared(a, b)) {
    case 3:
      return true;
    case 2:
      return share_edge_and_overlap(s, a, b);
    case 1:
      // The common part is convex and holds the shared vertex; if it is more, it reaches the edge
      // across from that vertex in one of the two.
      return s.meets(a[1], a[2], b) || s.meets(b[1], b[2], a);
    default:
      break;
  }
  return disjoint_corners_meet(s, a, b);
}

void test_leaves(Search& s, const TreeNode& a, const TreeNode& b, bool same) {
  for (std::int32_t i = a.first; i < a.first + a.count; ++i) {
    for (std::int32_t j = same ? i + 1 : b.first; j < b.first + b.count; ++j) {
      const std::int32_t t = s.tree.order[static_cast<std::size_t>(i)];
      const std::int32_t u = s.tree.order[static_cast<std::size_t>(j)];
      --s.tests_left;
      if (!s.tree.boxes[static_cast<std::size_t>(t)].overlaps(
              s.tree.boxes[static_cast<std::size_t>(u)]))
        continue;
      if (!pair_intersects(s, t, u)) continue;
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
  const TriangleTree tree = detail::build_triangle_tree(mesh, std::move(with_area));
  Search search{mesh, tree, result, collect, limit};
  descend(search, 0, 0);
  result.complete = search.tests_left > 0;
  std::sort(result.found.begin(), result.found.end());
  return result;
}

}  // namespace thigma
