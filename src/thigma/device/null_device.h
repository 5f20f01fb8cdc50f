#pragma once
// A device that never moves: for scenes driven by other means and for tests.

#include <memory>

#include "thigma/device/haptic_device.h"

namespace thigma {

/// Handle at the identity for ever, clutch held or not; accepts every wrench.
/// Thread    [offline].
std::unique_ptr<HapticDevice> make_null_device(bool clutch = true, const DeviceLimits& limits = {});

}  // namespace thigma
