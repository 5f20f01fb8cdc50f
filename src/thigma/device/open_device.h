#pragma once
// A device from its address, as `thigma run --device` takes it.

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

struct HandParams;

/// What a scene tells a simulated device. All in device space, that is after the motion scale.
struct DeviceContext {
  Pose start;  // handle pose at the start; objects are separated there [device frame]
  // any length > 0: from the grasped object toward the scene [device frame]
  Vec3 approach = -Vec3::UnitZ();
  double clearance = 0.02;      // travel along approach to first touch [m]
  double object_radius = 0.05;  // of the grasped object [m]
  std::uint64_t seed = 1;       // of tremor and jitter, unless the address has its own
};

/// A device address that cannot be understood: no scheme, unknown parameter or value. Wrong usage,
/// exit code 2.
class DeviceAddressError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// A device that is not plugged in, not loadable or unknown here. Exit code 3.
class DeviceUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Opens a device, with parameters as "?name=value&name=value" (device_schemes lists them).
/// "replay:FILE" and "web:" are opened by recording/ and session/, which know recordings and
/// threads. Every address takes two more: "bubble=RADIUS" [m] has the handle stand for a velocity
/// outside a bubble about where the hand took hold; "rotation=ADDRESS", the last one, names a
/// second device without motors for the rotation of one that senses none, as
/// "dhd:0?rotation=spacenav:". Behind that, "camera=ADDRESS" names one that moves the view.
///
/// errors   DeviceAddressError, DeviceUnavailable, InputError (a script file); one line each
/// Thread   [offline].
std::unique_ptr<HapticDevice> open_device(const std::string& address,
                                          const DeviceContext& context = {});

/// The device with the second one of "camera=" of its address, or as it is; for who opens "web:"
/// itself. Errors and thread as open_device.
std::unique_ptr<HapticDevice> add_camera(std::unique_ptr<HapticDevice> device,
                                         const std::string& address,
                                         const DeviceContext& context = {});

/// Parameters of a hand as "hand:?..." and a context give them; errors as open_device.
/// Thread    [offline].
HandParams parse_hand(std::string_view query, const DeviceContext& context = {});

/// Part of an address before the colon, "" without one.
/// Thread    [offline].
std::string device_scheme(std::string_view address);

/// One parameter of an address, for `thigma devices`.
struct DeviceParameter {
  std::string name, unit, default_value, meaning;
};

/// One kind of address.
struct DeviceScheme {
  std::string scheme;  // with the colon
  std::string meaning;
  std::vector<DeviceParameter> parameters;
  std::string if_killed{};  // what of a force is left when this program is killed; "": no force
};

/// Every scheme known.
/// Thread    [offline].
std::vector<DeviceScheme> device_schemes();

/// Addresses of what is plugged in, of a scheme with the colon; none where its library or service
/// is missing or nobody can tell.
///
/// why       null, or receives what is missing and what mends it, one line
/// Thread    [offline]; may open a device and close it again.
std::vector<std::string> plugged_devices(const std::string& scheme, std::string* why = nullptr);

/// What a person is told and says while a device is calibrated.
struct CalibrationTalk {
  std::function<void(const std::string&)> say;
  std::function<bool(const std::string&)> confirm;  // a question; true: yes
  std::function<bool()> is_stopped{};  // asked while something moves; true: off at once
  bool is_answered = true;  // by a person; false: what only a person can tell is left out
};

/// The vendor's own procedure, then what only a person can confirm. What was confirmed is kept in
/// the user's configuration folder. Where it is stopped forces go off, and nothing is kept.
///
/// errors   DeviceAddressError, DeviceUnavailable: also where nothing is to be calibrated; IoError
/// Thread   [offline]; takes as long as the person, and the device may move by itself.
void calibrate_device(const std::string& address, const CalibrationTalk& talk);

}  // namespace thigma
