#include "thigma/device/detail/dhd_library.h"

#include <string>

#include "thigma/device/open_device.h"
#include "thigma/device/vendor_libraries.h"

namespace thigma::detail {

DhdLibrary open_dhd_library() {
  DhdLibrary dhd{open_vendor_library("dhd:")};
  const SharedLibrary& library = dhd.library;
  library.find("dhdGetDeviceCount", dhd.count);
  library.find("dhdGetPositionAndOrientationFrame", dhd.get_pose);
  library.find("dhdGetLinearVelocity", dhd.get_linear_velocity);
  library.find("dhdGetAngularVelocityRad", dhd.get_angular_velocity);
  library.find("dhdGetButtonMask", dhd.get_buttons);
  library.find("dhdSetForceAndTorqueAndGripperForce", dhd.set_wrench);
  library.find("dhdEnableForce", dhd.enable_force);
  library.find("dhdStop", dhd.stop);
  library.find("drdOpenID", dhd.open);
  library.find(dhd.open != nullptr ? "drdClose" : "dhdClose", dhd.close);
  if (dhd.open == nullptr) library.find("dhdOpenID", dhd.open);
  library.find("drdIsInitialized", dhd.is_initialized);
  library.find("drdAutoInit", dhd.auto_init);
  library.find("drdStop", dhd.stop_regulation);
  library.find("dhdGetSystemType", dhd.get_type);
  library.find("dhdGetSystemName", dhd.get_name);
  library.find("dhdGetSerialNumber", dhd.get_serial);
  library.find("dhdHasGripper", dhd.has_gripper);
  library.find("dhdEmulateButton", dhd.emulate_button);
  library.find("dhdGetMaxForce", dhd.get_max_force);
  library.find("dhdGetMaxTorque", dhd.get_max_torque);
  library.find("dhdGetStatus", dhd.get_status);
  library.find("dhdErrorGetLast", dhd.last_error_number);
  library.find("dhdErrorGetLastStr", dhd.last_error);
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
