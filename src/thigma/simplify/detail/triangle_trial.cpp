#include "thigma/simplify/detail/triangle_trial.h"

#include <cmath>

#include "thigma/core/index.h"
#include "thigma/mesh/triangles_meet.h"

namespace thigma::detail {
namespace {}  // namespace

double triangle_quality(const std::array<Vec3, 3>& c) {
  const Vec3 ab = c[1] - c[0], ac = c[2] - c[0];
  const double sum = ab.squaredNorm() + ac.squaredNorm() + (ac - ab).squaredNorm();
  return sum > 0.0 ? 2.0 * std::sqrt(3.0) * ab.cross(ac).norm() / sum : 0.0;
}

int count_crossings(const PatchedSurface& surface, const std::array<std::int32_t, 2>& triangles) {
  int crossings = 0;
  for (const std::int32_t own : triangles) {
    if (surface.height[idx(own)] <= 0.0) continue;
    const std::int32_t shell = surface.patches[idx(surface.patch_of[idx(own)])].shell;
    const TreeBox& box = surface.box[idx(own)];
    surface.tree.visit(box, [&](std::int32_t patch) {
      const SurfacePatch& p = surface.patches[idx(patch)];
      if (p.shell != shell || !p.box.overlaps(box)) return;
      for (const std::int32_t t : p.triangles) {
        if (t == triangles[0] || t == triangles[1] || surface.height[idx(t)] <= 0.0) continue;
        crossings += surface.box[idx(t)].overlaps(box) &&
                     triangles_meet(surface.mesh.positions, surface.mesh.triangles[idx(own)],
                                    surface.mesh.triangles[idx(t)]);
      }
    });
  }
  return crossings;
}

}  // namespace thigma::detail
