#pragma once
// Recorded device samples as a device. Reading the recording is the business of recording/.

#include <memory>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

/// One recorded sample a read, in order and unchanged, whatever `now` says: a replay must see the
/// bits that were recorded. After the last, that one again with status `finished`. Wrenches are
/// accepted.
///
/// samples  at least one (else every read answers `finished`)
/// limits   those of the device recorded
/// Thread   [offline].
std::unique_ptr<HapticDevice> make_replay_device(std::vector<DeviceState> samples,
                                                 const DeviceLimits& limits = {});

}  // namespace thigma
