#pragma once
// Published nominal limits of devices one can buy, for `hand:?device=NAME` and for tuning.

#include <span>
#include <string_view>

#include "thigma/device/haptic_device.h"

namespace thigma {

/// One product. 0: no value in the source; not a limit of zero.
struct DeviceModel {
  std::string_view name;  // as in an address
  std::string_view product;
  double max_force = 0.0;              // [N]
  double max_torque = 0.0;             // [N m]
  double max_stiffness = 0.0;          // [N/m]
  double max_angular_stiffness = 0.0;  // [N m/rad]
  bool senses_rotation = true;
  bool actuates_rotation = false;
};

/// The table, in alphabetical order of names. Source: the per-model values CHAI3D 3.3 publishes in
/// its drivers.
/// Thread    [haptic].
std::span<const DeviceModel> device_models() THIGMA_RT;

/// The model of that name or null.
/// Thread    [haptic].
const DeviceModel* find_device_model(std::string_view name) THIGMA_RT;

}  // namespace thigma
