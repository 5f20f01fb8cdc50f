#pragma once
// A tracker, its buttons and its force device on a VRPN server: `vrpn:NAME@HOST`. Untested on
// hardware.

#include <memory>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"
#include "thigma/math/types.h"

namespace thigma {

struct DeviceContext;
struct DeviceParameter;

namespace detail {

/// Axes of a device from a word: which of its axes, with a minus where turned round, are our x (to
/// the person), y (right) and z (up). "zxy" is a device with x right, y up, z to the person.
///
/// axes     columns are the device's axes in ours: ours = axes * theirs
/// returns  what is wrong, one line: no such word, or a mirror; "" where nothing is
/// Thread   [offline].
std::string parse_axes(const std::string& word, Mat3& axes);

/// Connects and waits for the first pose.
///
/// rest     NAME@HOST, NAME@HOST:PORT, then parameters (vrpn_parameters)
/// errors   DeviceAddressError, DeviceUnavailable: no server, another version, no such name, no
///          pose; one line with what to do
/// Thread   [offline]; takes up to some seconds.
std::unique_ptr<HapticDevice> open_vrpn(const std::string& rest, const DeviceContext& context);

/// What follows the "?".
/// Thread   [offline].
std::vector<DeviceParameter> vrpn_parameters();

}  // namespace detail
}  // namespace thigma
