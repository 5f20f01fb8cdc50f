#include "fuzz/fuzz_target.h"

#include "thigma/device/detail/haply_message.h"
#include "thigma/device/detail/websocket.h"

namespace thigma::fuzz {

using namespace detail;

/// What an Inverse Service may send: frames, and JSON within them; or JSON alone, behind a 'j'.
void fuzz_haply(Bytes bytes) {
  std::string_view text = text_of(bytes);
  const auto read = [](std::string_view message) {
    HaplyFrame frame;
    const std::string fault = read_haply_frame(message, frame);
    require(fault.find('\n') == std::string::npos, "a refusal is one line");
    if (!fault.empty()) return;
    for (const HaplyArm& arm : frame.arms)
      require(arm.position.allFinite() && arm.velocity.allFinite(), "numbers are finite");
    for (const HaplyGrip& grip : frame.grips)
      require(std::abs(grip.orientation.norm() - 1.0) < 1e-9, "orientations are rotations");
  };
  if (!text.empty() && text[0] == 'j') return read(text.substr(1));
  if (!text.empty() && text[0] == 'v') {
    HaplyForm form = HaplyForm::values;
    haply_form_of(text.substr(1), form);
    fault_of_websocket_answer(text.substr(1), "dGhlIHNhbXBsZSBub25jZQ==");
    return;
  }
  WebSocketReader reader;
  std::string payload;
  for (std::size_t at = 0; at < text.size(); at += 7) {  // in pieces, as a network brings them
    reader.add(text.substr(at, 7));
    for (;;) {
      const WebSocketEvent event = reader.next(payload);
      if (event == WebSocketEvent::broken) return;
      if (event == WebSocketEvent::none) break;
      if (event == WebSocketEvent::text) read(payload);
    }
  }
}

}  // namespace thigma::fuzz
