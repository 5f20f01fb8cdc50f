#include "thigma/device/detail/dhd_open.h"

#include <charconv>
#include <chrono>
#include <future>

#include "thigma/device/detail/address.h"
#include "thigma/device/detail/dhd_device.h"
#include "thigma/device/open_device.h"

namespace thigma::detail {
namespace {

constexpr const char* kPlug =
    "Plug it in and switch it on; if it is, let your user open it (docs/devices.md, udev rule).";

[[noreturn]] void refuse(const DhdLibrary& dhd, const std::string& what) {
  const std::string why = last_dhd_error(dhd);
  throw DeviceUnavailable("dhd: " + what + (why.empty() ? "" : " (" + why + ")") + ". " + kPlug);
}

struct InitResult {
  int result = 0;
  std::string why;  // the vendor's word of an error
};

bool is_stopped(const CalibrationTalk& talk) { return talk.is_stopped && talk.is_stopped(); }

/// The device moves by itself, in a thread of its own: who is in its way can stop it.
InitResult init_until_stopped(const DhdLibrary& dhd, char id, const CalibrationTalk& talk) {
  auto init = std::async(std::launch::async, [&] {
    const int result = dhd.auto_init(id);
    return InitResult{result, is_dhd_error(result) ? last_dhd_error(dhd) : ""};  // of this thread
  });
  constexpr auto kLook = std::chrono::milliseconds(10);
  while (init.wait_for(kLook) != std::future_status::ready) {
    if (!is_stopped(talk)) continue;
    if (dhd.stop_regulation != nullptr) dhd.stop_regulation(false, id);
    dhd.stop(id);
  }
  return init.get();
}

}  // namespace

long parse_dhd_number(const std::string& rest) {
  if (rest.empty()) return 0;
  long number = -1;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (error != std::errc{} || end != rest.data() + rest.size() || number < 0 || number > 1'000'000)
    throw DeviceAddressError("dhd: " + quoted(rest) + ", expected dhd:, dhd:NUMBER or dhd:SERIAL");
  return number;
}

long dhd_serial(const DhdLibrary& dhd, char id) {
  std::uint16_t serial[4] = {};  // room for versions that write more
  if (dhd.get_serial == nullptr || is_dhd_error(dhd.get_serial(serial, id))) return -1;
  return serial[0];
}

char open_dhd_number(const DhdLibrary& dhd, long number) {
  const int count = dhd.count();
  if (count < 0) refuse(dhd, "the devices cannot be counted");
  if (count == 0) throw DeviceUnavailable(std::string("dhd: no device is plugged in. ") + kPlug);
  if (number < count) {
    const int id = dhd.open(static_cast<char>(number));
    if (id < 0) refuse(dhd, "device " + std::to_string(number) + " does not open");
    return static_cast<char>(id);
  }
  for (int i = 0; i < count; ++i) {
    const int id = dhd.open(static_cast<char>(i));
    if (id < 0) continue;  // another's
    if (dhd_serial(dhd, static_cast<char>(id)) == number) return static_cast<char>(id);
    dhd.close(static_cast<char>(id));
  }
  throw DeviceUnavailable("dhd: no device has the number or serial number " +
                          std::to_string(number) + ", and " + std::to_string(count) +
                          (count == 1 ? " is" : " are") +
                          " plugged in. `thigma devices` lists them.");
}

void calibrate_dhd(const std::string& rest, const CalibrationTalk& talk) {
  const long number = parse_dhd_number(rest);
  const DhdLibrary dhd = open_dhd_library();
  const char id = open_dhd_number(dhd, number);
  const bool is_done = dhd.is_initialized != nullptr && dhd.is_initialized(id);
  const bool can = dhd.auto_init != nullptr;
  const bool may = !is_done && can &&
                   talk.confirm(
                       "The device will move by itself to its reference. Nobody holds it, "
                       "nothing is in its way?");
  const auto [result, why] = may ? init_until_stopped(dhd, id, talk) : InitResult{};
  if (dhd.stop_regulation != nullptr) dhd.stop_regulation(false, id);
  dhd.stop(id);
  dhd.close(id);
  if (!is_done && !can)
    throw DeviceUnavailable("dhd: " + dhd.library.name() +
                            " cannot initialise. Use the vendor's own program, or libdrd.");
  if (may && is_stopped(talk)) return talk.say("It was stopped: its forces are off.");
  if (is_dhd_error(result))
    throw DeviceUnavailable("dhd: the device did not find its reference (" + why +
                            "). Let it move freely and try again.");
  talk.say(is_done || may ? "The device knows its reference." : "Nothing was done.");
}

std::vector<std::string> plugged_dhd() {
  const DhdLibrary dhd = open_dhd_library();
  std::vector<std::string> addresses;
  for (int i = 0, count = dhd.count(); i < count; ++i)
    addresses.push_back("dhd:" + std::to_string(i));
  return addresses;
}

}  // namespace thigma::detail
