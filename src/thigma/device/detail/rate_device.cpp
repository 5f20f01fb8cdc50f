#include "thigma/device/detail/rate_device.h"

#include <algorithm>
#include <cmath>

#include "thigma/device/detail/address.h"
#include "thigma/device/detail/pose_follower.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kQuick = 50.0;  // velocities follow with this frequency [rad/s]
constexpr double kReach = 1.0;   // the handle stays within this of its origin, by axes [m]

DeviceLimits rate_limits() {
  DeviceLimits limits;
  limits.max_force = 8.5;  // as of a desktop device, so that scenes feel alike; shown, never sent
  limits.max_torque = 0.188;
  limits.max_stiffness = 1000.0;
  limits.max_angular_stiffness = 0.6;
  limits.workspace_radius = kReach;
  limits.actuates_translation = limits.actuates_rotation = false;
  limits.holds_person = false;  // it has no motors
  limits.delay = 1.0 / kQuick;
  return limits;
}

double rate_of(const std::string& scheme, const std::string& name, const std::string& text,
               double most) {
  const double value = parse_value(scheme, name, text);
  if (value > 0.0 && value <= most) return value;
  throw DeviceAddressError(scheme + " " + name + " = " + quoted(text) +
                           ", expected above 0, at most " + shortest(most));
}

}  // namespace

bool take_rate_parameter(const std::string& scheme, const std::string& name,
                         const std::string& value, RateParams& params) {
  if (name == "speed") {
    params.speed = rate_of(scheme, name, value, 1.0);
  } else if (name == "turn") {
    params.turn = rate_of(scheme, name, value, 10.0);
  } else if (name == "hold") {
    params.is_held = parse_flag(scheme, name, value);
  } else {
    return false;
  }
  return true;
}

std::vector<DeviceParameter> rate_parameters() {
  return {{"speed", "m/s", "0.1", "at full deflection"},
          {"turn", "rad/s", "1", "at full deflection"},
          {"hold", "", "1", "1: its first button lets go; 0: it takes hold"}};
}

RateDevice::RateDevice(std::string name, const RateParams& params, LinkTalk talk)
    : name_(std::move(name)),
      limits_(rate_limits()),
      is_held_(params.is_held),
      link_(std::move(talk)) {}

DeviceState RateDevice::read(double now) THIGMA_RT {
  const double h = is_begun_ ? step_of(now - last_read_) : 0.0;
  is_begun_ = true;
  last_read_ = now;
  LinkEnds& ends = link_.ends();
  ends.samples.fetch();
  const LinkSample& sample = ends.samples.value();
  Motion& motion = last_.motion;
  const double share = 1.0 - exponential(-kQuick * h);
  motion.twist.linear += share * (sample.motion.twist.linear - motion.twist.linear);
  motion.twist.angular += share * (sample.motion.twist.angular - motion.twist.angular);
  for (int i = 0; i < 3; ++i) {
    double& place = motion.pose.position[i];
    const double wanted = place + h * motion.twist.linear[i];
    place = std::clamp(wanted, -kReach, kReach);
    if (place != wanted) motion.twist.linear[i] = 0.0;
  }
  motion.pose.orientation =
      (rotation_from_vector(h * motion.twist.angular) * motion.pose.orientation).normalized();
  last_.time = now;
  last_.buttons = is_held_ ? sample.buttons ^ kClutchButton : sample.buttons;
  last_.status = ends.trouble.is_lost() ? DeviceStatus::lost : DeviceStatus::ok;
  return last_;
}

double beyond_dead_zone(double value, double dead) {
  const double beyond = std::abs(value) - dead;
  if (!(beyond > 0.0)) return 0.0;
  return std::copysign(std::min(1.0, beyond / (1.0 - dead)), value);
}

}  // namespace thigma::detail
