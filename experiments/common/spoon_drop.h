#pragma once
// A spoon that falls into a cup, bowl first and leaning (Sec. 3.5.4).

#include "experiments/common/assets.h"

#include "thigma/simulation/simulate.h"

namespace thigma::experiments {

/// The world and where the spoon is let go.
struct SpoonDrop {
  SimulationWorld world;  // exact, d = radius / 1000
  SimulationState start;  // at rest, the tip of the bowl over the rim
  double radius = 0.0;    // the smaller of the two [m]
};

/// triangles  0: the models' own counts, otherwise of each
/// gravity    [m/s^2]
/// Thread     [offline].
SpoonDrop spoon_drop(Assets& assets, int triangles = 0, double gravity = 9.81);

}  // namespace thigma::experiments
