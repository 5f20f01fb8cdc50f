#pragma once
// What a user has confirmed of a device, kept in the user's configuration folder.

#include <string>
#include <string_view>

namespace thigma::detail {

/// One device's.
struct DeviceProfile {
  // what the vendor's library takes for 1 N m: 1 or 1000. 0: not confirmed, no torque is sent
  double torque_unit = 0.0;
};

/// The file of a device: $XDG_CONFIG_HOME/thigma/devices/NAME.txt, else below ~/.config; "" where
/// there is no such folder.
///
/// name     of the device; what is no letter, digit, dot or dash becomes a dash
/// Thread   [offline].
std::string device_profile_file(std::string_view name);

/// An absent file is a profile without anything confirmed.
///
/// errors   InputError for a file that is no profile
/// Thread   [offline].
DeviceProfile read_device_profile(const std::string& file);

/// Makes the folders that are missing.
///
/// errors   IoError
/// Thread   [offline].
void write_device_profile(const std::string& file, const DeviceProfile& profile);

}  // namespace thigma::detail
