#pragma once
// A connection with the Inverse Service: one message there, one message back.

#include <cstdint>
#include <string>

#include "thigma/device/detail/haply_message.h"
#include "thigma/device/detail/link_device.h"
#include "thigma/device/detail/websocket.h"
#include "thigma/files/descriptor.h"

namespace thigma::detail {

/// What an address names.
struct HaplyAddress {
  std::string id;    // of the arm; "": the first
  std::string grip;  // "": the first that is there; "none"
  std::string host = "localhost";
  std::uint16_t port = 10001;
  double rate = 2000.0;    // messages a second at most [Hz]
  double max_force = 4.0;  // [N]
  int hold = -1;           // 1: the hand always holds; 0: while a button is pressed; -1: as there
                           // are buttons
};

/// An open connection. Thread: one at a time.
class HaplyLink {
 public:
  /// Connects, asks for the version, reads the first message.
  /// errors  DeviceUnavailable
  explicit HaplyLink(const HaplyAddress& address);

  /// What the service said last.
  const HaplyFrame& frame() const { return frame_; }

  /// Sends a force.
  /// errors  IoError
  void send(const std::string& id, const Vec3& force);
  /// Waits for the answer; false where it does not come in time.
  /// errors  IoError: closed, or nonsense
  bool wait(double seconds);
  /// Ends in order.
  void close() noexcept;

 private:
  void ask_for_version(const HaplyAddress& address);
  void shake_hands(const HaplyAddress& address);
  void send_frame(WebSocketOp op, std::string_view payload);

  Descriptor socket_;
  WebSocketReader reader_;
  HaplyForm form_ = HaplyForm::values;
  HaplyFrame frame_;
  std::string out_, text_;
  std::uint32_t mask_ = 0;
  bool is_first_ = true;
};

/// Speaks with the service until ends.is_over. Publishes a sample for every answer; a service that
/// is silent, closes or says nonsense is a loss with a reason.
/// Thread   the link's own.
void speak_with_haply(HaplyLink& link, const HaplyAddress& address, LinkEnds& ends);

/// The arm and the grip of an address in a message; null where they are not there.
const HaplyArm* find_arm(const HaplyFrame& frame, const std::string& id);
const HaplyGrip* find_grip(const HaplyFrame& frame, const std::string& id);

}  // namespace thigma::detail
