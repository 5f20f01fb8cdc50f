#pragma once
// Parts of a session's configuration that are set together: passivity, the direct, the constrained
// and the potential response.

#include "thigma/device/haptic_device.h"
#include "thigma/session/session.h"

namespace thigma {

/// Switches the controller on for the springs of this configuration and the delay that the device
/// tells of.
///
/// config  haptic.device filled in, or `device` given; coupling, response, workspace and rate set
/// Thread  [offline]; after use_direct_response, where that is used
void enable_passivity(const DeviceLimits& device, SessionConfig& config);

/// Takes over the stiffnesses of the coupling after they have changed; period and delay stay.
/// Thread  [haptic].
void retune_passivity(HapticParams& params) THIGMA_RT;

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

/// Makes a session's contacts inequalities: the object stays outside (docs/constraints.md).
/// Contacts are exact unless contact.resolution is not: then far ones may be coarse.
///
/// config    contact.object and contact.scene set; contact.constraints, haptic.constraint and
///           haptic.response are changed
/// errors    std::invalid_argument without surfaces and for contacts of another source
/// Thread    [offline]
void use_constraints(SessionConfig& config);

/// Makes a session's contacts the gradient of one energy (docs/potential.md): depths are those of
/// the exact surfaces, whatever resolution is set.
///
/// config    contact.object, contact.scene, contact.potential_law and contact.response set;
///           contact.potential and haptic.response are changed
/// errors    std::invalid_argument without surfaces, for contacts of another source, for relief,
///           and for a stiffness, exponent or area the law has not
/// Thread    [offline]
void use_potential(SessionConfig& config);

}  // namespace thigma
