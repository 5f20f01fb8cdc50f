#include "thigma/device/open_device.h"

#include <algorithm>
#include <utility>

#include "thigma/core/edit_distance.h"
#include "thigma/device/detail/address.h"
#include "thigma/device/detail/bubble_device.h"
#include "thigma/device/detail/camera_device.h"
#include "thigma/device/detail/dhd_device.h"
#include "thigma/device/detail/gamepad_device.h"
#include "thigma/device/detail/hand_address.h"
#include "thigma/device/detail/haply_device.h"
#include "thigma/device/detail/openhaptics_device.h"
#include "thigma/device/detail/rotated_device.h"
#include "thigma/device/detail/spacenav_device.h"
#include "thigma/device/detail/vrpn_device.h"
#include "thigma/device/null_device.h"
#include "thigma/device/script.h"

namespace thigma {
namespace {

using detail::quoted;

using Device = std::unique_ptr<HapticDevice>;
using Parameters = std::vector<DeviceParameter>;

/// What follows the colon, which is a query or nothing.
std::string_view query_of(const std::string& scheme, std::string_view rest) {
  if (rest.empty()) return rest;
  if (rest.front() != '?')
    throw DeviceAddressError(scheme + " " + quoted(rest) + ", expected ?name=value&name=value");
  return rest.substr(1);
}

Device open_hand(const std::string& rest, const DeviceContext& context) {
  return make_hand(parse_hand(query_of("hand:", rest), context));
}

Device open_script(const std::string& rest, const DeviceContext&) {
  if (rest.empty()) throw DeviceAddressError("script: no file, expected script:FILE");
  return make_script_device(read_script(rest));
}

Device open_web(const std::string&, const DeviceContext&) {
  throw DeviceUnavailable("web: is opened with its page, use `thigma run`");
}

Device open_replay(const std::string&, const DeviceContext&) {
  throw DeviceUnavailable("replay: is opened with its recording, use `thigma replay FILE`");
}

Device open_null(const std::string& rest, const DeviceContext&) {
  bool clutch = true;
  for (const auto& [name, value] : detail::split_query(query_of("null:", rest), "null:")) {
    if (name != "clutch") detail::unknown_name("null:", name, {"clutch"});
    clutch = detail::parse_flag("null:", name, value);
  }
  return make_null_device(clutch);
}

Parameters no_parameters() { return {}; }
Parameters null_parameters() { return {{"clutch", "", "1", "0 or 1: held or not"}}; }

/// A kind of address: all that is known of it here.
struct Scheme {
  std::string_view name;  // with the colon
  const char* meaning;
  // what follows the colon, and the scene; throws as open_device
  Device (*open)(const std::string& rest, const DeviceContext& context);
  Parameters (*parameters)() = no_parameters;
  std::string_view form{};  // of the address, where it is more than the name
  std::vector<std::string> (*plugged)() = nullptr;  // addresses; throws as open. Null: nobody knows
  // null: nothing to do
  void (*calibrate)(const std::string& rest, const CalibrationTalk& talk) = nullptr;
  const char* if_killed = "";
};

constexpr Scheme kSchemes[] = {
    {"hand:", "simulated hand holding a simulated device", open_hand, detail::hand_parameters},
    {"script:", "timed poses from a file: script:FILE with columns t,x,y,z,qx,qy,qz,qw[,buttons]",
     open_script, no_parameters, "script:FILE"},
    {"web:", "mouse or gamepad in the browser page", open_web},
    {"replay:", "the device samples of a recording: replay:FILE", open_replay, no_parameters,
     "replay:FILE"},
    {"null:", "a handle that never moves", open_null, null_parameters},
    {"openhaptics:", "3D Systems Touch and Phantom (libHD.so): openhaptics:NAME",
     detail::open_openhaptics, no_parameters, "openhaptics:NAME", detail::plugged_openhaptics,
     detail::calibrate_openhaptics,
     "the last force may stay, no time-out is documented: keep a hand on the switch"},
    {"dhd:", "Force Dimension omega, delta, sigma, lambda; Novint Falcon (libdrd.so): dhd:NUMBER",
     detail::open_dhd, no_parameters, "dhd:NUMBER", detail::plugged_dhd, detail::calibrate_dhd,
     "the device's watchdog cuts its forces, within 32 ms; its factory value is not documented"},
    {"haply:", "Haply Inverse3, Inverse3x, Minverse (Inverse Service): haply:ID",
     detail::open_haply, detail::haply_parameters, "haply:ID", detail::plugged_haply, nullptr,
     "the session of the service ends with its connection and the device idles; no time is "
     "documented"},
    {"vrpn:", "tracker and force device of a VRPN server: vrpn:NAME@HOST", detail::open_vrpn,
     detail::vrpn_parameters, "vrpn:NAME@HOST", nullptr, nullptr,
     "the field of force may stay at the server, as far as its radius; a Phantom's server ends it"},
    {"spacenav:",
     "SpaceMouse without force (spacenavd)",
     detail::open_spacenav,
     detail::spacenav_parameters,
     {},
     detail::plugged_spacenav},
    {"gamepad:", "gamepad without force: gamepad:NUMBER", detail::open_gamepad,
     detail::gamepad_parameters, "gamepad:NUMBER", detail::plugged_gamepads}};

constexpr std::size_t kTypingError = 2;  // letters; a name farther off was another one

[[noreturn]] void refuse(const std::string& address, const std::string& scheme) {
  std::vector<std::string_view> names;
  std::string forms;
  for (const Scheme& known : kSchemes) {
    names.push_back(known.name);
    forms += forms.empty() ? "" : ", ";
    forms += known.form.empty() ? known.name : known.form;
  }
  if (scheme.empty())
    throw DeviceAddressError("device " + quoted(address) + " has no scheme, expected one of " +
                             forms);
  const std::string_view nearest = detail::nearest_name(scheme, names);
  const bool is_near = edit_distance(scheme, nearest) <= kTypingError;
  throw DeviceUnavailable(
      "no device " + quoted(scheme) +
      (is_near ? ", nearest is " + quoted(nearest) : ", expected one of " + forms));
}

/// The row of an address; refuses it where there is none.
const Scheme& scheme_of(const std::string& address) {
  const std::size_t colon = address.find(':');
  const std::string name = colon == std::string::npos ? "" : address.substr(0, colon + 1);
  for (const Scheme& scheme : kSchemes) {
    if (scheme.name == name) return scheme;
  }
  refuse(address, name);
}

/// Takes a second device's address, behind `name`, off the end of an address; "" where there is
/// none.
std::string take_second(std::string_view name, std::string& address) {
  const std::size_t at = address.find(name);
  if (at == std::string::npos || at == 0 || (address[at - 1] != '?' && address[at - 1] != '&'))
    return "";
  const std::string second = address.substr(at + name.size());
  if (second.empty())
    throw DeviceAddressError(std::string(name) + " has no value, expected a device, as spacenav:");
  address.erase(at - 1);
  return second;
}

/// Takes one parameter out of an address; its value, "" where there is none.
std::string take_parameter(const std::string& name, std::string& address) {
  for (std::size_t at = address.find('?'); at != std::string::npos;
       at = address.find('&', at + 1)) {
    if (address.compare(at + 1, name.size() + 1, name + "=") != 0) continue;
    const std::size_t begin = at + name.size() + 2;
    const std::size_t end = std::min(address.find('&', begin), address.size());
    const std::string value = address.substr(begin, end - begin);
    if (value.empty()) throw DeviceAddressError(name + "= has no value");
    // Of the marks before and behind it, one stays where more follow.
    const bool is_last = end == address.size();
    address.erase(is_last ? at : at + 1, end - at);
    return value;
  }
  return "";
}

double parse_bubble(const std::string& text) {
  const double radius = detail::parse_value("device", "bubble", text);
  if (radius >= detail::kLeastBubble && radius <= detail::kMostBubble) return radius;
  throw DeviceAddressError("bubble = " + quoted(text) + ", expected " +
                           detail::shortest(detail::kLeastBubble) + " to " +
                           detail::shortest(detail::kMostBubble) + " m");
}

std::string rest_of(const std::string& address) { return address.substr(address.find(':') + 1); }

}  // namespace

std::string device_scheme(std::string_view address) {
  const std::size_t colon = address.find(':');
  return colon == std::string_view::npos ? std::string() : std::string(address.substr(0, colon));
}

std::unique_ptr<HapticDevice> open_device(const std::string& address,
                                          const DeviceContext& context) {
  // The last parameters, because the addresses behind them may have their own.
  std::string place = address;
  take_second("camera=", place);
  const std::string turner = take_second("rotation=", place);
  const std::string bubble = take_parameter("bubble", place);
  const Scheme& scheme = scheme_of(place);
  const double radius = bubble.empty() ? 0.0 : parse_bubble(bubble);
  Device device = scheme.open(rest_of(place), context);
  if (!bubble.empty()) device = detail::make_bubble_device(std::move(device), radius);
  if (!turner.empty())
    device = detail::make_rotated_device(std::move(device), open_device(turner, context));
  return add_camera(std::move(device), address, context);
}

std::unique_ptr<HapticDevice> add_camera(std::unique_ptr<HapticDevice> device,
                                         const std::string& address, const DeviceContext& context) {
  std::string place = address;
  const std::string viewer = take_second("camera=", place);
  if (viewer.empty()) return device;
  return detail::make_camera_device(std::move(device), open_device(viewer, context));
}

std::vector<std::string> plugged_devices(const std::string& scheme, std::string* why) {
  for (const Scheme& known : kSchemes) {
    if (known.name != scheme || known.plugged == nullptr) continue;
    try {
      return known.plugged();
    } catch (const DeviceUnavailable& error) {
      if (why != nullptr) *why = error.what();
      return {};
    }
  }
  return {};
}

void calibrate_device(const std::string& address, const CalibrationTalk& talk) {
  const Scheme& scheme = scheme_of(address);
  if (scheme.calibrate == nullptr)
    throw DeviceUnavailable(std::string(scheme.name) + " has nothing to calibrate");
  scheme.calibrate(rest_of(address), talk);
}

std::vector<DeviceScheme> device_schemes() {
  std::vector<DeviceScheme> schemes;
  for (const Scheme& scheme : kSchemes)
    schemes.push_back(
        {std::string(scheme.name), scheme.meaning, scheme.parameters(), scheme.if_killed});
  return schemes;
}

}  // namespace thigma
