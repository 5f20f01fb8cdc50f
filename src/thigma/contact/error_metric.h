#pragma once
// How much detail a contact deserves: error of a pair of levels, weighted by the size of the
// contact (Sec. 3.3-3.4).

#include "thigma/contact/resolution.h"

namespace thigma {

/// What a level of detail is at a contact.
struct LevelError {
  double deviation = 0.0;     // s: surface deviation from the original, both ways [m]
  double resolution = 0.0;    // r [1/m]; not read of free levels
  double support_area = 0.0;  // D at the contact [m^2]
  bool is_free = false;       // a level of merged hulls alone has no resolution
};

/// s*: feature size s / r^2, the larger of the two, over the support area. Infinite for a free
/// level and for an area of 0, unless the feature size is 0 too.
/// Thread    [contact].
/// Source    Eqs. 3.6-3.7.
double weighted_deviation(const LevelError& object, const LevelError& scene,
                          SupportArea area = SupportArea::larger) noexcept;

/// Surface deviation that is not seen (Eq. 3.8).
double view_threshold(const ViewThreshold& view) noexcept;  // [m]

}  // namespace thigma
