#pragma once
// Depths of textured contacts in sessions against the fine meshes that their textures stand for.

#include "experiments/common/experiment.h"

namespace thigma::experiments::e10_depth_accuracy {

/// Adds claims and the table "fine" to an outcome.
void against_fine_meshes(const Context& context, Outcome& outcome);

}  // namespace thigma::experiments::e10_depth_accuracy
