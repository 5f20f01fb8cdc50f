#pragma once
// An independent answer to "which triangles come within d": boxes over single triangles, plain
// double arithmetic, nothing of the engine but its vector types. Slow and simple on purpose;
// all_pairs() checks it on small meshes.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

using Triangle = std::array<Vec3, 3>;

inline double point_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 e = b - a;
  const double l2 = e.squaredNorm();
  const double t = l2 > 0.0 ? std::clamp((p - a).dot(e) / l2, 0.0, 1.0) : 0.0;
  return (p - (a + t * e)).norm();
}

// Over the inside of the triangle only; its edges are the business of segments.
inline double point_inside_triangle(const Vec3& p, const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double n2 = n.squaredNorm();
  if (n2 == 0.0) return std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    if ((t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(n) < 0.0)
      return std::numeric_limits<double>::infinity();
  }
  return std::fabs((p - t[0]).dot(n)) / std::sqrt(n2);
}

inline double segment_segment(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  double best = std::min({point_segment(a0, b0, b1), point_segment(a1, b0, b1),
                          point_segment(b0, a0, a1), point_segment(b1, a0, a1)});
  const Vec3 u = a1 - a0, v = b1 - b0, n = u.cross(v);
  const double n2 = n.squaredNorm();
  // lines cross: the common perpendicular counts when its feet lie on both segments
  if (n2 > 0.0) {
    const Vec3 r = b0 - a0;
    const double s = r.cross(v).dot(n) / n2, t = r.cross(u).dot(n) / n2;
    if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0)
      best = std::min(best, ((a0 + s * u) - (b0 + t * v)).norm());
  }
  return best;
}

inline bool segment_through_triangle(const Vec3& a, const Vec3& b, const Triangle& t) {
  const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double da = (a - t[0]).dot(n), db = (b - t[0]).dot(n);
  if ((da > 0.0 && db > 0.0) || (da < 0.0 && db < 0.0) || da == db) return false;
  const Vec3 p = a + (da / (da - db)) * (b - a);
  return point_inside_triangle(p, t) < std::numeric_limits<double>::infinity();
}

/// 0 when they intersect.
inline double triangle_triangle(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (segment_through_triangle(a[i], a[(i + 1) % 3], b) ||
        segment_through_triangle(b[i], b[(i + 1) % 3], a))
      return 0.0;
  }
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    best = std::min({best, point_inside_triangle(a[i], b), point_inside_triangle(b[i], a)});
    for (std::size_t j = 0; j < 3; ++j) {
      best = std::min(best, segment_segment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]));
    }
  }
  return best;
}

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = -low;
  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
};

inline double box_box(const Box& a, const Box& b) {
  const Vec3 gap = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero());
  return gap.norm();
}

/// Binary tree of boxes over the triangles of a mesh that have an area.
struct TriangleTree {
  struct Node {
    Box box;
    int left = -1, right = -1;  // -1: a leaf with the triangle `first`
    int first = -1;
  };
  std::vector<Triangle> triangles;
  std::vector<int> ids;  // of the triangles in the mesh
  std::vector<Node> nodes;
};

inline int build_node(TriangleTree& tree, std::vector<int>& order, int begin, int end) {
  const int index = static_cast<int>(tree.nodes.size());
  tree.nodes.emplace_back();
  Box box;
  for (int i = begin; i < end; ++i) {
    for (const Vec3& p :
         tree.triangles[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])])
      box.add(p);
  }
  tree.nodes[static_cast<std::size_t>(index)].box = box;
  if (end - begin == 1) {
    tree.nodes[static_cast<std::size_t>(index)].first = order[static_cast<std::size_t>(begin)];
    return index;
  }
  int axis = 0;
  (box.high - box.low).maxCoeff(&axis);
  const int middle = (begin + end) / 2;
  auto center = [&](int t) {
    const Triangle& c = tree.triangles[static_cast<std::size_t>(t)];
    return c[0][axis] + c[1][axis] + c[2][axis];
  };
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](int x, int y) { return center(x) < center(y); });
  const int left = build_node(tree, order, begin, middle);
  const int right = build_node(tree, order, middle, end);
  tree.nodes[static_cast<std::size_t>(index)].left = left;
  tree.nodes[static_cast<std::size_t>(index)].right = right;
  return index;
}

