#pragma once
// Experiments on textured contacts that compare models, scenes and accuracy.

#include "experiments/common/experiment.h"

namespace thigma::experiments {

Outcome run_table_4_1(const Context& context);
Outcome run_hammer_on_torus(const Context& context);
Outcome run_e10_depth_accuracy(const Context& context);

}  // namespace thigma::experiments
