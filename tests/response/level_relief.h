#pragma once
// A ball with levels of detail and a texture over each, and a plain box.

#include <vector>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_asset.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/texture/bake.h"
#include "thigma/texture/level_textures.h"

namespace thigma::test {

inline constexpr double kRadius = 0.03, kTolerance = 2e-4;

/// A ball with bumps that its coarse levels do not have.
inline TriangleMesh bumpy_ball() {
  TriangleMesh mesh = make_ball(kRadius, 20);
  for (Vec3& p : mesh.positions) {
    const Vec3 n = p / kRadius;
    p *= 1.0 +
         0.05 *
             (5.0 * n.x() * n.y() * n.z() + 3.0 * (n.x() * n.x() - n.y() * n.y()) * (n.z() + 0.3)) +
         0.004 * sine(12.0 * n.x()) * sine(12.0 * n.y()) * sine(12.0 * n.z());
  }
  return mesh;
}

/// The ball with its textures, over a plain box; once for all tests.
struct LevelRelief {
  ClodAsset ball = build_clod_asset(bumpy_ball());
  LevelTextures relief{
      bake_levels(ball.meshes[0], ball.meshes, {.texels = 256, .samples = 4000}, "ball")};
  TriangleMesh box_mesh = make_box({0.2, 0.2, 0.02});
  ClodHierarchy box = build_exact_hierarchy(box_mesh);
  std::vector<HapticTexture> plain;
  HapticTexture of_box = make_plain_texture(box_mesh, "box");
  std::vector<const HapticTexture*> of_ball;

  LevelRelief() {
    plain.reserve(ball.meshes.size());
    for (std::size_t k = 0; k < ball.meshes.size(); ++k) {
      if (!relief.levels[k]) plain.push_back(make_plain_texture(ball.meshes[k], "ball"));
      of_ball.push_back(relief.levels[k] ? &relief.levels[k]->texture : &plain.back());
    }
  }
  /// By how much textured and original surface differ, as sampled, and rounding [m].
  double fit(std::int32_t level) const {
    const auto& asset = relief.levels[static_cast<std::size_t>(level)];
    return 1e-6 * kRadius + (asset ? *asset->figures.fit_error_max : 0.0);
  }
};

inline const LevelRelief& level_relief() {
  static const LevelRelief made;
  return made;
}

}  // namespace thigma::test
