#include "thigma/device/detail/hd_library.h"

#include "thigma/device/vendor_libraries.h"

namespace thigma::detail {
namespace {

template <class Function>
void find(const SharedLibrary& library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(library.symbol(name));
}

}  // namespace

HdLibrary open_hd_library() {
  HdLibrary hd{open_vendor_library("openhaptics:")};
  const SharedLibrary& library = hd.library;
  find(library, "hdInitDevice", hd.init);
  find(library, "hdDisableDevice", hd.disable_device);
  find(library, "hdBeginFrame", hd.begin_frame);
  find(library, "hdEndFrame", hd.end_frame);
  find(library, "hdGetError", hd.get_error);
  find(library, "hdEnable", hd.enable);
  find(library, "hdDisable", hd.disable);
  find(library, "hdGetDoublev", hd.get_doubles);
  find(library, "hdSetDoublev", hd.set_doubles);
  find(library, "hdScheduleAsynchronous", hd.schedule);
  find(library, "hdUnschedule", hd.unschedule);
  find(library, "hdStartScheduler", hd.start_scheduler);
  find(library, "hdStopScheduler", hd.stop_scheduler);
  find(library, "hdMakeCurrentDevice", hd.make_current);
  find(library, "hdGetIntegerv", hd.get_integers);
  find(library, "hdGetString", hd.get_string);
  find(library, "hdGetErrorString", hd.error_string);
  find(library, "hdSetSchedulerRate", hd.set_rate);
  find(library, "hdCheckCalibration", hd.check_calibration);
  find(library, "hdCheckCalibrationStyle", hd.calibration_style);
  find(library, "hdUpdateCalibration", hd.update_calibration);
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
