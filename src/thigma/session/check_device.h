#pragma once
// What a device does while nothing is asked of it: rates, noise at rest, axes, buttons; and the
// rules that every driver keeps. Behind `thigma devices check`.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"
#include "thigma/session/histogram.h"

namespace thigma {

/// How a device is looked at.
struct DeviceCheckParams {
  double rate = 1000.0;  // of the frames [Hz]
  double seconds = 3.0;
};

/// One rule of drivers.
struct DeviceRule {
  const char* rule = "";
  bool holds = true;
  std::string found;  // a number or a word, for a person
};

/// What was found.
struct DeviceReport {
  std::string device, trouble;  // trouble: as HapticDevice::trouble
  std::uint64_t frames = 0;
  double rate = 0.0;       // of the frames that were made [Hz]
  double new_share = 0.0;  // of the frames, those with another pose than the one before
  DurationSummary late;    // intervals between frames beyond the period [s]
  DurationSummary read, write;
  double noise = 0.0;  // of the position in the stillest quarter second, standard deviation [m]
  double turn_noise = 0.0;                             // of the orientation, the same [rad]
  Vec3 least = Vec3::Zero(), greatest = Vec3::Zero();  // of the position [m; device frame]
  double speed_max = 0.0;                              // reported [m/s]
  std::uint32_t buttons = 0;                           // seen pressed
  std::vector<DeviceRule> rules;
  bool is_conforming() const {
    for (const DeviceRule& rule : rules) {
      if (!rule.holds) return false;
    }
    return true;
  }
};

/// Reads the device and sends zero for a while, on the clock that owns the pace.
///
/// device   no session has it
/// params   rate 1 to 100,000 Hz, seconds above 0
/// stop     null, or ends it early
/// returns  the report; rules that need a hand's motion hold where nothing moved
/// errors   DeviceUnavailable of a device that owns the clock and does not start
/// Thread   [offline].
DeviceReport check_device(HapticDevice& device, const DeviceCheckParams& params = {},
                          const std::atomic<bool>* stop = nullptr);

}  // namespace thigma
