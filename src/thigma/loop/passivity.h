#pragma once
// Energy observer at the device port: does the rendered world give more than it got?

#include "thigma/core/rt.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Energy the hand has put into the rendered world, exact for a wrench held constant over each
/// tick: E_k = -sum f_j . (x_{j+1} - x_j) + t_j . rotvec(q_{j+1} q_j^-1), which is what a sampled
/// port exchanges, with no numerical velocity in it. A passive world never gives back more than it
/// got: E >= 0.
struct EnergyObserver {
  bool has_sample = false;
  Pose last;                // of the handle [device frame]
  Wrench held;              // sent at `last`, on the hand about the handle [device frame]
  double energy = 0.0;      // E [J]
  double energy_min = 0.0;  // smallest so far, <= 0 [J]
};

/// Accounts for the wrench held since the last sample. Call with every pose of the handle, before
/// the new wrench is known: the true one where the device is simulated, else the one it senses.
/// Thread [haptic].
void observe_motion(EnergyObserver& observer, const Pose& handle) THIGMA_RT;

/// The wrench held from now on. Thread [haptic].
void observe_wrench(EnergyObserver& observer, const Wrench& sent) THIGMA_RT;

}  // namespace thigma
