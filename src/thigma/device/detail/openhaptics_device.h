#pragma once
// Touch and Phantom by OpenHaptics: `openhaptics:NAME`. The vendor's scheduler calls the haptic
// step. Untested on hardware.

#include <memory>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

struct DeviceContext;
struct CalibrationTalk;

namespace detail {

/// Opens the device. Forces are off until start_ticks; torque is off but for a device whose unit
/// has been confirmed (calibrate_openhaptics).
///
/// rest     the name in the vendor's set-up; "": the usual names in order
/// errors   DeviceUnavailable: no library, no device, not calibrated; one line with what to do.
///          InputError for a profile that is none
/// Thread   [offline].
std::unique_ptr<HapticDevice> open_openhaptics(const std::string& rest,
                                               const DeviceContext& context);

/// The vendor's calibration, then the unit of the torque where the device can send one
/// (torque_unit.h). What was confirmed is kept.
///
/// errors   DeviceUnavailable, IoError
/// Thread   [offline]; takes some minutes of a person's time.
void calibrate_openhaptics(const std::string& rest, const CalibrationTalk& talk);

/// Addresses of what answers: the usual names. Throws as open_openhaptics without a library.
/// Thread   [offline].
std::vector<std::string> plugged_openhaptics();

/// Coordinates of ours (x to the person, y right, z up) from HD's (x right, y up, z to the person)
/// and back.
/// Thread   [haptic].
inline Vec3 from_hd_axes(const Vec3& hd) THIGMA_RT { return {hd.z(), hd.x(), hd.y()}; }
inline Vec3 to_hd_axes(const Vec3& ours) THIGMA_RT { return {ours.y(), ours.z(), ours.x()}; }

}  // namespace detail
}  // namespace thigma
