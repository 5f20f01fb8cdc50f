#include "thigma/texture/detail/prepared_contact.h"

#include <algorithm>
#include <cmath>

namespace thigma::detail {
namespace {

bool is_usable(const TexturedPatch& patch) noexcept {
  // Squares of what is computed with these have to stay numbers.
  constexpr double kFarthest = 1e100;
  const Vec3& p = patch.world_from_body.position;
  return patch.texture && (p.array().abs() < kFarthest).all() &&
         patch.world_from_body.orientation.coeffs().allFinite();
}

bool is_direction(const Vec3& v) noexcept {
  const double square = v.squaredNorm();
  return square > 0.5 && square < 2.0;
}

double relief_texel(const HapticTexture& texture) noexcept {
  return texture.amplitude > 0.0 ? texture.texel_size : std::numeric_limits<double>::infinity();
}

}  // namespace

bool prepare_contact(const DepthContact& contact, PreparedContact& prepared) noexcept {
  if (!is_usable(contact.object) || !is_usable(contact.scene)) return false;
  if (!contact.point.allFinite() || !contact.centre.allFinite()) return false;
  if (!is_direction(contact.normal)) return false;
  prepared.frame = contact_frame(contact.point, contact.normal);
  project_patch(*contact.object.texture, contact.object.triangles, contact.object.world_from_body,
                prepared.frame, Facing::along, prepared.object);
  project_patch(*contact.scene.texture, contact.scene.triangles, contact.scene.world_from_body,
                prepared.frame, Facing::against, prepared.scene);
  const Vec2 reach = Vec2::Constant(contact.reach);
  prepared.box =
      intersection(intersection(prepared.object.box, prepared.scene.box), {-reach, reach});
  if (prepared.box.is_empty()) return false;
  prepared.is_height_field = is_height_field(prepared.object, prepared.box) &&
                             is_height_field(prepared.scene, prepared.box);
  prepared.texel =
      std::min(relief_texel(*contact.object.texture), relief_texel(*contact.scene.texture));
  return true;
}

void project_moved(const DepthContact& contact, const Pose& motion,
                   PreparedContact& prepared) noexcept {
  project_patch(*contact.object.texture, contact.object.triangles,
                motion * contact.object.world_from_body, prepared.frame, Facing::along,
                prepared.object);
}

double depth_at(const PreparedContact& prepared, const Vec2& at, NearTriangles& near) noexcept {
  const double object = height_at(prepared.object, at, near.object);
  if (object == kNoSurface) return kNoDepth;
  return object + height_at(prepared.scene, at, near.scene);
}

double climb(const PreparedContact& prepared, const Vec2& spacing, Vec2& at) noexcept {
  constexpr int kMostHalvings = 24;
  constexpr double kFinest =
      0.125;  // of a texel: finer tells facets of the interpolation, not the surface
  NearTriangles near;
  double best = depth_at(prepared, at, near);
  Vec2 step = spacing;
  for (int k = 0; k < kMostHalvings && step.minCoeff() > kFinest * prepared.texel; ++k) {
    step *= 0.5;
    const Vec2 centre = at;
    for (int i = 0; i < 9; ++i) {
      if (i == 4) continue;
      const Vec2 to = (centre + step.cwiseProduct(Vec2(i % 3 - 1, i / 3 - 1)))
                          .cwiseMax(prepared.box.low)
                          .cwiseMin(prepared.box.high);
      const double depth = depth_at(prepared, to, near);
      if (depth > best) {
        best = depth;
        at = to;
      }
    }
  }
  return best;
}

bool is_upright(const PreparedContact& prepared, const Vec2& at) noexcept {
  return surface_jet(prepared.object, at).is_height_field &&
         surface_jet(prepared.scene, at).is_height_field;
}

}  // namespace thigma::detail
