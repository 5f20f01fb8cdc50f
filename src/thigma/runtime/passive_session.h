#pragma once
// Setting a session up with the passivity controller.

#include "thigma/runtime/session.h"

namespace thigma {

/// Switches the controller on for the springs of this configuration and the delay that the device
/// tells of.
///
/// config  haptic.device filled in, or `device` given; coupling, response, workspace and rate set
/// Thread  [offline]; after use_direct_response, where that is used
void use_passivity(const DeviceLimits& device, SessionConfig& config);

/// Takes over the stiffnesses of the coupling after they have changed; period and delay stay.
/// Thread  [haptic].
void retune_passivity(HapticParams& params) THIGMA_RT;

}  // namespace thigma
