#pragma once
// Steps 5 and 6 of a frame: what the hand gets, within the limits.

#include "thigma/loop/detail/move_body.h"

namespace thigma::detail {

/// What a frame works on.
struct FrameWork {
  const HapticParams& params;
  const HapticPorts& ports;
  const LinearContactModel& model;
  HapticState& state;
  HapticSample& sample;
};

/// Computes the wrench, limits it, makes it passive where that is on, and writes it.
/// Thread [haptic].
void send_wrench(const FrameWork& frame, const ActiveTerms& active) THIGMA_RT;

}  // namespace thigma::detail
