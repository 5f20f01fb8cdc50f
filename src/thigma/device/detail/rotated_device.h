#pragma once
// A device that senses no rotation, with a second one for it: `dhd:0?rotation=spacenav:`.

#include <memory>

#include "thigma/device/haptic_device.h"

namespace thigma::detail {

/// The first device, with orientation and angular velocity of the second. A second one that is lost
/// turns no more, and is told of; what the first one feels goes on.
///
/// errors   DeviceAddressError: the first senses rotation itself, or the second senses none or has
///          motors, or owns the clock
/// Thread   [offline].
std::unique_ptr<HapticDevice> make_rotated_device(std::unique_ptr<HapticDevice> place,
                                                  std::unique_ptr<HapticDevice> turn);

}  // namespace thigma::detail
