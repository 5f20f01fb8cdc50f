#include "experiments/level-choice/touched_region.h"

#include <map>
#include <tuple>

#include "thigma/core/index.h"

namespace thigma::experiments::level_choice {
namespace {

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[idx(i)] != i) i = parent[idx(i)] = parent[idx(parent[idx(i)])];
  return i;
}

}  // namespace

PatchCorners patch_corners(const ClodHierarchy& h, const TreeRanges& tree) {
  PatchCorners surface;
  surface.corners.resize(tree.area.size());
  std::map<std::tuple<double, double, double>, std::int32_t> known;
  for (const ClodPatch& patch : h.patches) {
    const HullView view = hull_view(h, patch.node);
    std::vector<std::int32_t>& corners = surface.corners[idx(tree.first[idx(patch.node)])];
    for (int v = 0; v < view.vertex_count; ++v) {
      const Vec3& p = view.vertices[v];
      const auto place = known.try_emplace({p.x(), p.y(), p.z()}, surface.count);
      if (place.second) ++surface.count;
      corners.push_back(place.first->second);
    }
  }
  return surface;
}

std::vector<double> region_areas(const PatchCorners& surface, const TreeRanges& tree,
                                 const std::vector<std::int32_t>& touched) {
  // Corners are joined by the patches between them.
  std::vector<std::int32_t> parent(idx(surface.count));
  for (std::int32_t i = 0; i < surface.count; ++i) parent[idx(i)] = i;
  std::vector<bool> is_touched(tree.area.size(), false);
  for (const std::int32_t patch : touched) {
    is_touched[idx(patch)] = true;
    const std::vector<std::int32_t>& corners = surface.corners[idx(patch)];
    for (const std::int32_t corner : corners)
      parent[idx(root_of(parent, corner))] = root_of(parent, corners.front());
  }
  std::vector<double> area(idx(surface.count), 0.0);
  const auto region = [&](std::size_t patch) {
    return idx(root_of(parent, surface.corners[patch].front()));
  };
  for (std::size_t p = 0; p < is_touched.size(); ++p)
    if (is_touched[p]) area[region(p)] += tree.area[p];
  std::vector<double> areas;
  for (const std::int32_t patch : touched) areas.push_back(area[region(idx(patch))]);
  return areas;
}

}  // namespace thigma::experiments::level_choice
