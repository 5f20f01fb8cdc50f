#pragma once
// Devices of Force Dimension, and the Falcon: `dhd:N` or `dhd:SERIAL`. Untested on hardware.

#include <memory>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

struct DeviceContext;
struct CalibrationTalk;

namespace detail {

/// What is known of a system type. Forces are conservative where no source gives one.
struct DhdModel {
  int type = 0;  // as dhdGetSystemType gives it
  const char* name = "";
  double max_force = 4.0;              // [N]
  double max_torque = 0.0;             // [N m]
  double max_stiffness = 1000.0;       // [N/m]
  double max_angular_stiffness = 0.0;  // [N m/rad]
  double workspace_radius = 0.08;      // [m]
  bool senses_rotation = false, actuates_rotation = false;
};

/// The row of a type; the careful last one, without rotation, for a type that is not in the table.
/// Thread   [any].
const DhdModel& dhd_model(int type) noexcept;

/// Opens the device: its forces stay off until the first write.
///
/// rest     "", the number of a device from 0 on, or its serial number
/// errors   DeviceAddressError, DeviceUnavailable: no library, no device, in use, not initialised;
///          one line with what to do
/// Thread   [offline].
std::unique_ptr<HapticDevice> open_dhd(const std::string& rest, const DeviceContext& context);

/// Lets a device find its own reference by moving by itself: nobody may hold it.
/// errors   DeviceUnavailable
/// Thread   [offline]; takes seconds.
void calibrate_dhd(const std::string& rest, const CalibrationTalk& talk);

/// Addresses of what is plugged in; throws as open_dhd where there is no library.
/// Thread   [offline].
std::vector<std::string> plugged_dhd();

}  // namespace detail
}  // namespace thigma
