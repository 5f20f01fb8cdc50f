#include "thigma/device/detail/openhaptics_device.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "thigma/core/error.h"
#include "thigma/device/detail/device_profile.h"
#include "thigma/device/detail/hd_session.h"
#include "thigma/device/detail/torque_unit.h"
#include "thigma/device/detail/vendor_frames.h"
#include "thigma/device/device_limits.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

/// Limits of the published row that a model's name speaks of, careful ones otherwise.
void use_model(const std::string& model, DeviceLimits& limits) {
  const DeviceModel* row = find_device_model("touch");
  limits.max_torque = 0.03;
  limits.max_angular_stiffness = 0.1;
  if (model.find("Premium") != std::string::npos || model.find("PREMIUM") != std::string::npos) {
    row = find_device_model("premium-1.5-6dof");
    limits.max_torque = row->max_torque;
    limits.max_angular_stiffness = row->max_angular_stiffness;
  }
  limits.max_force = row->max_force;
  limits.max_stiffness = row->max_stiffness;
}

DeviceLimits limits_of(const HdLibrary& hd, const HdHandle& handle, const DeviceProfile& profile) {
  constexpr double kMillimetre = 1e-3;
  constexpr int kAllSix = 6;
  DeviceLimits limits;
  use_model(handle.text(kHdModel), limits);
  double force[16] = {};
  hd.get_doubles(kHdMaxForce, force);
  if (take_hd_error(hd).code == 0 && std::isfinite(force[0]) && force[0] > 0.0)
    limits.max_force = std::min(limits.max_force, force[0]);
  double box[16] = {};
  hd.get_doubles(kHdUsableWorkspace, box);
  if (take_hd_error(hd).code == 0) {
    double least = 1e9;
    for (int i = 0; i < 3; ++i) least = std::min(least, box[i + 3] - box[i]);
    if (least > 0.0 && least < 1e9) limits.workspace_radius = 0.5 * kMillimetre * least;
  }
  limits.actuates_rotation =
      profile.torque_unit > 0.0 && handle.integer(kHdOutputDof, 3) >= kAllSix;
  limits.clock = DeviceClock::device;
  return limits;
}

std::string profile_file(const HdHandle& handle) {
  const std::string serial = handle.text(kHdSerial);
  return device_profile_file("openhaptics-" + handle.text(kHdModel) + "-" +
                             (serial.empty() ? handle.name() : serial));
}

const char* calibration_step(const HdLibrary& hd) {
  const int style = hd.calibration_style != nullptr ? hd.calibration_style() : 0;
  if ((style & kHdInkwell) != 0) return "put the stylus into its inkwell";
  return "hold the arm in the position that its manual gives for calibration";
}

/// The vendor's calibration, where it needs no hand; whether the device is calibrated now.
bool update_calibration(const HdLibrary& hd) {
  if (hd.check_calibration == nullptr) return true;
  unsigned state = hd.check_calibration();
  if (state == kHdCanUpdate && hd.update_calibration != nullptr) {
    const int style = hd.calibration_style != nullptr ? hd.calibration_style() : kHdInkwell;
    hd.update_calibration(static_cast<unsigned>(style));
    take_hd_error(hd);
    state = hd.check_calibration();
  }
  return state == kHdCalibrated;
}

/// The library with its device: destroyed in the opposite order.
struct OpenedHd {
  explicit OpenedHd(const std::string& name) : library(open_hd_library()), handle(library, name) {}
  HdLibrary library;
  HdHandle handle;
};

class OpenHapticsDevice final : public HapticDevice {
 public:
  OpenHapticsDevice(std::unique_ptr<OpenedHd> hd, const DeviceLimits& limits, double torque_unit)
      : hd_(std::move(hd)),
        name_("openhaptics: " + hd_->handle.text(kHdModel)),
        limits_(limits),
        torque_unit_(torque_unit),
        servo_(hd_->library, hd_->handle.id()) {}

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return name_; }
  const char* trouble() const THIGMA_RT override { return servo_.trouble().text(); }

  DeviceState read(double now) THIGMA_RT override {
    const bool is_in_tick = servo_.is_in_tick();
    if (!is_in_tick) servo_.trouble().lose("the vendor's scheduler does not call any more");
    if (!is_in_tick || servo_.trouble().is_lost()) {
      DeviceState lost = last_;
      lost.status = DeviceStatus::lost;
      return lost;
    }
    last_ = servo_.sample();
    last_.time = now;
    return last_;
  }

  void write(const Wrench& wrench) THIGMA_RT override {
    if (!servo_.is_in_tick()) return servo_.turn_off();
    Wrench w = servo_.trouble().is_lost() ? Wrench{} : sendable(wrench, limits_);
    w.torque *= torque_unit_;
    servo_.send(w.force, limits_.actuates_rotation ? &w.torque : nullptr);
  }

  void start_ticks(double rate, DeviceTick tick) override { servo_.start(rate, tick); }
  void stop_ticks() noexcept override { servo_.stop(); }

 private:
  const std::unique_ptr<OpenedHd> hd_;
  const std::string name_;
  const DeviceLimits limits_;
  const double torque_unit_;
  DeviceState last_;  // good one
  HdServo servo_;
};

}  // namespace

std::unique_ptr<HapticDevice> open_openhaptics(const std::string& rest, const DeviceContext&) {
  auto hd = std::make_unique<OpenedHd>(rest);
  if (!update_calibration(hd->library))
    throw DeviceUnavailable(std::string("openhaptics: the device is not calibrated: ") +
                            calibration_step(hd->library) +
                            ", then run `thigma devices calibrate openhaptics:" + rest + "`.");
  const DeviceProfile profile = read_device_profile(profile_file(hd->handle));
  const DeviceLimits limits = limits_of(hd->library, hd->handle, profile);
  return std::make_unique<OpenHapticsDevice>(std::move(hd), limits, profile.torque_unit);
}

void calibrate_openhaptics(const std::string& rest, const CalibrationTalk& talk) {
  OpenedHd hd(rest);
  constexpr int kTries = 3;
  for (int i = 0; !update_calibration(hd.library); ++i) {
    const std::string step = calibration_step(hd.library);
    if (i == kTries || !talk.confirm("Please " + step + ". Done?"))
      throw DeviceUnavailable("openhaptics: the device is not calibrated: " + step +
                              " and try again.");
  }
  talk.say("The vendor's calibration is done.");
  if (hd.handle.integer(kHdOutputDof, 3) < 6) {
    talk.say("The device gives no torque: nothing more to do.");
    return;
  }
  const double unit = find_torque_unit(hd.library, hd.handle.id(), talk);
  if (unit == 0.0) {
    talk.say("The unit of the torque was not found: torque stays off.");
    return;
  }
  const std::string name = unit == 1.0 ? "N m" : "mN m";
  if (!talk.confirm("The library's torque seems to be in " + name + ". Keep that?")) return;
  const std::string file = profile_file(hd.handle);
  write_device_profile(file, {unit});
  talk.say("Kept in " + file + ".");
}

std::vector<std::string> plugged_openhaptics() {
  const HdLibrary library = open_hd_library();
  try {
    const HdHandle handle(library, "");
    return {"openhaptics:" + handle.name()};
  } catch (const DeviceUnavailable&) {
    return {};
  }
}

}  // namespace thigma::detail
