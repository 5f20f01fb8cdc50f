#include "guard.h"

#include "contact_table.h"

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"

namespace thigma::c {
namespace {

thread_local std::string last_error;

thigma_result keep(thigma_result code, const char* what) noexcept {
  try {
    last_error = what;
  } catch (...) {
    last_error.clear();
  }
  return code;
}

}  // namespace

thigma_result take_error() noexcept {
  try {
    throw;
  } catch (const InputError& error) {
    return keep(THIGMA_BAD_INPUT, error.what());
  } catch (const DeviceUnavailable& error) {
    return keep(THIGMA_DEVICE_UNAVAILABLE, error.what());
  } catch (const std::logic_error& error) {  // DeviceAddressError among them
    return keep(THIGMA_BAD_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return keep(THIGMA_FAILED, error.what());
  } catch (...) {
    return keep(THIGMA_FAILED, "something that is no exception");
  }
}

Pose pose_from(const double* row, const char* name) {
  return bindings::poses_from_rows({&needed(row, name), 7}, name).at(0);
}

void put(const Pose& pose, double* row) noexcept {
  for (int i = 0; i < 3; ++i) row[i] = pose.position[i];
  for (int i = 0; i < 4; ++i) row[3 + i] = pose.orientation.coeffs()[i];
}

void put(const Wrench& wrench, double* row) noexcept {
  for (int i = 0; i < 3; ++i) row[i] = wrench.force[i];
  for (int i = 0; i < 3; ++i) row[3 + i] = wrench.torque[i];
}

}  // namespace thigma::c

extern "C" {

const char* thigma_version(void) { return THIGMA_VERSION; }
const char* thigma_last_error(void) { return thigma::c::last_error.c_str(); }

}  // extern "C"
