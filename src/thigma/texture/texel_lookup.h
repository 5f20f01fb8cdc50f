#pragma once
// Reading a texture between its texels, in double precision.

#include "thigma/texture/haptic_texture.h"

namespace thigma {

/// Bilinear displacement at texture coordinates, clamped to the outermost texel centres [m; body
/// frame].
/// Thread    [contact]; no failure.
Vec3 displacement_at(const HapticTexture& texture, const Vec2& at) noexcept;

/// The same with its own derivatives, which jump between texels [m, m/texel; body frame].
struct TexelFacet {
  Vec3 value = Vec3::Zero(), by_x = Vec3::Zero(), by_y = Vec3::Zero();
};
TexelFacet texel_facet(const HapticTexture& texture, const Vec2& at) noexcept;

/// Displacement and its derivatives by the texture coordinates [m, m/texel, m/texel^2; body frame].
struct TexelJet {
  Vec3 value = Vec3::Zero();       // bilinear, as displacement_at
  Vec3 facet_by_x = Vec3::Zero();  // derivative of `value` itself: jumps between texels
  Vec3 facet_by_y = Vec3::Zero();
  // central differences at the four texels around, interpolated: continuous
  Vec3 by_x = Vec3::Zero();
  Vec3 by_y = Vec3::Zero();
  Vec3 by_xx = Vec3::Zero();  // second differences, interpolated
  Vec3 by_xy = Vec3::Zero();  // of the four texels around
  Vec3 by_yy = Vec3::Zero();
};

/// Value and tangents at once.
/// Thread    [contact]; no failure. Differences are one-sided, and second ones 0, at the border of
///           the map.
TexelJet texel_jet(const HapticTexture& texture, const Vec2& at) noexcept;

}  // namespace thigma
