#include "thigma/device/detail/camera_device.h"

#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

class CameraDevice final : public HapticDevice {
 public:
  CameraDevice(std::unique_ptr<HapticDevice> held, std::unique_ptr<HapticDevice> camera)
      : held_(std::move(held)), camera_(std::move(camera)) {}

  const DeviceLimits& limits() const override { return held_->limits(); }
  std::string name() const override {
    return held_->name() + ", the view moved by " + camera_->name();
  }
  const char* trouble() const THIGMA_RT override {
    const char* const own = held_->trouble();
    return *own != '\0' ? own : camera_->trouble();
  }

  DeviceState read(double now) THIGMA_RT override {
    DeviceState state = held_->read(now);
    const DeviceState camera = camera_->read(now);
    const Pose& pose = camera.motion.pose;
    if (camera.status == DeviceStatus::ok && pose.position.allFinite() &&
        pose.orientation.coeffs().allFinite())
      last_ = pose;
    state.has_camera = true;
    state.camera = last_;
    return state;
  }

  void write(const Wrench& wrench) THIGMA_RT override { held_->write(wrench); }
  void start_ticks(double rate, DeviceTick tick) override { held_->start_ticks(rate, tick); }
  void stop_ticks() noexcept override { held_->stop_ticks(); }

 private:
  const std::unique_ptr<HapticDevice> held_, camera_;
  Pose last_;
};

}  // namespace

std::unique_ptr<HapticDevice> make_camera_device(std::unique_ptr<HapticDevice> held,
                                                 std::unique_ptr<HapticDevice> camera) {
  const DeviceLimits& limits = camera->limits();
  if (limits.holds_person || limits.clock == DeviceClock::device)
    throw DeviceAddressError("camera = " + camera->name() +
                             ", expected a device without motors, as spacenav:");
  return std::make_unique<CameraDevice>(std::move(held), std::move(camera));
}

}  // namespace thigma::detail
