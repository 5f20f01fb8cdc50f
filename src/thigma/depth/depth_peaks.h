#pragma once
// Where two textured patches are nearest to each other, place by place, and how the depth there
// changes as the object moves: what inequalities are made of.

#include <array>
#include <vector>

#include "thigma/depth/depth_peak.h"
#include "thigma/depth/detail/peak_maps.h"
#include "thigma/depth/detail/peak_shape.h"

namespace thigma {

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

/// Working memory: grows while warming up, never after. Any content is valid.
struct PeakScratch {
  detail::PreparedContact prepared;
  detail::PeakMaps maps;
  detail::PeakField field;
  std::vector<detail::Summit> summits;
  std::array<detail::Around, kMaxPeaks> around;
};

/// Room for any number of samples and summits. Thread [offline]; throws std::bad_alloc.
void reserve_peaks(PeakScratch& scratch);

/// Peaks of a contact, deepest first: both fine surfaces as height maps over the part of the domain
/// where they may be as near as `least`; maxima among neighbouring samples, or what a turn or a way
/// along the plane may make one, the outermost of each block of them; from each the climb of the
/// directional depth. Shapes are fitted to the depths beside the peak with the object moved along
/// the plane.
///
/// contact   normal of unit length to 1e-9; textures alive and unchanged
/// peaks     overwritten
/// Thread    [contact]; no failure; allocates where a contact is larger than any before.
/// Source    Eq. 4.10, the maximum taken place by place.
PeakStats find_peaks(const DepthContact& contact, const PeakRequest& request, PeakScratch& scratch,
                     DepthPeaks& peaks) noexcept;

}  // namespace thigma
