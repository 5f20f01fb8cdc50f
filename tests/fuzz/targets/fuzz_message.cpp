#include <cmath>

#include "fuzz/fuzz_target.h"
#include "viewer/server/messages.h"
#include "viewer/server/protocol.h"

namespace thigma::fuzz {

/// The first byte says whether a page sent text or bytes.
void fuzz_message(Bytes bytes) {
  if (bytes.empty()) return;
  const std::string_view message = text_of(bytes.subspan(1));
  if (bytes[0] == std::byte{'t'}) {
    const live::ParsedCommand parsed = live::parse_command(message);
    require(parsed.refusal.code == 0 || !parsed.refusal.why.empty(), "a refusal has a reason");
    require(parsed.refusal.code != 0 || std::isfinite(parsed.command.number), "numbers are finite");
    require(!parsed.command.point || parsed.command.point->allFinite(), "and points");
    return;
  }
  const live::DeviceMessage device = live::decode_device(message);
  if (device.problem.empty()) {
    WebMotion motion;
    motion.begin();
    double now = 1.0;
    for (const WebSample& sample : device.samples) {
      motion.add(sample, now);
      const DeviceState state = motion.read(now += 1e-3);
      require(state.motion.pose.position.allFinite(), "handle positions are finite");
      require(state.motion.pose.orientation.coeffs().allFinite(), "and orientations");
      require(state.motion.twist.linear.norm() <= 1.2 * (1.0 + 1e-9),
              "the mouse is never too fast");
    }
  }
  if (const auto upload = live::decode_upload(message))
    require(upload->data() >= message.data() && upload->size() <= message.size(),
            "an upload lies in its message");
}

}  // namespace thigma::fuzz
