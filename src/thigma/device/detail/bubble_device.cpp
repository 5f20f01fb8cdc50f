#include "thigma/device/detail/bubble_device.h"

#include "thigma/device/detail/pose_follower.h"

namespace thigma::detail {
namespace {

constexpr double kRate = 5.0;       // drift over the way outside [1/s]
constexpr double kMostDrift = 0.2;  // [m/s; device space]

class BubbleDevice final : public HapticDevice {
 public:
  BubbleDevice(std::unique_ptr<HapticDevice> device, double radius)
      : device_(std::move(device)), radius_(radius), limits_(device_->limits()) {}

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return device_->name() + ", in a bubble"; }
  const char* trouble() const THIGMA_RT override { return device_->trouble(); }

  DeviceState read(double now) THIGMA_RT override {
    DeviceState state = device_->read(now);
    const double h = is_begun_ ? step_of(now - last_read_) : 0.0;
    is_begun_ = true;
    last_read_ = now;
    const bool is_held = (state.buttons & kClutchButton) != 0;
    const Vec3& place = state.motion.pose.position;
    if (is_held && !was_held_) centre_ = place;
    was_held_ = is_held;
    const Vec3 drift =
        is_held && state.status == DeviceStatus::ok ? drift_at(place) : Vec3(Vec3::Zero());
    offset_ += h * drift;
    state.motion.pose.position += offset_;
    state.motion.twist.linear += drift;
    if (state.has_true_handle) state.true_handle.position += offset_;
    return state;
  }

  void write(const Wrench& wrench) THIGMA_RT override { device_->write(wrench); }
  void start_ticks(double rate, DeviceTick tick) override { device_->start_ticks(rate, tick); }
  void stop_ticks() noexcept override { device_->stop_ticks(); }

 private:
  Vec3 drift_at(const Vec3& place) const THIGMA_RT {
    const Vec3 from_centre = place - centre_;
    const double beyond = from_centre.norm() - radius_;
    if (!(beyond > 0.0)) return Vec3::Zero();
    return at_most(Vec3((kRate * beyond / (beyond + radius_)) * from_centre), kMostDrift);
  }

  const std::unique_ptr<HapticDevice> device_;
  const double radius_;
  const DeviceLimits limits_;
  Vec3 centre_ = Vec3::Zero(), offset_ = Vec3::Zero();
  double last_read_ = 0.0;
  bool was_held_ = false, is_begun_ = false;
};

}  // namespace

std::unique_ptr<HapticDevice> make_bubble_device(std::unique_ptr<HapticDevice> device,
                                                 double radius) {
  return std::make_unique<BubbleDevice>(std::move(device), radius);
}

}  // namespace thigma::detail
