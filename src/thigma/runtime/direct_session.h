#pragma once
// Setting a session up for the direct response.

#include "thigma/device/haptic_device.h"
#include "thigma/runtime/session.h"

namespace thigma {

/// Makes a session render contacts straight to the hand: the response of the haptic frames, and
/// contact stiffness and tolerance by what the device renders best (response/direct.h). Safety
/// limits below the device's count.
///
/// device  limits of the device in use
/// config  workspace and safety set; contact.tolerance, contact.response and haptic.response are
///         changed
/// errors  std::invalid_argument for a device without force or stiffness
/// Thread  [offline]
void use_direct_response(const DeviceLimits& device, SessionConfig& config);

}  // namespace thigma
