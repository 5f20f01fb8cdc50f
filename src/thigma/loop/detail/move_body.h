#pragma once
// Steps 2-4 of a frame: the object's motion under coupling and contacts, of any response.

#include <cstdint>
#include <limits>

#include "thigma/loop/haptic_step.h"

namespace thigma::detail {

/// How the terms of a model stand at a state.
struct ActiveTerms {
  std::int32_t count = 0;                                         // terms within reach
  double penetration = -std::numeric_limits<double>::infinity();  // deepest [m]
  double sunk = 0.0;  // how much deeper that one is than at the state the model was made for [m]
};

/// Moves the body over the frame; returns how the contacts stand after it.
/// Thread [haptic]; a state that is not finite latches a fault.
ActiveTerms move_body(const HapticParams& params, const HapticPorts& ports, HapticSample& sample,
                      HapticState& state) THIGMA_RT;

}  // namespace thigma::detail
