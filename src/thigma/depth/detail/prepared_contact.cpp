#include "thigma/depth/detail/prepared_contact.h"

#include <algorithm>
#include <cmath>

#include "thigma/depth/detail/climb.h"

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

// The frame and the texel; false where there is nothing to compute.
bool begin_contact(const DepthContact& contact, PreparedContact& prepared) noexcept {
  if (!is_usable(contact.object) || !is_usable(contact.scene)) return false;
  if (!contact.point.allFinite() || !contact.centre.allFinite()) return false;
  if (!is_direction(contact.normal)) return false;
  prepared.frame = contact_frame(contact.point, contact.normal);
  const double texel =
      std::min(relief_texel(*contact.object.texture), relief_texel(*contact.scene.texture));
  // no relief: a corner of one side may be the deepest place
  prepared.texel = std::isfinite(texel) ? texel : 0.0;
  return true;
}

PlaneBox shared_box(const PlaneBox& object, const PlaneBox& scene, double reach) noexcept {
  const Vec2 within = Vec2::Constant(reach);
  return intersection(intersection(object, scene), {-within, within});
}

}  // namespace

void project_sides(const DepthContact& contact, const ContactFrame& frame, const PlaneBox& over,
                   ProjectedPatch& object, ProjectedPatch& scene) noexcept {
  project_patch(contact.object, frame, Facing::along, object, over);
  project_patch(contact.scene, frame, Facing::against, scene, over);
}

double finer_texel(const DepthContact& contact) noexcept {
  return std::min(contact.object.texture->texel_size, contact.scene.texture->texel_size);
}

bool prepare_contact(const DepthContact& contact, PreparedContact& prepared) noexcept {
  if (!begin_contact(contact, prepared)) return false;
  project_sides(contact, prepared.frame, kWholePlane, prepared.object, prepared.scene);
  prepared.box = shared_box(prepared.object.box, prepared.scene.box, contact.reach);
  return !prepared.box.is_empty();
}

bool prepare_within_box(const DepthContact& contact, PreparedContact& prepared) noexcept {
  if (!begin_contact(contact, prepared)) return false;
  prepared.box =
      shared_box(patch_box(contact.object, prepared.frame, Facing::along),
                 patch_box(contact.scene, prepared.frame, Facing::against), contact.reach);
  if (prepared.box.is_empty()) return false;
  // Whether something hangs over a place is asked of a texel around it.
  const Vec2 around = Vec2::Constant(2.0 * prepared.texel);
  const PlaneBox over{prepared.box.low - around, prepared.box.high + around};
  project_sides(contact, prepared.frame, over, prepared.object, prepared.scene);
  return true;
}

void project_moved(const DepthContact& contact, const Pose& motion,
                   PreparedContact& prepared) noexcept {
  project_patch(
      {contact.object.texture, contact.object.triangles, motion * contact.object.world_from_body},
      prepared.frame, Facing::along, prepared.object);
}

double depth_at(const PreparedContact& prepared, const Vec2& at, NearTriangles& near) noexcept {
  const double object = height_at(prepared.object, at, near.object);
  if (object == kNoSurface) return kNoDepth;
  return object + height_at(prepared.scene, at, near.scene);
}

void bind_near(PreparedContact& prepared) noexcept {
  bind_surface(prepared.object, prepared.near_object);
  bind_surface(prepared.scene, prepared.near_scene);
  look_over(prepared.box, prepared.near_object);
  look_over(prepared.box, prepared.near_scene);
}

double depth_near(const PreparedContact& prepared, const Vec2& at, NearFeet& feet) noexcept {
  const double object = height_near(prepared.near_object, at, feet.object);
  if (object == kNoSurface) return kNoDepth;
  return object + height_near(prepared.near_scene, at, feet.scene);
}

double climb(const PreparedContact& prepared, const Vec2& spacing, Vec2& at) noexcept {
  constexpr double kFinest = 0.125;  // of a texel: finer tells facets of the interpolation
  const ClimbField field{prepared.object, prepared.scene,           prepared.box,
                         Vec2::Zero(),    kFinest * prepared.texel, -1.0};
  const auto depth = [&](const Vec2& there, NearFeet& feet) {
    return depth_near(prepared, there, feet);
  };
  NearFeet feet;
  const double found = Climb<NearFeet, decltype(depth)>(field, depth).run(spacing, {}, at, &feet);
  // What is near is within a billionth of the relief; what is given is the depth itself.
  NearTriangles near{feet.object.triangle, feet.scene.triangle};
  const double there = depth_at(prepared, at, near);
  return there == kNoDepth ? found : there;
}

bool is_upright(const PreparedContact& prepared, const Vec2& at) noexcept {
  const auto is_one = [&](const ProjectedPatch& patch) {
    const SurfaceJet jet = surface_jet(patch, at);
    return jet.is_height_field && !is_overhung(patch, at, jet.height, prepared.texel);
  };
  return is_one(prepared.object) && is_one(prepared.scene);
}

}  // namespace thigma::detail
