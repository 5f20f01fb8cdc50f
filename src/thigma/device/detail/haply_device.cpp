#include "thigma/device/detail/haply_device.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/error.h"
#include "thigma/device/detail/address.h"
#include "thigma/device/detail/haply_link.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr double kReady = 3.0;  // a device may take this long to be calibrated and ready [s]

double value_between(const std::string& name, const std::string& text, double least, double most) {
  const double value = parse_value("haply:", name, text);
  if (value >= least && value <= most) return value;
  throw DeviceAddressError("haply: " + name + " = " + quoted(text) + ", expected " +
                           shortest(least) + " to " + shortest(most));
}

HaplyAddress parse_address(const std::string& rest) {
  HaplyAddress address;
  const std::size_t mark = rest.find('?');
  address.id = rest.substr(0, mark);
  if (mark == std::string::npos) return address;
  for (const auto& [name, value] : split_query(std::string_view(rest).substr(mark + 1), "haply:")) {
    if (name == "host") {
      address.host = parse_host("haply:", name, value);
    } else if (name == "port") {
      address.port = static_cast<std::uint16_t>(value_between(name, value, 1, 65535));
    } else if (name == "grip") {
      address.grip = value;
    } else if (name == "hold") {
      address.hold = parse_flag("haply:", name, value) ? 1 : 0;
    } else if (name == "rate") {
      address.rate = value_between(name, value, 100, 10000);
    } else if (name == "max_force") {
      address.max_force = value_between(name, value, 0.1, 10);
    } else {
      unknown_name("haply:", name, {"host", "port", "grip", "hold", "rate", "max_force"});
    }
  }
  return address;
}

std::string list_of(const HaplyFrame& frame) {
  std::string ids;
  for (const HaplyArm& arm : frame.arms) ids += (ids.empty() ? "" : ", ") + quoted(arm.id);
  return ids;
}

/// The arm of an address; refuses what cannot be used, with what to do.
const HaplyArm& usable_arm(const HaplyFrame& frame, const HaplyAddress& address) {
  if (frame.arms.empty())
    throw DeviceUnavailable(
        "haply: the Inverse Service has no device. Plug it in, with its power supply.");
  const HaplyArm* arm = find_arm(frame, address.id);
  if (arm == nullptr)
    throw DeviceUnavailable("haply: no device " + quoted(address.id) +
                            ", the Inverse Service has " + list_of(frame) + ".");
  if (address.id.empty() && frame.arms.size() > 1)
    throw DeviceUnavailable("haply: the Inverse Service has " + list_of(frame) +
                            ". Name one of them, as haply:" + arm->id + ".");
  const auto is_other = [arm](const HaplyArm& other) {
    return &other != arm && other.id == arm->id;
  };
  if (std::any_of(frame.arms.begin(), frame.arms.end(), is_other))
    throw DeviceUnavailable("haply: the Inverse Service has two devices " + quoted(arm->id) +
                            ". Unplug one of them.");
  if (arm->has_own_axes)
    throw DeviceUnavailable("haply: the service turns or scales the axes of " + quoted(arm->id) +
                            ". Set its basis, mount and transform back in the Haply Hub.");
  return *arm;
}

/// Says zero until the device is calibrated and ready.
void wait_until_ready(HaplyLink& link, const HaplyAddress& address) {
  const int most = static_cast<int>(kReady / 0.01);
  for (int i = 0;; ++i) {
    const HaplyArm* arm = find_arm(link.frame(), address.id);
    if (arm != nullptr && arm->is_calibrated && arm->is_ready) return;
    if (i == most) {
      const bool is_raw = arm != nullptr && !arm->is_calibrated;
      throw DeviceUnavailable(
          is_raw ? "haply: the device is not calibrated. Put the grip onto its inkwell and wait "
                   "until the light stays on."
                 : "haply: the device is not ready. Switch it on, and end other programs that use "
                   "it.");
    }
    link.send(address.id, Vec3::Zero());
    if (!link.wait(1.0)) throw IoError("the service does not answer");
    usleep(10'000);
  }
}

/// Mean time from a message to its answer [s].
double measure_round_trip(HaplyLink& link, const HaplyAddress& address) {
  constexpr int kTrips = 20;
  const std::int64_t begin = driver_time_ns();
  for (int i = 0; i < kTrips; ++i) {
    link.send(address.id, Vec3::Zero());
    if (!link.wait(1.0)) throw IoError("the service does not answer");
  }
  return 1e-9 * static_cast<double>(driver_time_ns() - begin) / kTrips;
}

/// round_trip  as measured [s]: what a read returns is that old, and the time between two messages
DeviceLimits limits_of(const HaplyArm& arm, const HaplyAddress& address, bool turns,
                       double round_trip) {
  DeviceLimits limits;
  const bool is_small = arm.type == "minverse";
  limits.max_force = std::min(address.max_force, is_small ? 2.0 : 10.0);
  limits.max_torque = 0.0;
  limits.max_stiffness = 1000.0;
  limits.max_angular_stiffness = 0.0;
  limits.workspace_radius = is_small ? 0.04 : 0.10;
  limits.senses_rotation = turns;
  limits.actuates_rotation = false;
  limits.delay = round_trip + std::max(round_trip, 1.0 / address.rate);
  return limits;
}

}  // namespace

std::unique_ptr<HapticDevice> open_haply(const std::string& rest, const DeviceContext&) {
  HaplyAddress address = parse_address(rest);
  auto link = std::make_shared<HaplyLink>(address);
  const HaplyArm arm = usable_arm(link->frame(), address);
  address.id = arm.id;
  const HaplyGrip* grip = find_grip(link->frame(), address.grip);
  if (grip == nullptr && !address.grip.empty() && address.grip != "none")
    throw DeviceUnavailable("haply: no VerseGrip " + quoted(address.grip) +
                            ". Switch it on and pair it in the Haply Hub.");
  const bool turns = grip != nullptr && grip->has_orientation;
  if (address.hold < 0) address.hold = grip != nullptr && grip->has_buttons ? 0 : 1;
  address.grip = grip != nullptr ? grip->id : "none";
  double round_trip = 0.0;
  try {
    wait_until_ready(*link, address);
    round_trip = measure_round_trip(*link, address);
  } catch (const IoError& error) {
    throw DeviceUnavailable(std::string("haply: ") + error.what() + ". Restart the service.");
  }
  return std::make_unique<LinkDevice>(
      "haply: " + (arm.type.empty() ? "inverse3" : arm.type) + " " + arm.id,
      limits_of(arm, address, turns, round_trip), false,
      [link, address](LinkEnds& ends) { speak_with_haply(*link, address, ends); });
}

std::vector<std::string> plugged_haply() {
  HaplyLink link{HaplyAddress{}};
  std::vector<std::string> addresses;
  for (const HaplyArm& arm : link.frame().arms) addresses.push_back("haply:" + arm.id);
  link.close();
  return addresses;
}

std::vector<DeviceParameter> haply_parameters() {
  return {{"host", "", "localhost", "where the Inverse Service runs"},
          {"port", "", "10001", "its WebSocket and HTTP port"},
          {"grip", "", "the first", "id of the VerseGrip that turns the object, or none"},
          {"hold", "", "0", "1: the hand always holds; as without a VerseGrip"},
          {"rate", "Hz", "2000", "messages a second at most"},
          {"max_force", "N", "4", "of the device, norm"}};
}

}  // namespace thigma::detail
