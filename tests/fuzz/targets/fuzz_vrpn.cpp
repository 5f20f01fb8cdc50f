#include "fuzz/fuzz_target.h"

#include "thigma/device/detail/spacenav_device.h"
#include "thigma/device/detail/vrpn_message.h"

namespace thigma::fuzz {

using namespace detail;

/// What a VRPN server may send behind its cookie; and every payload as each kind of report. Behind
/// an 's': events of spacenavd.
void fuzz_vrpn(Bytes bytes) {
  std::string_view text = text_of(bytes);
  if (!text.empty() && text[0] == 's') {
    SpacenavState state;
    for (text.remove_prefix(1); !text.empty();) {
      const std::size_t n = std::min(text.size(), kSpacenavEvent);
      if (!take_spacenav_event(text.substr(0, n), state).empty()) return;
      const Twist d = spacenav_deflection(state);
      require(d.linear.cwiseAbs().maxCoeff() <= 1.0, "deflections are at most full");
      text.remove_prefix(n);
    }
    return;
  }
  fault_of_vrpn_cookie(text.substr(0, kVrpnCookie));
  VrpnReader reader;
  VrpnMessage message;
  for (std::size_t at = 0; at < text.size(); at += 7) {
    reader.add(text.substr(at, 7));
    while (reader.next(message)) {
      std::string name;
      VrpnReport report;
      std::uint32_t buttons = 0;
      std::int32_t number = 0;
      const std::string_view payload = message.payload;
      if (read_vrpn_name(payload, name)) require(name.size() < payload.size(), "names are within");
      read_vrpn_pose(payload, report);
      read_vrpn_velocity(payload, report);
      read_vrpn_button(payload, buttons);
      read_vrpn_buttons(payload, buttons);
      read_vrpn_number(payload, number);
    }
    if (reader.is_broken()) return;
  }
}

}  // namespace thigma::fuzz
