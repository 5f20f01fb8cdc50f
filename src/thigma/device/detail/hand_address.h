#pragma once
// The address of the simulated hand, "hand:?name=value&name=value"; parse_hand reads it.

#include <vector>

#include "thigma/device/hand.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {

/// What an address may set, with units, defaults and meanings.
std::vector<DeviceParameter> hand_parameters();

}  // namespace thigma::detail
