#include "thigma/simplify/detail/deviation_guard.h"

#include <cmath>
#include <numeric>

#include "thigma/convex/quickhull.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

bool is_within(const DeviationGuard& guard, double limit, const Vec3& p, std::int32_t t) {
  const auto& v = guard.original->triangles[idx(t)];
  const auto& x = guard.original->positions;
  // Fine triangles are smaller than the limit: where a corner is near enough, so is the triangle.
  const double limit2 = limit * limit;
  if (squared_distance(guard.tree.boxes[idx(t)], p) > limit2) return false;
  for (const std::int32_t corner : v)
    if ((p - x[idx(corner)]).squaredNorm() <= limit2) return true;
  return point_triangle_distance(p, x[idx(v[0])], x[idx(v[1])], x[idx(v[2])]) <= limit;
}

/// A triangle within the limit of p, -1 for none. Of two branches the nearer is searched first.
std::int32_t find_by_tree(const DeviationGuard& guard, DeviationSearch& search, const Vec3& p) {
  const double limit2 = search.limit * search.limit;
  const auto distance2 = [&](std::int32_t node) {
    return squared_distance(guard.tree.nodes[idx(node)].box, p);
  };
  if (distance2(0) > limit2) return -1;
  search.stack.assign(1, 0);
  while (!search.stack.empty()) {
    const std::int32_t index = search.stack.back();
    search.stack.pop_back();
    const TreeNode& node = guard.tree.nodes[idx(index)];
    if (node.count == 0) {
      const std::int32_t left = index + 1;
      const double to_left = distance2(left), to_right = distance2(node.right);
      const bool is_left_nearer = to_left <= to_right;
      if (std::max(to_left, to_right) <= limit2)
        search.stack.push_back(is_left_nearer ? node.right : left);
      if (std::min(to_left, to_right) <= limit2)
        search.stack.push_back(is_left_nearer ? left : node.right);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      if (is_within(guard, search.limit, p, guard.tree.order[idx(i)]))
        return guard.tree.order[idx(i)];
  }
  return -1;
}

// of an edge: where the limit is far below the triangle, samples are sparser
constexpr int kMostDivisions = 32;

}  // namespace

DeviationGuard build_deviation_guard(const TriangleMesh& original) {
  DeviationGuard guard;
  guard.original = &original;
  std::vector<std::int32_t> all(original.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  guard.tree = build_triangle_tree(original, std::move(all));
  guard.near.assign(original.positions.size(), 0);
  for (std::size_t t = 0; t < original.triangles.size(); ++t)
    for (const std::int32_t v : original.triangles[t])
      guard.near[idx(v)] = static_cast<std::int32_t>(t);
  guard.first_sample.assign(original.triangles.size(), -1);
  guard.next_sample.assign(original.positions.size(), -1);
  std::vector<char> is_placed(original.positions.size(), 0);
  for (std::size_t t = 0; t < original.triangles.size(); ++t)
    for (const std::int32_t v : original.triangles[t]) {
      if (is_placed[idx(v)]) continue;
      is_placed[idx(v)] = 1;
      guard.next_sample[idx(v)] = guard.first_sample[t];
      guard.first_sample[t] = v;
    }
  return guard;
}

std::int32_t find_within_limit(const DeviationGuard& guard, DeviationSearch& search, const Vec3& p,
                               const std::array<std::int32_t, 3>& vertices) {
  for (const std::int32_t v : vertices)
    if (is_within(guard, search.limit, p, guard.near[idx(v)])) return guard.near[idx(v)];
  return find_by_tree(guard, search, p);
}

int count_divisions(double limit, const std::array<Vec3, 3>& corners) {
  const auto& [p, a, b] = corners;
  const double longest2 =
      std::max({(a - p).squaredNorm(), (b - p).squaredNorm(), (b - a).squaredNorm()});
  const double wanted = std::sqrt(longest2) / (kSampleSpacing * limit);
  return wanted < kMostDivisions ? std::max(2, static_cast<int>(std::ceil(wanted)))
                                 : kMostDivisions;
}

bool is_within_limit(const DeviationGuard& guard, DeviationSearch& search,
                     const std::array<Vec3, 3>& corners, const std::array<std::int32_t, 3>& near,
                     int divisions, bool has_last_edge) {
  const auto& [p, a, b] = corners;
  const int n = divisions;
  std::int32_t last = guard.near[idx(near[0])];  // near the sample before
  const auto is_near = [&](const Vec3& x, std::int32_t vertex) {
    if (is_within(guard, search.limit, x, last)) return true;
    last = guard.near[idx(vertex)];
    if (is_within(guard, search.limit, x, last)) return true;
    last = find_by_tree(guard, search, x);
    return last >= 0;
  };
  for (int i = 0; i < n; ++i)  // i = n is the first corner
    for (int j = 0; j <= n - i; ++j) {
      const int k = n - i - j;
      if (i == 0 && (j == n || k == n)) continue;  // the other two
      if (j == 0 && !has_last_edge) continue;
      if (!is_near((i * p + j * a + k * b) / n, near[j > k ? 1 : 2])) return false;
    }
  return n != 2 || is_near((p + a + b) / 3.0, near[0]);
}

}  // namespace thigma::detail
