#include "thigma/device/detail/dhd_library.h"

#include <string>

#include "thigma/device/open_device.h"
#include "thigma/device/vendor_libraries.h"

namespace thigma::detail {
namespace {

template <class Function>
void find(const SharedLibrary& library, const char* name, Function& function) {
  if (function == nullptr) function = reinterpret_cast<Function>(library.symbol(name));
}

}  // namespace

DhdLibrary open_dhd_library() {
  DhdLibrary dhd{open_vendor_library("dhd:")};
  const SharedLibrary& library = dhd.library;
  find(library, "dhdGetDeviceCount", dhd.count);
  find(library, "dhdGetPositionAndOrientationFrame", dhd.get_pose);
  find(library, "dhdGetLinearVelocity", dhd.get_linear_velocity);
  find(library, "dhdGetAngularVelocityRad", dhd.get_angular_velocity);
  find(library, "dhdGetButtonMask", dhd.get_buttons);
  find(library, "dhdSetForceAndTorqueAndGripperForce", dhd.set_wrench);
  find(library, "dhdEnableForce", dhd.enable_force);
  find(library, "dhdStop", dhd.stop);
  find(library, "drdOpenID", dhd.open);
  find(library, "dhdOpenID", dhd.open);
  find(library, dhd.open != nullptr && library.symbol("drdOpenID") ? "drdClose" : "dhdClose",
       dhd.close);
  find(library, "drdIsInitialized", dhd.is_initialized);
  find(library, "drdAutoInit", dhd.auto_init);
  find(library, "drdStop", dhd.stop_regulation);
  find(library, "dhdGetSystemType", dhd.get_type);
  find(library, "dhdGetSystemName", dhd.get_name);
  find(library, "dhdGetSerialNumber", dhd.get_serial);
  find(library, "dhdHasGripper", dhd.has_gripper);
  find(library, "dhdEmulateButton", dhd.emulate_button);
  find(library, "dhdGetMaxForce", dhd.get_max_force);
  find(library, "dhdGetMaxTorque", dhd.get_max_torque);
  find(library, "dhdGetStatus", dhd.get_status);
  find(library, "dhdErrorGetLast", dhd.last_error_number);
  find(library, "dhdErrorGetLastStr", dhd.last_error);
  if (dhd.open == nullptr || dhd.close == nullptr)
    throw DeviceUnavailable("dhd: " + library.name() +
                            " lacks the symbols drdOpenID and dhdOpenID. Install the vendor's "
                            "current SDK.");
  return dhd;
}

const char* last_dhd_error(const DhdLibrary& library) noexcept {
  const char* text = library.last_error != nullptr ? library.last_error() : nullptr;
  return text != nullptr ? text : "";
}

}  // namespace thigma::detail
