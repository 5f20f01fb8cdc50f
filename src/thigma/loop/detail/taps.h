#pragma once
// Taps: what the hand feels of an impact beyond the coupling, a force that rings and dies away.

#include "thigma/core/rt.h"
#include "thigma/loop/haptic_step.h"

namespace thigma::detail {

/// Adds what an impact rings like; nothing where the pair has no amplitude.
///
/// handle    of the hand in the scene [m; world]
/// centre    of the body's mass [m; world]
/// Thread    [haptic]; no failure.
void start_tap(const Impact& impact, const Tap& tap, const Vec3& centre, const Vec3& handle,
               TapState& taps) THIGMA_RT;

/// The taps' wrench on the hand for the coming step: for each impact
/// -n A v e^(-t / decay) sin(2 pi f t) at the place of contact.
///
/// moved     way and turn of the handle since the last step [m, rad; world]
/// elapsed   time since the last step [s]
/// returns   force and torque about the handle [N, N m; world]. Silence once the hand has been
///           handed more than the store had
/// Thread    [haptic]; no failure, nothing allocated.
/// Source    Kuchenbecker, Fiene and Niemeyer (2006): event-based haptics, decaying sinusoids
///           scaled by the speed of the impact.
Wrench next_taps(const Vec6& moved, double elapsed, TapState& taps) THIGMA_RT;

}  // namespace thigma::detail
