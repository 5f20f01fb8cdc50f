#pragma once
// A device that is pushed to move, without force: its deflection is a velocity. A SpaceMouse or a
// gamepad, alone or for the rotation of another device.

#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "thigma/device/detail/link_device.h"

namespace thigma {

struct DeviceParameter;

namespace detail {

/// How deflections become motion.
struct RateParams {
  double speed = 0.10;  // at full deflection [m/s; device space]
  double turn = 1.0;    // the same [rad/s]
  bool is_held = true;  // the hand holds unless the first button is pressed; else while it is
};

/// Takes one of "speed", "turn" and "hold"; false where the name is another.
/// errors   DeviceAddressError
/// Thread   [offline].
bool take_rate_parameter(const std::string& scheme, const std::string& name,
                         const std::string& value, RateParams& params);

/// The three of them, for `thigma devices`.
std::vector<DeviceParameter> rate_parameters();

/// The handle goes on from the origin with the velocity that the link's samples tell; velocities
/// follow within 20 ms, so that a step of a deflection is none of the handle.
class RateDevice final : public HapticDevice {
 public:
  /// talk  publishes samples whose motion.twist is the velocity
  RateDevice(std::string name, const RateParams& params, LinkTalk talk);

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return name_; }
  const char* trouble() const THIGMA_RT override { return link_.ends().trouble.text(); }
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench&) THIGMA_RT override {}

 private:
  const std::string name_;
  const DeviceLimits limits_;
  const bool is_held_;
  DeviceState last_;
  double last_read_ = 0.0;
  bool is_begun_ = false;
  const LinkThread link_;
};

/// A deflection beyond a dead zone, from -1 to 1.
///
/// value  from -1 to 1
/// dead   of it nothing comes [0 to 1)
double beyond_dead_zone(double value, double dead);

}  // namespace detail
}  // namespace thigma
