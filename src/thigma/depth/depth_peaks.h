#pragma once
// Where two textured patches are nearest to each other, place by place, and how the depth there
// changes as the object moves: what inequalities are made of.

#include <memory>

#include "thigma/core/static_vector.h"
#include "thigma/depth/depth.h"

namespace thigma {

/// Peaks of one contact: the deepest of more.
inline constexpr std::size_t kMaxPeaks = 64;

/// A local maximum of the depth over the plane of a contact. For a way w of the object along the
/// plane (u, v) and a way h along n, neither turning, the depth of the place it moves to is
/// depth + h + slope . w + 1/2 w . bend w, as far as `travel`.
struct DepthPeak {
  Vec2 at = Vec2::Zero();  // [m; contact plane]
  double depth = kNoDepth;
  Vec3 object_point = Vec3::Zero();  // of its fine surface there [m; contact frame]
  Vec2 slope = Vec2::Zero();         // [-]
  Mat2 bend = Mat2::Zero();          // [1/m]
  double travel = 0.0;               // ways the shape was fitted to, half a texel at least [m]
};

struct PeakRequest {
  double least = 0.0;   // depth below which no peak counts [m]
  double near = 0.0;    // depth from which on shapes have to hold; below, none is checked [m]
  double travel = 0.0;  // way that shapes are wanted for, > 0 [m]
  double turn = 0.0;    // by which the object may turn on it [rad]
  // shapes that leave out more are fitted to half the way, down to least_travel [m]
  double error = 0.0, least_travel = 0.0;
};

/// What a search found beside the peaks.
struct PeakStats {
  bool is_found = false;        // the patches have a common domain
  bool is_height_field = true;  // false: of DepthSamples, at the deepest peak
  bool is_coarse = false;       // samples lay farther apart than two texels of the finer side
  std::int32_t left_out = 0;    // peaks for want of room
  double travel = 0.0;          // as far as shapes hold, or least_travel [m]
  // by how much a depth on a way of `travel` or half of it was above all shapes, at most [m]
  double excess = 0.0;
};

using DepthPeaks = StaticVector<DepthPeak, kMaxPeaks>;

/// Searches one contact after the other. Thread: one at a time; holds scratch memory.
class PeakSearch {
 public:
  PeakSearch() = default;
  PeakSearch(const PeakSearch&) = delete;
  PeakSearch& operator=(const PeakSearch&) = delete;
  virtual ~PeakSearch() = default;

  /// Peaks of a contact, deepest first: both fine surfaces as height maps over the part of the
  /// domain where they may be as near as `least`; maxima among neighbouring samples, or what a
  /// turn may make one, the outermost of each block of them; from each the climb of the directional depth. Shapes are fitted to
  /// eight climbs about the peak with the object moved along the plane.
  ///
  /// contact   normal of unit length to 1e-9; textures alive and unchanged
  /// peaks     overwritten
  /// Thread    [contact]; no failure; allocates where a contact is larger than any before.
  /// Source    Eq. 4.10, the maximum taken place by place.
  virtual PeakStats find(const DepthContact& contact, const PeakRequest& request,
                         DepthPeaks& peaks) noexcept = 0;
};

/// Thread    [offline]; throws std::bad_alloc.
std::unique_ptr<PeakSearch> make_peak_search();

}  // namespace thigma
