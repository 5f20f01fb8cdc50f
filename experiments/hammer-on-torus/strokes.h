#pragma once
// The hammer led around the torus at constant speed, with relief, without it, and without textures.

#include "experiments/common/experiment.h"

namespace thigma::experiments::hammer_on_torus {

/// Adds the table "strokes", a panel and the claims on what the relief adds to the force.
/// Thread [offline]; deterministic.
void add_strokes(const Context& context, Outcome& outcome);

}  // namespace thigma::experiments::hammer_on_torus
