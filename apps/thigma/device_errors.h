#pragma once
// What a verb says of a device that it cannot have.

#include "verbs.h"

#include "thigma/device/open_device.h"

namespace thigma::app {

/// Runs what may find an address or a device wanting; one line and the exit code where it does.
template <class Body>
int with_device(const Body& body) {
  try {
    return body();
  } catch (const DeviceAddressError& error) {
    print_error(error.what());
    return kUsage;
  } catch (const DeviceUnavailable& error) {
    print_error(error.what());
    return kUnavailable;
  }
}

}  // namespace thigma::app
