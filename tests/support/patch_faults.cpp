#include "support/patch_faults.h"

#include <algorithm>
#include <numeric>

#include "thigma/convex/clip.h"
#include "thigma/convex/quickhull.h"
#include "thigma/convex/visit_triangles.h"
#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

const Vec3& corner(const PatchView& v, std::int32_t t, std::size_t k) {
  return v.mesh.positions[idx(v.mesh.triangles[idx(t)][k])];
}

void count_in_planes(const PatchView& v, PatchFaults& faults) {
  for (std::size_t i = 0; i < v.mesh.triangles.size(); ++i) {
    const auto t = static_cast<std::int32_t>(i);
    const std::int32_t patch = v.patch_of[i];
    if (patch < 0 || !(v.surface.height[i] > v.flat)) continue;  // slivers have no plane
    // Its own corners are on its plane, whatever the rounding of a sliver's normal says.
    const auto is_over = [&](const Vec3& p) {
      return v.surface.normal[i].dot(p - corner(v, t, 0)) > v.flat && p != corner(v, t, 1) &&
             p != corner(v, t, 2);
    };
    for (const std::int32_t other : v.surface.neighbor[i])
      faults.reflex_edges += other >= 0 && v.patch_of[idx(other)] == patch &&
                             (is_over(corner(v, other, 0)) || is_over(corner(v, other, 1)) ||
                              is_over(corner(v, other, 2)));
    const auto& points = v.points[idx(patch)];
    faults.off_hull += std::any_of(points.begin(), points.end(), is_over);
  }
}

/// Shell of each patch, -1 of those without triangles.
std::vector<std::int32_t> shells_of(const PatchView& v) {
  std::vector<std::int32_t> shells(v.points.size(), -1);
  for (std::size_t t = 0; t < v.patch_of.size(); ++t)
    if (v.patch_of[t] >= 0) shells[idx(v.patch_of[t])] = v.surface.shell[t];
  return shells;
}

}  // namespace

PatchFaults count_patch_faults(const PatchView& v) {
  PatchFaults faults;
  count_in_planes(v, faults);
  std::vector<std::int32_t> all(v.mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const TriangleTree tree = build_triangle_tree(v.mesh, std::move(all));
  const std::vector<std::int32_t> shells = shells_of(v);
  Quickhull hull;
  std::vector<HalfSpace> half_spaces;
  for (std::size_t p = 0; p < v.points.size(); ++p) {
    if (v.points[p].empty()) continue;
    TreeBox box{v.points[p][0], v.points[p][0]};
    for (const Vec3& x : v.points[p]) {
      box.min = box.min.cwiseMin(x);
      box.max = box.max.cwiseMax(x);
    }
    start_hull(hull, v.points[p], std::max(1e-10, v.flat / (box.max - box.min).norm()));
    if (hull.dimension < 3) continue;
    complete_hull(hull);
    list_half_spaces(hull, v.inset, half_spaces);
    bool is_entered = false;
    visit_triangles(tree, box, [&](std::int32_t t) {
      if (is_entered || v.patch_of[idx(t)] == static_cast<std::int32_t>(p) ||
          v.surface.shell[idx(t)] != shells[p] || v.surface.height[idx(t)] <= 0.0)
        return;
      std::array<Vec3, 3> c;
      for (std::size_t k = 0; k < 3; ++k) c[k] = (corner(v, t, k) - hull.origin) * hull.scale;
      is_entered = reaches_into(c, half_spaces);
    });
    faults.protruding_patches += is_entered;
  }
  return faults;
}

}  // namespace thigma::detail
