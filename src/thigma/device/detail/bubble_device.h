#pragma once
// A small workspace in a large scene: inside a bubble the handle stands for a place, outside it for
// a velocity. `dhd:0?bubble=0.04`. After Dominjon, Lecuyer, Burkhardt, Andrade-Barroso, Richir, The
// "Bubble" Technique, World Haptics 2005.

#include <memory>

#include "thigma/device/haptic_device.h"

namespace thigma::detail {

inline constexpr double kLeastBubble = 0.005, kMostBubble = 0.5;  // radii [m]

/// The device in a bubble about where the hand took hold last; while it holds, the place drifts by
/// five times a second of what the handle is outside, at most 0.2 m/s, in that direction. The
/// border is not felt: what is sent is what the safety layer let pass. Velocities agree with the
/// motion.
///
/// radius   [m; device space], kLeastBubble to kMostBubble
/// Thread   [offline].
std::unique_ptr<HapticDevice> make_bubble_device(std::unique_ptr<HapticDevice> device,
                                                 double radius);

}  // namespace thigma::detail
