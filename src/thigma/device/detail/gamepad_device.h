#pragma once
// A gamepad through the kernel's event devices: `gamepad:`. Untested on hardware.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

struct DeviceContext;
struct DeviceParameter;

namespace detail {

/// Axes of a gamepad, by the kernel's numbers ABS_X, ABS_Y, ABS_Z, ABS_RX, ABS_RY, ABS_RZ.
inline constexpr int kPadAxes = 6;

/// What values an axis has.
struct PadRange {
  int least = -32768, greatest = 32767;
  int flat = 0;  // around the middle that are none
};

/// What a gamepad's events add up to.
struct PadState {
  std::array<PadRange, kPadAxes> ranges{};
  std::array<int, kPadAxes> values{};
  std::uint32_t buttons = 0;  // bit 0: south, 1: east, 2: north, 3: west, 4: left bumper, 5: right
};

/// A pad whose driver tells no ranges: sticks of 16 bits, triggers of 8.
PadState plain_pad();

/// Takes one event of the kernel: EV_ABS and EV_KEY; others change nothing.
void take_pad_event(std::uint16_t type, std::uint16_t code, std::int32_t value, PadState& state);

/// Deflections [-1 to 1; x to the person, y right, z up]. Left stick: along x and y; triggers: up
/// and down; right stick: turns about z and y; bumpers: about x.
Twist pad_deflection(const PadState& state);

/// Opens it.
///
/// rest     "" for the first, a number from 0 on, or the path of an event device; then parameters
///          (gamepad_parameters)
/// errors   DeviceAddressError, DeviceUnavailable: none, no permission, no gamepad; what to do
/// Thread   [offline].
std::unique_ptr<HapticDevice> open_gamepad(const std::string& rest, const DeviceContext& context);

/// Addresses of what is plugged in.
std::vector<std::string> plugged_gamepads();

/// What follows the "?".
std::vector<DeviceParameter> gamepad_parameters();

}  // namespace detail
}  // namespace thigma
