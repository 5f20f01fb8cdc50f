#pragma once
// How the depth at a place changes as the object goes along the plane.

#include <array>

#include "thigma/depth/depth_peak.h"
#include "thigma/depth/detail/near_surface.h"

namespace thigma::detail {

/// Both sides of a contact as climbs see them.
struct PeakField {
  NearSurface object, scene;
  PlaneBox reach;      // nothing beyond counts [m; contact plane]
  double texel = 0.0;  // of the finer side that has relief [m]
  double flat = 0.0;   // by which depths may be too small [m]
};

/// Depth at a place with the object moved along the plane [m]; kNoDepth where a side does not lie.
double depth_of(const PeakField& field, const Vec2& shift, const Vec2& at, NearFeet& feet) noexcept;

/// Climbs to a local maximum with the object moved, within a way.
///
/// spacing  of the first steps, twice [m]
/// at       start and result
/// feet     where to look first
/// returns  the depth there
/// Thread   [contact]; no failure.
double climb_moved(PeakField& field, const Vec2& shift, double spacing, double within,
                   const NearFeet& feet, Vec2& at) noexcept;

/// The object's ways that a shape is fitted to.
inline constexpr int kRing = 8;
Vec2 on_ring(int i) noexcept;

/// Depths about a place: the largest beside it with the object moved.
struct Around {
  std::array<double, kRing> ring{};      // on a ring of ways
  std::array<double, kRing / 2> half{};  // half of every other way
};

/// Looks at a place with the object moved. Where the surfaces bend tells where the deepest place
/// goes; it is compared with those that stay with the scene and that go with the object. Where a
/// side ends it is climbed to.
///
/// radius  of the ring [m]
/// Thread  [contact]; no failure.
void look_about(PeakField& field, const DepthPeak& peak, double radius, Around& around) noexcept;

/// Slope and bend through the depth at the peak and as near as can be to those of a ring: the first
/// three pairs of a Fourier series.
void fit_shape(const Around& around, double radius, DepthPeak& peak) noexcept;

/// Depth by the shape of a peak after a way.
inline double shape_at(const DepthPeak& peak, const Vec2& way) noexcept {
  return peak.depth + peak.slope.dot(way) + 0.5 * way.dot(peak.bend * way);
}

}  // namespace thigma::detail
