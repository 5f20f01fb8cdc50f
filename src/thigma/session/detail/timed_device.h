#pragma once
// How long a device takes, for the histograms of a threaded session.

#include "thigma/device/haptic_device.h"
#include "thigma/session/rt_thread.h"

namespace thigma::detail {

/// Passes everything through and keeps the last call's length. Thread: as the device's.
class TimedDevice final : public HapticDevice {
 public:
  explicit TimedDevice(HapticDevice& inner) : inner_(inner) {}
  const DeviceLimits& limits() const override { return inner_.limits(); }
  std::string name() const override { return inner_.name(); }
  const char* trouble() const THIGMA_RT override { return inner_.trouble(); }
  DeviceState read(double now) THIGMA_RT override {
    const std::int64_t begin = monotonic_ns();
    const DeviceState state = inner_.read(now);
    read_ns = monotonic_ns() - begin;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    const std::int64_t begin = monotonic_ns();
    inner_.write(wrench);
    write_ns = monotonic_ns() - begin;
  }

  std::int64_t read_ns = 0, write_ns = 0;

 private:
  HapticDevice& inner_;
};

}  // namespace thigma::detail
