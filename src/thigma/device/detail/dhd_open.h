#pragma once
// Devices of Force Dimension's library, found and opened.

#include <string>

#include "thigma/device/detail/dhd_library.h"

namespace thigma::detail {

/// Number of a device in an address, 0 where it is "".
///
/// rest     what follows "dhd:"
/// errors   DeviceAddressError
/// Thread   [offline].
long parse_dhd_number(const std::string& rest);

/// Opens the device of a number or serial number; its id.
///
/// errors   DeviceUnavailable, one line with what to do
/// Thread   [offline].
char open_dhd_number(const DhdLibrary& dhd, long number);

/// Serial number of an opened device, -1 where it tells none.
/// Thread   [offline].
long dhd_serial(const DhdLibrary& dhd, char id);

}  // namespace thigma::detail
