#include "thigma/device/detail/camera_device.h"

#include "thigma/device/detail/paired_device.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

class CameraDevice final : public PairedDevice {
 public:
  CameraDevice(std::unique_ptr<HapticDevice> held, std::unique_ptr<HapticDevice> camera)
      : PairedDevice(std::move(held), std::move(camera), ", the view moved by ") {}

  DeviceState read(double now) THIGMA_RT override {
    DeviceState state = first_->read(now);
    const DeviceState camera = second_->read(now);
    const Pose& pose = camera.motion.pose;
    if (camera.status == DeviceStatus::ok && pose.position.allFinite() &&
        pose.orientation.coeffs().allFinite())
      last_ = pose;
    state.has_camera = true;
    state.camera = last_;
    return state;
  }

 private:
  Pose last_;
};

}  // namespace

std::unique_ptr<HapticDevice> make_camera_device(std::unique_ptr<HapticDevice> held,
                                                 std::unique_ptr<HapticDevice> camera) {
  if (!may_stand_second(camera->limits()))
    throw DeviceAddressError("camera = " + camera->name() +
                             ", expected a device without motors, as spacenav:");
  return std::make_unique<CameraDevice>(std::move(held), std::move(camera));
}

}  // namespace thigma::detail
