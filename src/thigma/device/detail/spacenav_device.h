#pragma once
// A SpaceMouse through the socket of spacenavd, protocol 0: `spacenav:`. Untested on hardware.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

struct DeviceContext;
struct DeviceParameter;

namespace detail {

inline constexpr std::size_t kSpacenavEvent = 32;  // bytes: eight numbers of 32 bits

/// What the daemon's events add up to.
struct SpacenavState {
  // deflections in counts, about 350 at most: x right, y up, z away from the person; turns about
  // these
  Vec3 push = Vec3::Zero(), twist = Vec3::Zero();
  std::uint32_t buttons = 0;
};

/// Takes one event.
///
/// event    kSpacenavEvent bytes, of this machine's order
/// returns  what is wrong, one line: no event of spacenavd; "" where nothing is
std::string take_spacenav_event(std::string_view event, SpacenavState& state);

/// Deflections at full counts of 350, beyond a dead zone [-1 to 1; x to the person, y right, z up].
Twist spacenav_deflection(const SpacenavState& state);

/// Connects.
///
/// rest     "", or the path of the daemon's socket, then parameters (spacenav_parameters)
/// errors   DeviceAddressError, DeviceUnavailable: no daemon, no permission; what to do
/// Thread   [offline].
std::unique_ptr<HapticDevice> open_spacenav(const std::string& rest, const DeviceContext& context);

/// "spacenav:" where the daemon answers; throws as open_spacenav.
std::vector<std::string> plugged_spacenav();

/// What follows the "?".
std::vector<DeviceParameter> spacenav_parameters();

}  // namespace detail
}  // namespace thigma
