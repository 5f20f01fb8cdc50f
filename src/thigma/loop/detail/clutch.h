#pragma once
// Taking hold of the object and letting it go.

#include "thigma/loop/haptic_step.h"

namespace thigma::detail {

/// The object is free, at rest, and forgets what held it.
/// Thread [haptic].
void let_go(HapticState& state) THIGMA_RT;

/// What the clutch of a device sample changes: grasped, let go, or a fault cleared.
/// is_usable  the sample may be believed
/// Thread     [haptic].
void follow_clutch(const HapticParams& params, const DeviceState& device, bool is_usable,
                   HapticState& state) THIGMA_RT;

}  // namespace thigma::detail
