#include "fuzz/fuzz_target.h"

#include "thigma/device/open_device.h"

namespace thigma::fuzz {
namespace {

/// A device that opened is read and written a few times, at times of a session and at wild ones.
void use(HapticDevice& device) {
  for (const double now : {0.0, 0.001, 0.002, 0.5, 0.5, 1e9}) {
    const DeviceState state = device.read(now);
    require(state.motion.pose.position.allFinite(), "handle positions are finite");
    device.write({Vec3(0.1, -0.2, 0.3), Vec3(1e-3, 0.0, 0.0)});
  }
}

}  // namespace

void fuzz_uri(Bytes bytes) {
  const std::string address(text_of(bytes));
  const std::string scheme = device_scheme(address);
  if (scheme != "hand" && scheme != "null" && address.find(':') != std::string::npos)
    return;  // those open files and libraries of this machine
  for (const char* second : {"rotation=", "camera="})  // as may a second device
    if (address.find(second) != std::string::npos) return;
  try {
    const auto device = open_device(address);
    if (is_one_of(16, bytes)) use(*device);  // a path to 1e9 s takes longer than its address
  } catch (const DeviceAddressError& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos,
            "a refusal is one line");
  } catch (const DeviceUnavailable& error) {
    require(std::string_view(error.what()).find('\n') == std::string_view::npos,
            "a refusal is one line");
  } catch (const InputError&) {
  }
}

}  // namespace thigma::fuzz