/// Tree of a mesh placed by a pose.
inline TriangleTree build_triangle_tree(const TriangleMesh& mesh, const Pose& pose = {}) {
  TriangleTree tree;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corner;
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] =
          transform_point(pose, mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])]);
    }
    if ((corner[1] - corner[0]).cross(corner[2] - corner[0]).squaredNorm() == 0.0) continue;
    tree.triangles.push_back(corner);
    tree.ids.push_back(static_cast<int>(t));
  }
  std::vector<int> order(tree.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  if (!order.empty()) build_node(tree, order, 0, static_cast<int>(order.size()));
  return tree;
}

struct TrianglePair {
  int a = -1, b = -1;  // in the meshes
  double distance = 0.0;
};

/// Calls visit(distance, triangle_a, triangle_b) -> new limit for every pair whose boxes come
/// within the limit.
template <class Visit>
void search_pairs(const TriangleTree& a, const TriangleTree& b, double limit, const Visit& visit) {
  if (a.nodes.empty() || b.nodes.empty()) return;
  std::vector<std::pair<int, int>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const TriangleTree::Node& na = a.nodes[static_cast<std::size_t>(i)];
    const TriangleTree::Node& nb = b.nodes[static_cast<std::size_t>(j)];
    if (box_box(na.box, nb.box) > limit) continue;
    if (na.left < 0 && nb.left < 0) {
      const auto ta = static_cast<std::size_t>(na.first), tb = static_cast<std::size_t>(nb.first);
      limit = visit(triangle_triangle(a.triangles[ta], b.triangles[tb]), a.ids[ta], b.ids[tb]);
      continue;
    }
    const bool of_a = nb.left < 0 || (na.left >= 0 && (na.box.high - na.box.low).squaredNorm() >=
                                                          (nb.box.high - nb.box.low).squaredNorm());
    // The nearer child last, so that it is searched first.
    std::pair<int, int> x = of_a ? std::pair{na.left, j} : std::pair{i, nb.left};
    std::pair<int, int> y = of_a ? std::pair{na.right, j} : std::pair{i, nb.right};
    auto gap = [&](const std::pair<int, int>& p) {
      return box_box(a.nodes[static_cast<std::size_t>(p.first)].box,
                     b.nodes[static_cast<std::size_t>(p.second)].box);
    };
    if (gap(x) < gap(y)) std::swap(x, y);
    stack.push_back(x);
    stack.push_back(y);
  }
}

/// Smallest distance of two surfaces, 0 when they intersect [m].
inline double least_triangle_distance(const TriangleTree& a, const TriangleTree& b) {
  double best = std::numeric_limits<double>::infinity();
  search_pairs(a, b, best,
               [&](double distance, int, int) { return best = std::min(best, distance); });
  return best;
}

/// Every pair of triangles within d, by (a, b).
inline std::vector<TrianglePair> triangle_pairs_within(const TriangleTree& a, const TriangleTree& b,
                                                       double d) {
  std::vector<TrianglePair> pairs;
  search_pairs(a, b, d, [&](double distance, int ta, int tb) {
    if (distance <= d) pairs.push_back({ta, tb, distance});
    return d;
  });
  std::sort(pairs.begin(), pairs.end(), [](const TrianglePair& x, const TrianglePair& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  });
  return pairs;
}

/// The same without any tree.
inline std::vector<TrianglePair> all_pairs(const TriangleTree& a, const TriangleTree& b, double d) {
  std::vector<TrianglePair> pairs;
  for (std::size_t i = 0; i < a.triangles.size(); ++i) {
    for (std::size_t j = 0; j < b.triangles.size(); ++j) {
      const double distance = triangle_triangle(a.triangles[i], b.triangles[j]);
      if (distance <= d) pairs.push_back({a.ids[i], b.ids[j], distance});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const TrianglePair& x, const TrianglePair& y) {
    return std::pair(x.a, x.b) < std::pair(y.a, y.b);
  });
  return pairs;
}

}  // namespace thigma::test
