#include "thigma/device/replay.h"

#include <utility>

namespace thigma {
namespace {

class ReplayDevice final : public HapticDevice {
 public:
  ReplayDevice(std::vector<DeviceState> samples, const DeviceLimits& limits)
      : samples_(std::move(samples)), limits_(limits) {
    limits_.holds_person = false;         // whoever was held when it was recorded
    limits_.clock = DeviceClock::engine;  // whoever set the pace then
  }

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "replay"; }
  DeviceState read(double now) THIGMA_RT override {
    if (next_ < samples_.size()) return samples_[next_++];
    DeviceState last;
    last.time = now;
    if (!samples_.empty()) last = samples_.back();
    last.status = DeviceStatus::finished;
    return last;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  std::vector<DeviceState> samples_;
  DeviceLimits limits_;
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<HapticDevice> make_replay_device(std::vector<DeviceState> samples,
                                                 const DeviceLimits& limits) {
  return std::make_unique<ReplayDevice>(std::move(samples), limits);
}

}  // namespace thigma
