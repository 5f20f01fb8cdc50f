#pragma once
// What levels of detail far away cost and buy under constraints, over s0.

#include "experiments/common/experiment.h"

namespace thigma::experiments::never_enters {

/// Adds the table `levels` and its claims.
void play_levels(const Context& context, Outcome& outcome);

}  // namespace thigma::experiments::never_enters
