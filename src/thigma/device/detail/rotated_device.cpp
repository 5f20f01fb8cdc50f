#include "thigma/device/detail/rotated_device.h"

#include "thigma/device/detail/paired_device.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

class RotatedDevice final : public PairedDevice {
 public:
  RotatedDevice(std::unique_ptr<HapticDevice> place, std::unique_ptr<HapticDevice> turn)
      : PairedDevice(std::move(place), std::move(turn), ", turned by "), limits_(first_->limits()) {
    limits_.senses_rotation = true;
  }

  const DeviceLimits& limits() const override { return limits_; }

  DeviceState read(double now) THIGMA_RT override {
    DeviceState state = first_->read(now);
    const DeviceState turn = second_->read(now);
    if (turn.status == DeviceStatus::ok) orientation_ = turn.motion.pose.orientation;
    state.motion.pose.orientation = orientation_;
    state.motion.twist.angular =
        turn.status == DeviceStatus::ok ? turn.motion.twist.angular : Vec3(Vec3::Zero());
    if (state.has_true_handle) state.true_handle.orientation = orientation_;
    return state;
  }

 private:
  DeviceLimits limits_;
  Quat orientation_ = Quat::Identity();
};

}  // namespace

std::unique_ptr<HapticDevice> make_rotated_device(std::unique_ptr<HapticDevice> place,
                                                  std::unique_ptr<HapticDevice> turn) {
  if (place->limits().senses_rotation)
    throw DeviceAddressError("rotation = " + turn->name() + ": " + place->name() +
                             " senses rotation itself");
  if (!turn->limits().senses_rotation || !may_stand_second(turn->limits()))
    throw DeviceAddressError("rotation = " + turn->name() +
                             ", expected a device with rotation and without motors, as spacenav:");
  return std::make_unique<RotatedDevice>(std::move(place), std::move(turn));
}

}  // namespace thigma::detail
