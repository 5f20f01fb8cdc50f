#pragma once
// Inverse3, Inverse3x and Minverse of Haply, with a VerseGrip for rotation: `haply:`. Untested on
// hardware.

#include <memory>
#include <string>
#include <vector>

#include "thigma/device/detail/haply_message.h"
#include "thigma/device/haptic_device.h"

namespace thigma {

struct DeviceContext;
struct DeviceParameter;

namespace detail {

/// Axes of the service (x right, y away from the person, z up) to ours (x to the person, y right, z
/// up) and back.
/// Thread   [any].
inline Vec3 ours_from_haply(const Vec3& v) { return {-v.y(), v.x(), v.z()}; }
inline Vec3 haply_from_ours(const Vec3& v) { return {v.y(), -v.x(), v.z()}; }
inline Quat ours_from_haply(const Quat& q) { return {q.w(), -q.y(), q.x(), q.z()}; }

/// Opens the device through the Inverse Service.
///
/// rest     "", or the device's id, then parameters (haply_parameters)
/// errors   DeviceAddressError, DeviceUnavailable: no service, another version, no device, not
///          calibrated; one line with what to do
/// Thread   [offline]; takes up to some seconds.
std::unique_ptr<HapticDevice> open_haply(const std::string& rest, const DeviceContext& context);

/// Addresses of what the service on this machine has; none without a service.
/// Thread   [offline].
std::vector<std::string> plugged_haply();

/// What follows the "?".
/// Thread   [offline].
std::vector<DeviceParameter> haply_parameters();

}  // namespace detail
}  // namespace thigma
