#include "thigma/device/null_device.h"

namespace thigma {
namespace {

class NullDevice final : public HapticDevice {
 public:
  NullDevice(bool clutch, const DeviceLimits& limits)
      : limits_(limits), buttons_(clutch ? kClutchButton : 0u) {
    limits_.holds_person = false;
  }

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "null"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    state.buttons = buttons_;
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  DeviceLimits limits_;
  std::uint32_t buttons_;
};

}  // namespace

std::unique_ptr<HapticDevice> make_null_device(bool clutch, const DeviceLimits& limits) {
  return std::make_unique<NullDevice>(clutch, limits);
}

}  // namespace thigma
