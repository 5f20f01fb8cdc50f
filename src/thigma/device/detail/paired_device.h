#pragma once
// A device beside another one, which tells more of the hand and takes no force.

#include <memory>
#include <string>
#include <utility>

#include "thigma/device/haptic_device.h"

namespace thigma::detail {

/// All of the first but read, which says what is taken of the second.
class PairedDevice : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return first_->limits(); }
  std::string name() const override { return first_->name() + between_ + second_->name(); }
  const char* trouble() const THIGMA_RT override {
    const char* const own = first_->trouble();
    return *own != '\0' ? own : second_->trouble();
  }
  void write(const Wrench& wrench) THIGMA_RT override { first_->write(wrench); }
  void start_ticks(double rate, DeviceTick tick) override { first_->start_ticks(rate, tick); }
  void stop_ticks() noexcept override { first_->stop_ticks(); }

 protected:
  /// between   of the two names, in that of the pair
  PairedDevice(std::unique_ptr<HapticDevice> first, std::unique_ptr<HapticDevice> second,
               const char* between)
      : first_(std::move(first)), second_(std::move(second)), between_(between) {}

  const std::unique_ptr<HapticDevice> first_, second_;

 private:
  const char* between_;
};

/// Whether a device may stand second: without motors, and at the pace of the first.
inline bool may_stand_second(const DeviceLimits& limits) {
  return !limits.holds_person && limits.clock != DeviceClock::device;
}

}  // namespace thigma::detail
