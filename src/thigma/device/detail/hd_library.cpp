#include "thigma/device/detail/hd_library.h"

#include "thigma/device/vendor_libraries.h"

namespace thigma::detail {

HdLibrary open_hd_library() {
  HdLibrary hd{open_vendor_library("openhaptics:")};
  const SharedLibrary& library = hd.library;
  library.find("hdInitDevice", hd.init);
  library.find("hdDisableDevice", hd.disable_device);
  library.find("hdBeginFrame", hd.begin_frame);
  library.find("hdEndFrame", hd.end_frame);
  library.find("hdGetError", hd.get_error);
  library.find("hdEnable", hd.enable);
  library.find("hdDisable", hd.disable);
  library.find("hdGetDoublev", hd.get_doubles);
  library.find("hdSetDoublev", hd.set_doubles);
  library.find("hdScheduleAsynchronous", hd.schedule);
  library.find("hdUnschedule", hd.unschedule);
  library.find("hdStartScheduler", hd.start_scheduler);
  library.find("hdStopScheduler", hd.stop_scheduler);
  library.find("hdMakeCurrentDevice", hd.make_current);
  library.find("hdGetIntegerv", hd.get_integers);
  library.find("hdGetString", hd.get_string);
  library.find("hdGetErrorString", hd.error_string);
  library.find("hdSetSchedulerRate", hd.set_rate);
  library.find("hdCheckCalibration", hd.check_calibration);
  library.find("hdCheckCalibrationStyle", hd.calibration_style);
  library.find("hdUpdateCalibration", hd.update_calibration);
  return hd;
}

HdError take_hd_error(const HdLibrary& library) noexcept {
  constexpr int kMostHeld = 16;  // the library keeps a stack, the newest on top
  HdError oldest;
  for (int i = 0; i < kMostHeld; ++i) {
    const HdError error = library.get_error();
    if (error.code == 0) break;
    oldest = error;
  }
  return oldest;
}

const char* hd_error_text(const HdLibrary& library, unsigned code) noexcept {
  const char* text = library.error_string != nullptr ? library.error_string(code) : nullptr;
  return text != nullptr ? text : "";
}

}  // namespace thigma::detail
