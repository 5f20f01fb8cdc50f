#include "thigma/device/detail/rotated_device.h"

#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

class RotatedDevice final : public HapticDevice {
 public:
  RotatedDevice(std::unique_ptr<HapticDevice> place, std::unique_ptr<HapticDevice> turn)
      : place_(std::move(place)), turn_(std::move(turn)), limits_(place_->limits()) {
    limits_.senses_rotation = true;
  }

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return place_->name() + ", turned by " + turn_->name(); }
  const char* trouble() const THIGMA_RT override {
    const char* const own = place_->trouble();
    return *own != '\0' ? own : turn_->trouble();
  }

  DeviceState read(double now) THIGMA_RT override {
    DeviceState state = place_->read(now);
    const DeviceState turn = turn_->read(now);
    if (turn.status == DeviceStatus::ok) orientation_ = turn.motion.pose.orientation;
    state.motion.pose.orientation = orientation_;
    state.motion.twist.angular =
        turn.status == DeviceStatus::ok ? turn.motion.twist.angular : Vec3(Vec3::Zero());
    if (state.has_true_handle) state.true_handle.orientation = orientation_;
    return state;
  }

  void write(const Wrench& wrench) THIGMA_RT override { place_->write(wrench); }
  void start_ticks(double rate, DeviceTick tick) override { place_->start_ticks(rate, tick); }
  void stop_ticks() noexcept override { place_->stop_ticks(); }

 private:
  const std::unique_ptr<HapticDevice> place_, turn_;
  DeviceLimits limits_;
  Quat orientation_ = Quat::Identity();
};

}  // namespace

std::unique_ptr<HapticDevice> make_rotated_device(std::unique_ptr<HapticDevice> place,
                                                  std::unique_ptr<HapticDevice> turn) {
  if (place->limits().senses_rotation)
    throw DeviceAddressError("rotation = " + turn->name() + ": " + place->name() +
                             " senses rotation itself");
  const DeviceLimits& limits = turn->limits();
  if (!limits.senses_rotation || limits.holds_person || limits.clock == DeviceClock::device)
    throw DeviceAddressError("rotation = " + turn->name() +
                             ", expected a device with rotation and without motors, as spacenav:");
  return std::make_unique<RotatedDevice>(std::move(place), std::move(turn));
}

}  // namespace thigma::detail
