#pragma once
// What does not depend on how surfaces are divided, and what follows the coupling's law.

#include "experiments/common/experiment.h"

namespace thigma::experiments {

/// Spread of the force over divisions, triangulations, places and yaws, force over travel and over
/// contacts: rows in outcome.tables[1] and [2], curves in the first panel, and their claims.
/// Thread [offline]
void run_presses(const Context& context, Outcome& outcome);

}  // namespace thigma::experiments
