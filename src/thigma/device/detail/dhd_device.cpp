#include "thigma/device/detail/dhd_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <thread>

#include "thigma/device/detail/dhd_library.h"
#include "thigma/device/detail/dhd_open.h"
#include "thigma/device/detail/trouble_line.h"
#include "thigma/device/detail/vendor_frames.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr const char* kForceOff[] = {
    "the device turned its forces off",
    "the forces were turned off by the button of the device",
    "the device turned its forces off: the handle was too fast",
    "the device turned its forces off: its watchdog heard nothing in time",
    "software turned the forces off",
    "the device turned its forces off: USB was disconnected",
    "the device turned its forces off: the dead man's switch was let go"};
constexpr int kForceOffButton = 1;

/// Limits of a model as this device states them.
DeviceLimits limits_of(const DhdLibrary& dhd, char id, const DhdModel& model) {
  DeviceLimits limits;
  limits.max_force = model.max_force;
  limits.max_torque = model.max_torque;
  limits.max_stiffness = model.max_stiffness;
  limits.max_angular_stiffness = model.max_angular_stiffness;
  limits.workspace_radius = model.workspace_radius;
  limits.senses_rotation = model.senses_rotation;
  limits.actuates_rotation = model.actuates_rotation;
  const auto lower = [id](double (*get)(char), double& limit) {
    const double own = get != nullptr ? get(id) : -1.0;  // below 0: it has none
    if (std::isfinite(own) && own > 0.0) limit = std::min(limit, own);
  };
  lower(dhd.get_max_force, limits.max_force);
  lower(dhd.get_max_torque, limits.max_torque);
  return limits;
}

/// An opened device. Frame of the vendor: x to the person, y to the right, z up, which is ours.
/// Invariant: forces are off before the first write and after the destructor.
class DhdDevice final : public HapticDevice {
 public:
  DhdDevice(DhdLibrary dhd, char id, std::string name, const DeviceLimits& limits)
      : dhd_(std::move(dhd)), id_(id), name_(std::move(name)), limits_(limits) {
    if (dhd_.has_gripper != nullptr && dhd_.has_gripper(id_) && dhd_.emulate_button != nullptr)
      dhd_.emulate_button(1, id_);  // closing the gripper is the button
  }

