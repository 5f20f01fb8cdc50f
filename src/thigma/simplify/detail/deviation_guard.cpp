#include "thigma/simplify/detail/deviation_guard.h"

#include <cmath>
#include <numeric>

#include "thigma/convex/quickhull.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

bool is_within(const DeviationGuard& guard, const Vec3& p, std::int32_t t) {
  const auto& v = guard.original->triangles[idx(t)];
  const auto& x = guard.original->positions;
  // Fine triangles are smaller than the limit: where a corner is near enough, so is the triangle.
  if ((p - x[idx(v[0])]).squaredNorm() <= guard.limit * guard.limit) return true;
  if (squared_distance(guard.tree.boxes[idx(t)], p) > guard.limit * guard.limit) return false;
  return point_triangle_distance(p, x[idx(v[0])], x[idx(v[1])], x[idx(v[2])]) <= guard.limit;
}

// of an edge: where the limit is far below the triangle, samples are sparser
constexpr int kMostDivisions = 32;

}  // namespace

DeviationGuard build_deviation_guard(const TriangleMesh& original, double limit) {
  DeviationGuard guard;
  guard.original = &original;
  guard.limit = limit;
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

std::int32_t find_within_limit(DeviationGuard& guard, const Vec3& p,
                               const std::array<std::int32_t, 3>& vertices) {
  for (const std::int32_t v : vertices)
    if (is_within(guard, p, guard.near[idx(v)])) return guard.near[idx(v)];
  const TreeBox box{p - Vec3::Constant(guard.limit), p + Vec3::Constant(guard.limit)};
  guard.stack.assign(1, 0);
  while (!guard.stack.empty()) {
    const std::int32_t index = guard.stack.back();
    guard.stack.pop_back();
    const TreeNode& node = guard.tree.nodes[idx(index)];
    if (!node.box.overlaps(box)) continue;
    if (node.count == 0) {
      guard.stack.push_back(node.right);
      guard.stack.push_back(index + 1);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      if (is_within(guard, p, guard.tree.order[idx(i)])) return guard.tree.order[idx(i)];
  }
  return -1;
}

bool is_within_limit(DeviationGuard& guard, const std::array<Vec3, 3>& corners,
                     const std::array<std::int32_t, 3>& near) {
  const auto& [p, a, b] = corners;
  const double longest2 =
      std::max({(a - p).squaredNorm(), (b - p).squaredNorm(), (b - a).squaredNorm()});
  const double wanted = std::sqrt(longest2) / (kSampleSpacing * guard.limit);
  const int n =
      wanted < kMostDivisions ? std::max(2, static_cast<int>(std::ceil(wanted))) : kMostDivisions;
  for (int i = 0; i < n; ++i)  // i = n is the first corner
    for (int j = 0; j <= n - i; ++j) {
      const int k = n - i - j;
      if (i == 0 && (j == n || k == n)) continue;  // the other two
      const Vec3 x = (i * p + j * a + k * b) / n;
      if (find_within_limit(guard, x, near) < 0) return false;
    }
  return n != 2 || find_within_limit(guard, (p + a + b) / 3.0, near) >= 0;
}

}  // namespace thigma::detail
