#include "experiments/level-choice/tree_ranges.h"

#include "thigma/core/index.h"

namespace thigma::experiments::level_choice {
namespace {

double area_of(const HullView& view) {
  double area = 0.0;
  for (int t = 0; t < view.triangle_count; ++t) {
    const auto& corner = view.triangles[t].corner;
    const Vec3 &a = view.vertices[corner[0]], &b = view.vertices[corner[1]],
               &c = view.vertices[corner[2]];
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

}  // namespace

TreeRanges tree_ranges(const ClodHierarchy& h) {
  TreeRanges ranges;
  ranges.first.assign(h.nodes.size(), -1);
  ranges.last.assign(h.nodes.size(), -1);
  ranges.triangles.assign(h.nodes.size(), 0.0);
  std::vector<std::int32_t> stack{0};
  while (!stack.empty()) {
    const std::int32_t i = stack.back();
    const ClodNode& node = h.nodes[idx(i)];
    if (ranges.first[idx(i)] < 0) {  // on the way down
      ranges.first[idx(i)] = static_cast<std::int32_t>(ranges.area.size());
      for (std::int32_t c = 0; c < node.child_count; ++c) stack.push_back(node.first_child + c);
      if (node.child_count > 0) continue;
      const HullView view = hull_view(h, i);
      ranges.area.push_back(area_of(view));
      ranges.triangles[idx(i)] = view.triangle_count;
    }
    for (std::int32_t c = 0; c < node.child_count; ++c)
      ranges.triangles[idx(i)] += ranges.triangles[idx(node.first_child + c)];
    ranges.last[idx(i)] = static_cast<std::int32_t>(ranges.area.size());
    stack.pop_back();
  }
  return ranges;
}

}  // namespace thigma::experiments::level_choice
