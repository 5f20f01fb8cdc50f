#pragma once
// Offset surfaces: the depth of a round probe in a relief is the height of the surface its centre
// traces (Sec. 4.2.1).

#include "thigma/core/rt.h"

namespace thigma {

/// Depth of a probe and its slope by the probe's place.
struct OffsetHeight {
  double height = 0.0;  // [m]
  // d height/du [-]; at a cusp, where two flanks touch at once, that of one of them
  double slope = 0.0;
};

/// Height that a disk of radius R has to be lifted from resting on the mean line of a cos(2 pi x /
/// lambda) at u: max over |s| <= R of a cos(2 pi (u + s) / lambda) + sqrt(R^2 - s^2), minus R.
///
/// radius, wavelength  > 0 [m]
/// amplitude           a, of either sign [m]
/// at                  u [m]
/// returns   to rounding; not a number when an argument is none or out of range
/// Thread    [offline]; time grows with R / lambda.
/// Source    Sec. 4.2.1 and Fig. 4.7, in closed form but for the maximum.
OffsetHeight disk_on_wave(double radius, double amplitude, double wavelength, double at) noexcept;

}  // namespace thigma
