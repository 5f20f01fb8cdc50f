#include "thigma/import/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

#include "thigma/core/index.h"

namespace thigma {
namespace {

constexpr double kTightness = 1.05;  // of the bound over the largest distance met
// Of the squared sine of a triangle's angle: below, weights of its corners have lost their digits.
constexpr double kLeastSine2 = 1e-20;
constexpr std::size_t kDivisionsPerPiece = 64;
constexpr std::size_t kLeastDivisions = 100'000;

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) noexcept {
  const Vec3 edge = b - a;
  const double length2 = edge.squaredNorm();
  if (!(length2 > 0.0)) return a;
  return a + std::clamp((p - a).dot(edge) / length2, 0.0, 1.0) * edge;
}

double box_distance(const TreeBox& box, const Vec3& p) noexcept {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(Vec3::Zero()).norm();
}

struct Search {
  const TriangleMesh& mesh;
  const TriangleTree& tree;
  const Vec3& p;
  NearestPoint best;
};

void search(Search& s, std::int32_t index) {
  const TreeNode& node = s.tree.nodes[idx(index)];
  if (node.count > 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = s.tree.order[idx(i)];
      if (box_distance(s.tree.boxes[idx(t)], s.p) >= s.best.distance) continue;
      const auto& v = s.mesh.triangles[idx(t)];
      const auto& x = s.mesh.positions;
      const Vec3 q = nearest_on_triangle(s.p, x[idx(v[0])], x[idx(v[1])], x[idx(v[2])]);
      const double distance = (s.p - q).norm();
      if (distance < s.best.distance) s.best = {t, distance, q};
    }
    return;
  }
  std::pair<double, std::int32_t> one(box_distance(s.tree.nodes[idx(index + 1)].box, s.p),
                                      index + 1);
  std::pair<double, std::int32_t> other(box_distance(s.tree.nodes[idx(node.right)].box, s.p),
                                        node.right);
  if (other.first < one.first) std::swap(one, other);
  if (one.first < s.best.distance) search(s, one.second);
  if (other.first < s.best.distance) search(s, other.second);
}

struct BoundedPiece {
  double bound = 0.0;
  TrianglePiece corners;
  bool operator<(const BoundedPiece& other) const { return bound < other.bound; }
};

// Distance to the one triangle nearest to the middle is convex: its largest value over the piece
// is at a corner. Distance to the surface grows by no more than the way from the middle.
BoundedPiece bounded(const TrianglePiece& c, const TriangleMesh& mesh, const TriangleTree& tree,
                     double& met) {
  const Vec3 middle = (c[0] + c[1] + c[2]) / 3.0;
  const NearestPoint nearest = nearest_point(mesh, tree, middle);
  met = std::max(met, nearest.distance);
  const auto& v = mesh.triangles[idx(nearest.triangle)];
  const auto& x = mesh.positions;
  double to_one = 0.0, size = 0.0;
  for (const Vec3& corner : c) {
    const Vec3 q = nearest_on_triangle(corner, x[idx(v[0])], x[idx(v[1])], x[idx(v[2])]);
    to_one = std::max(to_one, (corner - q).norm());
    size = std::max(size, (corner - middle).norm());
  }
  return {std::min(to_one, nearest.distance + size), c};
}

}  // namespace

Vec3 nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const Vec3 normal = ab.cross(ac);
  const double area2 = normal.squaredNorm();
  if (area2 > kLeastSine2 * ab.squaredNorm() * ac.squaredNorm()) {
    const double v = ap.cross(ac).dot(normal) / area2;
    const double w = ab.cross(ap).dot(normal) / area2;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) return a + v * ab + w * ac;
  }
  // Beside it, or a needle, which is nowhere far from its edges.
  Vec3 best = nearest_on_segment(p, a, b);
  for (const Vec3& q : {nearest_on_segment(p, b, c), nearest_on_segment(p, c, a)})
    if ((q - p).squaredNorm() < (best - p).squaredNorm()) best = q;
  return best;
}

NearestPoint nearest_point(const TriangleMesh& mesh, const TriangleTree& tree, const Vec3& p,
                           double reach) {
  Search s{mesh, tree, p, {}};
  s.best.distance = reach;
  if (!tree.nodes.empty() && box_distance(tree.nodes[0].box, p) < reach) search(s, 0);
  return s.best;
}

LargestDistance largest_distance(std::span<const TrianglePiece> pieces, const TriangleMesh& mesh,
                                 const TriangleTree& tree, double small) {
  LargestDistance largest;
  if (pieces.empty()) return largest;
  std::vector<BoundedPiece> first;
  first.reserve(pieces.size());
  for (const TrianglePiece& piece : pieces)
    first.push_back(bounded(piece, mesh, tree, largest.met));
  std::priority_queue<BoundedPiece> queue(std::less<BoundedPiece>(), std::move(first));
  const std::size_t most = std::max(kLeastDivisions, kDivisionsPerPiece * pieces.size());
  for (std::size_t n = 0; n < most; ++n) {
    if (queue.top().bound <= std::max(kTightness * largest.met, small)) break;
    const TrianglePiece c = queue.top().corners;
    queue.pop();
    const Vec3 ab = 0.5 * (c[0] + c[1]), bc = 0.5 * (c[1] + c[2]), ca = 0.5 * (c[2] + c[0]);
    for (const TrianglePiece& quarter : {TrianglePiece{c[0], ab, ca}, TrianglePiece{ab, c[1], bc},
                                         TrianglePiece{ca, bc, c[2]}, TrianglePiece{ab, bc, ca}})
      queue.push(bounded(quarter, mesh, tree, largest.met));
  }
  largest.bound = std::max(largest.met, queue.top().bound);
  return largest;
}

}  // namespace thigma
