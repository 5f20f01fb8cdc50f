#include "thigma/device/detail/vrpn_device.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/error.h"
#include "thigma/device/detail/address.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/detail/vrpn_link.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr const char* kForm = "expected vrpn:NAME@HOST or vrpn:NAME@HOST:PORT";

[[noreturn]] void refuse(const std::string& what) { throw DeviceAddressError("vrpn: " + what); }

double value_between(const std::string& name, const std::string& text, double least, double most) {
  const double value = parse_value("vrpn:", name, text);
  if (value >= least && value <= most) return value;
  refuse(name + " = " + quoted(text) + ", expected " + shortest(least) + " to " + shortest(most));
}

void parse_place(const std::string& place, VrpnAddress& address) {
  const std::size_t at = place.rfind('@');
  if (at == std::string::npos || at == 0 || at + 1 == place.size() || at > 99)
    refuse(quoted(place) + ", " + kForm);
  address.name = place.substr(0, at);
  address.host = place.substr(at + 1);
  const std::size_t colon = address.host.rfind(':');
  if (colon != std::string::npos) {
    const std::string port = address.host.substr(colon + 1);
    address.host.erase(colon);
    address.port = static_cast<std::uint16_t>(value_between("port", port, 1, 65535));
  }
  parse_host("vrpn:", "host", address.host);
}

VrpnAddress parse_address(const std::string& rest) {
  VrpnAddress address;
  parse_axes("zxy", address.axes);
  const std::size_t mark = rest.find('?');
  parse_place(rest.substr(0, mark), address);
  if (mark == std::string::npos) return address;
  for (const auto& [name, value] : split_query(std::string_view(rest).substr(mark + 1), "vrpn:")) {
    if (name == "sensor") {
      address.sensor = static_cast<int>(value_between(name, value, 0, 1000));
    } else if (name == "axes") {
      const std::string fault = parse_axes(value, address.axes);
      if (!fault.empty()) refuse(fault);
    } else if (name == "force") {
      address.has_force = parse_flag("vrpn:", name, value);
    } else if (name == "hold") {
      address.is_held = parse_flag("vrpn:", name, value);
    } else if (name == "radius") {
      address.radius = value_between(name, value, 0.001, 0.1);
    } else if (name == "max_force") {
      address.max_force = value_between(name, value, 0.1, 40);
    } else {
      unknown_name("vrpn:", name, {"sensor", "axes", "force", "hold", "radius", "max_force"});
    }
  }
  return address;
}

/// Mean time between poses; as long as was waited where no second one came [s].
double measure_interval(VrpnLink& link) {
  constexpr std::int64_t kMost = 300'000'000;
  constexpr std::uint64_t kPoses = 50;
  const std::int64_t begin = driver_time_ns();
  const std::uint64_t first = link.poses();
  while (link.poses() - first < kPoses && driver_time_ns() - begin < kMost) link.hear_poses(0.02);
  const double seconds = 1e-9 * static_cast<double>(driver_time_ns() - begin);
  return seconds / static_cast<double>(std::max<std::uint64_t>(1, link.poses() - first));
}

/// interval  between poses [s]: what a read returns is one old, and what smooths it as much
DeviceLimits limits_of(const VrpnAddress& address, double interval) {
  DeviceLimits limits;
  limits.max_force = address.max_force;
  limits.max_torque = 0.1;  // shown, never sent: there is no such message
  limits.max_stiffness = 500.0;
  limits.actuates_translation = limits.holds_person = address.has_force;
  limits.actuates_rotation = false;
  limits.delay = 0.001 + 2.0 * interval;
  return limits;
}

/// Waits for the device's name and its first pose.
void wait_for_pose(VrpnLink& link, const VrpnAddress& address) {
  constexpr std::int64_t kMost = 3'000'000'000;
  const std::int64_t end = driver_time_ns() + kMost;
  const std::string place = "vrpn: " + address.host + ":" + std::to_string(address.port) + ": ";
  try {
    while (link.poses() == 0 && driver_time_ns() < end) link.hear_poses(0.05);
  } catch (const IoError& error) {
    throw DeviceUnavailable(place + error.what() + ". Is it a VRPN server? Restart it.");
  }
  if (link.poses() > 0) return;
  const std::string names = link.senders();
  if (!link.knows_device())
    throw DeviceUnavailable(place + "the server has no " + quoted(address.name) +
                            (names.empty() ? ". It names none." : ". It has " + names + "."));
  throw DeviceUnavailable(place + quoted(address.name) + " tells no pose of sensor " +
                          std::to_string(address.sensor) +
                          ". Is it switched on? Name another with ?sensor=.");
}

}  // namespace

std::string parse_axes(const std::string& word, Mat3& axes) {
  Mat3 parsed = Mat3::Zero();
  int row = 0;
  bool is_right = true;
  double sign = 1.0;
  for (const char c : word) {
    if (c == '-' && sign > 0.0) {
      sign = -1.0;
      continue;
    }
    is_right = is_right && c >= 'x' && c <= 'z' && row < 3;
    if (!is_right) break;
    parsed(row++, c - 'x') = sign;
    sign = 1.0;
  }
  const double determinant = parsed.determinant();
  if (!is_right || row != 3 || sign < 0.0 || determinant == 0.0)
    return "axes = " + quoted(word) + ", expected x, y and z once each, as zxy or -yxz";
  if (determinant < 0.0) return "axes = " + quoted(word) + " mirror, turn one of them round";
  axes = parsed;
  return "";
}

std::unique_ptr<HapticDevice> open_vrpn(const std::string& rest, const DeviceContext&) {
  const VrpnAddress address = parse_address(rest);
  const auto link = std::make_shared<VrpnLink>(address);
  wait_for_pose(*link, address);
  double interval = 0.0;
  try {
    interval = measure_interval(*link);
  } catch (const IoError& error) {
    throw DeviceUnavailable("vrpn: " + address.host + ": " + error.what() + ". Restart it.");
  }
  return std::make_unique<LinkDevice>(
      "vrpn: " + address.name + "@" + address.host, limits_of(address, interval),
      !address.has_force,
      [link, address](LinkEnds& ends) { speak_with_vrpn(*link, address, ends); });
}

std::vector<DeviceParameter> vrpn_parameters() {
  return {{"sensor", "", "0", "of the tracker"},
          {"axes", "", "zxy", "which of its axes are to the person, right and up; - turns one"},
          {"force", "", "1", "0: a tracker without force"},
          {"hold", "", "0", "1: the hand always holds; for trackers without buttons"},
          {"radius", "m", "0.02", "of the local force field: no force beyond it"},
          {"max_force", "N", "3.3", "of the device, norm"}};
}

}  // namespace thigma::detail