  /// Zero, long enough for it to arrive, then off and brakes, then closed.
  ~DhdDevice() override {
    dhd_.set_wrench(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, id_);
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    dhd_.stop(id_);
    dhd_.close(id_);
  }

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return name_; }
  const char* trouble() const THIGMA_RT override { return trouble_.text(); }

  DeviceState read(double now) THIGMA_RT override {
    if (trouble_.is_lost()) return lost();
    DeviceState state;
    state.time = now;
    Vec3& p = state.motion.pose.position;
    Vec3& v = state.motion.twist.linear;
    Vec3& w = state.motion.twist.angular;
    double rows[3][3] = {};
    bool is_error = is_dhd_error(dhd_.get_pose(&p.x(), &p.y(), &p.z(), rows, id_));
    is_error = is_error || !has_velocity(dhd_.get_linear_velocity, v);
    if (limits_.senses_rotation) {
      is_error = is_error || !has_velocity(dhd_.get_angular_velocity, w);
      Mat3 matrix;
      matrix << rows[0][0], rows[0][1], rows[0][2], rows[1][0], rows[1][1], rows[1][2], rows[2][0],
          rows[2][1], rows[2][2];
      if (!is_error && !nearest_rotation(matrix, state.motion.pose.orientation)) {
        trouble_.lose("the orientation is no rotation");
        return lost();
      }
    }
    if (is_error) {
      trouble_.lose("reading failed", last_dhd_error(dhd_));
      return lost();
    }
    state.buttons = dhd_.get_buttons(id_);
    last_ = state;
    return state;
  }

  void write(const Wrench& wrench) THIGMA_RT override {
    if (!is_on_) {
      is_on_ = true;
      if (is_dhd_error(dhd_.enable_force(1, id_)))
        trouble_.lose("turning the forces on failed", last_dhd_error(dhd_));
    }
    Wrench w = trouble_.is_lost() ? Wrench{} : sendable(wrench, limits_);
    w.force *= share();
    w.torque *= share();
    const int result = dhd_.set_wrench(w.force.x(), w.force.y(), w.force.z(), w.torque.x(),
                                       w.torque.y(), w.torque.z(), 0.0, id_);
    if (is_dhd_error(result)) trouble_.lose("sending a force failed", last_dhd_error(dhd_));
    constexpr int kFramesPerLook = 20;
    if (++writes_ % kFramesPerLook == 0) look_at_status();
  }

 private:
  DeviceState lost() const THIGMA_RT {
    DeviceState state = last_;
    state.status = DeviceStatus::lost;
    return state;
  }

  /// A velocity needs some positions, and is zero until the library has them; false: an error.
  bool has_velocity(int (*get)(double*, double*, double*, char), Vec3& velocity) const THIGMA_RT {
    Vec3 read = Vec3::Zero();
    if (!is_dhd_error(get(&read.x(), &read.y(), &read.z(), id_))) {
      velocity = read;
      return true;
    }
    return dhd_.last_error_number != nullptr && dhd_.last_error_number() == kDhdTimeout;
  }

  /// Of the wrench, after the person's button: 0 while forces are off by it, then growing.
  double share() const THIGMA_RT {
    constexpr double kRamp = 0.5;  // [s], as of the safety layer, which does not see the button
    return is_off_ ? 0.0 : std::clamp((last_.time - on_since_) / kRamp, 0.0, 1.0);
  }

  /// Whether the device has turned its forces off by itself.
  void look_at_status() THIGMA_RT {
    int status[kDhdStatusRoom] = {};
    if (dhd_.get_status == nullptr || trouble_.is_lost()) return;
    if (is_dhd_error(dhd_.get_status(status, id_))) return;
    if (status[kDhdStatusForce] != 0) {
      if (is_off_) on_since_ = last_.time;
      if (is_off_) trouble_.clear(kForceOff[kForceOffButton]);
      is_off_ = false;
      return;
    }
    const int cause = status[kDhdStatusForceOffCause];
    const bool is_known = cause >= 0 && cause < static_cast<int>(std::size(kForceOff));
    const char* const what = kForceOff[is_known ? cause : 0];
    if (cause == kForceOffButton) {
      trouble_.warn(what);
      is_off_ = true;
    } else {
      trouble_.lose(what);
    }
  }

  const DhdLibrary dhd_;
  const char id_;
  const std::string name_;
  const DeviceLimits limits_;
  DeviceState last_;  // good one
  TroubleLine trouble_;
  bool is_on_ = false;                                          // forces, by us
  bool is_off_ = false;                                         // by the button of the device
  double on_since_ = -std::numeric_limits<double>::infinity();  // that button [s; as of read]
  int writes_ = 0;
};

}  // namespace

std::unique_ptr<HapticDevice> open_dhd(const std::string& rest, const DeviceContext&) {
  const long number = parse_dhd_number(rest);
  DhdLibrary dhd = open_dhd_library();
  const char id = open_dhd_number(dhd, number);
  if (dhd.is_initialized != nullptr && !dhd.is_initialized(id)) {
    dhd.close(id);
    throw DeviceUnavailable(
        "dhd: the device has not found its reference. Let go of it and run "
        "`thigma devices calibrate dhd:" +
        rest + "`: it moves by itself.");
  }
  const int type = dhd.get_type != nullptr ? dhd.get_type(id) : -1;
  const DhdModel& model = dhd_model(type);
  const DeviceLimits limits = limits_of(dhd, id, model);
  const char* own_name = dhd.get_name != nullptr ? dhd.get_name(id) : nullptr;
  std::string name = std::string("dhd: ") + (own_name != nullptr ? own_name : model.name);
  if (const long serial = dhd_serial(dhd, id); serial > 0) name += " " + std::to_string(serial);
  return std::make_unique<DhdDevice>(std::move(dhd), id, std::move(name), limits);
}

}  // namespace thigma::detail
