#include "thigma/clod/detail/parents.h"

#include <algorithm>
#include <limits>

#include "thigma/convex/quickhull.h"
#include "thigma/core/index.h"
#include "thigma/core/parallel.h"
#include "thigma/mesh/box_tree.h"

namespace thigma::detail {
namespace {

/// Largest distance of the points from the triangles of a patch; stops once it exceeds the limit.
double distance_from(const std::vector<Vec3>& points, const TriangleMesh& level,
                     const std::vector<std::int32_t>& triangles, double limit) {
  double largest = 0.0;
  for (const Vec3& p : points) {
    double distance = std::numeric_limits<double>::infinity();
    for (const std::int32_t t : triangles) {
      const auto& v = level.triangles[idx(t)];
      const Vec3 &a = level.positions[idx(v[0])], &b = level.positions[idx(v[1])],
                 &c = level.positions[idx(v[2])];
      const TreeBox box{a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
      if (squared_distance(box, p) > kFarther * distance * distance) continue;
      distance = std::min(distance, point_triangle_distance(p, a, b, c));
    }
    largest = std::max(largest, distance);
    if (largest > limit) break;
  }
  return largest;
}

std::vector<TreeBox> boxes_of(const TriangleMesh& level, const LevelPatches& patches) {
  std::vector<TreeBox> boxes;
  for (const auto& vertices : patches.vertices) {
    TreeBox box{level.positions[idx(vertices[0])], level.positions[idx(vertices[0])]};
    for (const std::int32_t v : vertices) {
      box.min = box.min.cwiseMin(level.positions[idx(v)]);
      box.max = box.max.cwiseMax(level.positions[idx(v)]);
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// The patch from which the points are least far. guess: one that may be.
std::int32_t nearest_patch(const std::vector<Vec3>& points, const BoxTree& near,
                           const TriangleMesh& level, const LevelPatches& patches,
                           std::int32_t guess) {
  std::int32_t best = guess;
  double least = distance_from(points, level, patches.triangles[idx(best)],
                               std::numeric_limits<double>::infinity());
  // Nearer patches reach within `least` of every point, so of the first.
  const Vec3 reach = Vec3::Constant(least);
  near.visit({points[0] - reach, points[0] + reach}, [&](std::int32_t patch) {
    const double distance = distance_from(points, level, patches.triangles[idx(patch)], least);
    if (distance > least || (distance == least && patch >= best)) return;
    least = distance;
    best = patch;
  });
  return best;
}

}  // namespace

std::vector<std::int32_t> nearest_parents(const DraftTree& tree,
                                          const std::vector<std::int32_t>& draft_of_patch,
                                          const std::vector<std::int32_t>& successor,
                                          const TriangleMesh& level, const LevelPatches& patches,
                                          int threads) {
  BoxTree near;
  near.build(boxes_of(level, patches));
  std::vector<std::int32_t> parent(draft_of_patch.size(), -1);
  for_each_range(parent.size(), threads, [&](std::size_t begin, std::size_t end) {
    const BoxTree own = near;  // of one search at a time
    for (std::size_t i = begin; i < end; ++i)
      if (draft_of_patch[i] >= 0)
        parent[i] = nearest_patch(tree.drafts[idx(draft_of_patch[i])].points, own, level, patches,
                                  successor[i]);
  });
  return parent;
}

}  // namespace thigma::detail
