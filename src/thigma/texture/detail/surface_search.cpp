#include "thigma/texture/detail/surface_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

double box_distance(const TreeBox& box, const Vec3& p) {
  return (box.min - p).cwiseMax(p - box.max).cwiseMax(Vec3::Zero()).norm();
}

// Share along the segment from a to b of the point nearest to p.
double share_along(const Vec3& a, const Vec3& b, const Vec3& p) {
  const Vec3 way = b - a;
  const double size = way.squaredNorm();
  return size > 0.0 ? std::clamp(way.dot(p - a) / size, 0.0, 1.0) : 0.0;
}

void search_near(const SurfaceSearch& search, std::int32_t index, const Vec3& p,
                 SurfacePoint& best) {
  const TreeNode& node = search.tree.nodes[idx(index)];
  if (node.count > 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = search.tree.order[idx(i)];
      if (box_distance(search.tree.boxes[idx(t)], p) >= best.distance) continue;
      const SurfacePoint here = nearest_of_triangle(*search.mesh, t, p);
      if (here.distance < best.distance) best = here;
    }
    return;
  }
  std::int32_t one = index + 1, other = node.right;
  double to_one = box_distance(search.tree.nodes[idx(one)].box, p);
  double to_other = box_distance(search.tree.nodes[idx(other)].box, p);
  if (to_other < to_one) {
    std::swap(one, other);
    std::swap(to_one, to_other);
  }
  if (to_one < best.distance) search_near(search, one, p, best);
  if (to_other < best.distance) search_near(search, other, p, best);
}

struct Line {
  Vec3 origin, direction;
};

/// Whether the line passes a box at some |t| up to `reach`.
bool passes(const Line& line, const TreeBox& box, double reach) {
  double first = -reach, last = reach;
  for (int k = 0; k < 3; ++k) {
    const double d = line.direction[k];
    const double low = box.min[k] - line.origin[k], high = box.max[k] - line.origin[k];
    if (d == 0.0) {
      if (low > 0.0 || high < 0.0) return false;
      continue;
    }
    first = std::max(first, std::min(low / d, high / d));
    last = std::min(last, std::max(low / d, high / d));
  }
  return first <= last;
}

/// The crossing of one triangle, if nearer than `best`.
void cross_triangle(const SurfaceSearch& search, std::int32_t t, const Line& line, double reach,
                    SurfacePoint& best) {
  const auto& v = search.mesh->triangles[idx(t)];
  const Vec3 &a = search.mesh->positions[idx(v[0])], &b = search.mesh->positions[idx(v[1])],
             &c = search.mesh->positions[idx(v[2])];
  const Vec3 normal = (b - a).cross(c - a);
  const double along = normal.dot(line.direction);
  constexpr double kEdgeOn = 1e-6;  // cosine: below, the crossing is anywhere on the triangle
  if (!(along > kEdgeOn * normal.norm())) return;
  const double way = normal.dot(a - line.origin) / along;
  if (!(std::fabs(way) <= reach) ||
      (best.triangle >= 0 && !(std::fabs(way) < std::fabs(best.distance))))
    return;
  const Vec3 p = line.origin + way * line.direction;
  const double size = normal.squaredNorm();
  const Vec3 weights((c - b).cross(p - b).dot(normal) / size,
                     (a - c).cross(p - c).dot(normal) / size,
                     (b - a).cross(p - a).dot(normal) / size);
  constexpr double kSlack = 1e-9;  // of the weights: no line slips through between two triangles
  if (weights.minCoeff() < -kSlack) return;
  best = {t, weights, p, way};
}

}  // namespace

SurfaceSearch build_surface_search(const TriangleMesh& mesh) {
  SurfaceSearch search{&mesh, {}};
  std::vector<std::int32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  search.tree = build_triangle_tree(mesh, std::move(all));
  return search;
}

SurfacePoint nearest_of_triangle(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& p) {
  const auto& v = mesh.triangles[idx(triangle)];
  const std::array<Vec3, 3> c = {mesh.positions[idx(v[0])], mesh.positions[idx(v[1])],
                                 mesh.positions[idx(v[2])]};
  SurfacePoint best;
  best.triangle = triangle;
  const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
  const double size = normal.squaredNorm();
  if (size > 0.0) {
    const Vec3 w((c[2] - c[1]).cross(p - c[1]).dot(normal) / size,
                 (c[0] - c[2]).cross(p - c[2]).dot(normal) / size,
                 (c[1] - c[0]).cross(p - c[0]).dot(normal) / size);
    if (w.minCoeff() >= 0.0) {
      best.weights = w;
      best.at = p - normal * (normal.dot(p - c[0]) / size);
      best.distance = (p - best.at).norm();
      return best;
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double share = share_along(c[k], c[next], p);
    const Vec3 here = c[k] + share * (c[next] - c[k]);
    const double distance = (p - here).norm();
    if (!(distance < best.distance)) continue;
    best.distance = distance;
    best.at = here;
    best.weights.setZero();
    best.weights[static_cast<Eigen::Index>(k)] = 1.0 - share;
    best.weights[static_cast<Eigen::Index>(next)] = share;
  }
  return best;
}

SurfacePoint nearest_point(const SurfaceSearch& search, const Vec3& p) {
  SurfacePoint best;
  if (!search.tree.nodes.empty()) search_near(search, 0, p, best);
  return best;
}

SurfacePoint crossing_point(const SurfaceSearch& search, const Vec3& p, const Vec3& direction,
                            double reach) {
  const Line line{p, direction};
  SurfacePoint best;
  std::array<std::int32_t, 128> stack;  // one entry a level; the tree halves
  std::size_t top = 0;
  if (!search.tree.nodes.empty()) stack[top++] = 0;
  while (top > 0) {
    const std::int32_t index = stack[--top];
    const TreeNode& node = search.tree.nodes[idx(index)];
    const double within = best.triangle >= 0 ? std::fabs(best.distance) : reach;
    if (!passes(line, node.box, within)) continue;
    if (node.count == 0) {
      stack[top++] = node.right;
      stack[top++] = index + 1;
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      cross_triangle(search, search.tree.order[idx(i)], line, reach, best);
  }
  return best;
}

}  // namespace thigma::detail
