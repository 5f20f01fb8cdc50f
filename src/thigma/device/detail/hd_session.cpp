#include "thigma/device/detail/hd_session.h"

#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "thigma/device/detail/openhaptics_device.h"
#include "thigma/device/detail/vendor_frames.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]
constexpr unsigned kGoOn = 1;
constexpr unsigned short kPriority = 0x7fff;  // the vendor's usual one

constexpr const char* kPlug =
    "Plug it in, switch it on and run the vendor's set-up; if it is set up, let your user open it "
    "(docs/devices.md, udev rule).";

constexpr const char* kWarm = "the motors are warm, let the device rest";

void sleep_ms(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// The usual names: some installations take no null name.
std::vector<std::string> names_to_try(const std::string& name) {
  if (!name.empty()) return {name};
  return {"Default Device", "Default PHANToM", ""};
}

}  // namespace

HdHandle::HdHandle(const HdLibrary& library, const std::string& name) : library_(library) {
  std::string why;
  for (const std::string& tried : names_to_try(name)) {
    take_hd_error(library_);  // of somebody before
    id_ = library_.init(tried.empty() ? nullptr : tried.c_str());
    const HdError error = take_hd_error(library_);
    if (id_ != kHdNoDevice && error.code == 0) {
      name_ = tried;
      if (library_.make_current != nullptr) library_.make_current(id_);
      return;
    }
    if (id_ != kHdNoDevice) library_.disable_device(id_);
    if (!why.empty()) why += "; ";
    why.append("'").append(tried).append("': ").append(hd_error_text(library_, error.code));
  }
  throw DeviceUnavailable("openhaptics: no device answers (" + why + "). " + kPlug);
}

HdHandle::~HdHandle() { library_.disable_device(id_); }

std::string HdHandle::text(unsigned what) const {
  const char* text = library_.get_string != nullptr ? library_.get_string(what) : nullptr;
  const std::string copy = text != nullptr ? text : "";
  return take_hd_error(library_).code == 0 ? copy : "";
}

int HdHandle::integer(unsigned what, int otherwise) const {
  int values[16] = {otherwise};
  if (library_.get_integers != nullptr) library_.get_integers(what, values);
  return take_hd_error(library_).code == 0 ? values[0] : otherwise;
}

void HdServo::start(double rate, DeviceTick tick) {
  tick_ = tick;
  is_stopping_ = false;
  take_hd_error(library_);
  if (library_.set_rate != nullptr)
    library_.set_rate(static_cast<unsigned long>(std::lround(rate)));
  if (const HdError error = take_hd_error(library_); error.code != 0)
    throw DeviceUnavailable("openhaptics: the scheduler does not run at " +
                            std::to_string(std::lround(rate)) + " Hz (" +
                            hd_error_text(library_, error.code) + "). Use --rate 1000.");
  task_ = library_.schedule(on_frame, this, kPriority);
  library_.enable(kHdForceOutput);
  library_.start_scheduler();
  is_started_ = true;
  if (const HdError error = take_hd_error(library_); error.code != 0) {
    stop();
    throw DeviceUnavailable(std::string("openhaptics: the scheduler does not start (") +
                            hd_error_text(library_, error.code) + "). " + kPlug);
  }
}

void HdServo::stop() noexcept {
  if (!is_started_) return;
  is_started_ = false;
  is_stopping_ = true;  // frames from here on send zero
  sleep_ms(25);
  library_.disable(kHdForceOutput);
  library_.stop_scheduler();
  library_.unschedule(task_);
  constexpr int kMostWaits = 1000;
  for (int i = 0; i < kMostWaits && is_in_frame_; ++i) sleep_ms(1);
}

bool HdServo::is_in_tick() const THIGMA_RT {
  return is_in_frame_.load(std::memory_order_acquire) &&
         pthread_equal(thread_.load(std::memory_order_relaxed), pthread_self());
}

unsigned HdServo::on_frame(void* self) noexcept {
  static_cast<HdServo*>(self)->frame();
  return kGoOn;  // until it is unscheduled: zero is sent to the end
}

void HdServo::frame() noexcept {
  thread_.store(pthread_self(), std::memory_order_relaxed);
  is_in_frame_.store(true, std::memory_order_release);
  library_.begin_frame(device_);
  read();
  if (warm_frames_ > 0 && --warm_frames_ == 0) trouble_.clear(kWarm);
  look_for_errors();
  has_sent_ = false;
  if (!is_stopping_) tick_.call(tick_.context);
  if (!has_sent_) send(Vec3::Zero(), nullptr);
  library_.end_frame(device_);
  look_for_errors();
  is_in_frame_.store(false, std::memory_order_release);
}

void HdServo::read() noexcept {
  double transform[16] = {}, velocity[3] = {}, turning[3] = {};
  int buttons = 0;
  library_.get_doubles(kHdTransform, transform);
  library_.get_doubles(kHdVelocity, velocity);
  library_.get_doubles(kHdAngularVelocity, turning);
  if (library_.get_integers != nullptr) library_.get_integers(kHdButtons, &buttons);
  const auto column = [&](int i) {
    return from_hd_axes({transform[4 * i], transform[4 * i + 1], transform[4 * i + 2]});
  };
  sample_.motion.pose.position = kMillimetre * column(3);
  sample_.motion.twist.linear = kMillimetre * from_hd_axes({velocity[0], velocity[1], velocity[2]});
  sample_.motion.twist.angular = from_hd_axes({turning[0], turning[1], turning[2]});
  Mat3 axes;  // the handle's, renamed as the frame's are
  axes << column(2), column(0), column(1);
  if (!nearest_rotation(axes, sample_.motion.pose.orientation))
    trouble_.lose("the orientation is no rotation");
  sample_.buttons = static_cast<std::uint32_t>(buttons);
}

void HdServo::look_for_errors() noexcept {
  const HdError error = take_hd_error(library_);
  if (error.code == 0) return;
  if (error.code == kHdWarmMotors) {
    constexpr int kStays = 1000;  // frames
    warm_frames_ = kStays;
    trouble_.warn(kWarm, hd_error_text(library_, error.code));
  } else {
    trouble_.lose("the vendor's library reports an error", hd_error_text(library_, error.code));
  }
}

void HdServo::send(const Vec3& force, const Vec3* torque) THIGMA_RT {
  has_sent_ = true;
  const Vec3 f = to_hd_axes(force);
  library_.set_doubles(kHdForce, f.data());
  if (torque == nullptr && !has_sent_torque_) return;
  has_sent_torque_ = torque != nullptr;  // else: zero once more
  const Vec3 t = torque != nullptr ? to_hd_axes(*torque) : Vec3(0.0, 0.0, 0.0);
  library_.set_doubles(kHdTorque, t.data());
}

}  // namespace thigma::detail
