#pragma once
// A place where two textured patches are nearest, and how the depth there changes.

#include "thigma/core/static_vector.h"
#include "thigma/depth/depth.h"

namespace thigma {

/// Peaks of one contact: the deepest of more.
inline constexpr std::size_t kMaxPeaks = 160;

/// A local maximum of the depth over the plane of a contact, or a place that becomes one as the
/// object goes along the plane. For a way w of the object along it (u, v) and a way h along n,
/// neither turning, the depth of the place it moves to is depth + h + slope . w + 1/2 w . bend w,
/// as far as `travel`.
struct DepthPeak {
  Vec2 at = Vec2::Zero();  // [m; contact plane]
  double depth = kNoDepth;
  Vec3 object_point = Vec3::Zero();  // of its fine surface there [m; contact frame]
  Vec2 slope = Vec2::Zero();         // [-]
  Mat2 bend = Mat2::Zero();          // [1/m]
  double travel = 0.0;               // ways the shape was fitted to, half a texel at least [m]
};

using DepthPeaks = StaticVector<DepthPeak, kMaxPeaks>;

}  // namespace thigma
