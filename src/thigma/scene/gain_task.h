#pragma once
// What gains have to be for: the device of an address, and an object in its hand.

#include <string>

#include "thigma/device/haptic_device.h"
#include "thigma/dynamics/gains.h"
#include "thigma/scene/scene_description.h"

namespace thigma {

/// A device as far as its address tells; nothing is plugged in or moved for it.
struct DevicePort {
  std::string name;
  DeviceLimits limits;
  PortHalf linear, angular;  // of a simulated hand all is known, of others the limits alone
  double delay = 0.0;        // of samples, at most [s]
};

/// errors   DeviceAddressError, DeviceUnavailable, InputError as open_device
/// Thread   [offline].
DevicePort describe_device(const std::string& uri);

/// Gains of this body in that device, with that response.
GainTask gain_task(const DevicePort& port, const RigidBody& body, const Workspace& workspace,
                   double rate, ResponseKind response = ResponseKind::coupled);

/// Fills in what a scene leaves open of coupling and contact: proposed stiffnesses with their
/// critical dampings, and where the springs level off. What the scene says stays.
void fill_gains(const GainProposal& proposal, SceneDescription& scene);

}  // namespace thigma
