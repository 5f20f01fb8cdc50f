#pragma once
// A device with a second one beside it that moves the view: `dhd:0?camera=spacenav:`.

#include <memory>

#include "thigma/device/haptic_device.h"

namespace thigma::detail {

/// The first device, whose samples also tell where the second one's handle is
/// (DeviceState::camera). A second one that is lost moves the view no more, and is told of; what
/// the first one feels goes on.
///
/// errors   DeviceAddressError: the second one has motors, or owns the clock
/// Thread   [offline].
std::unique_ptr<HapticDevice> make_camera_device(std::unique_ptr<HapticDevice> held,
                                                 std::unique_ptr<HapticDevice> camera);

}  // namespace thigma::detail
