#pragma once
// A client that speaks HTTP and WebSocket by hand, so that it can also speak them wrongly.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thigma::test {

/// Sends `request` as it stands to 127.0.0.1:port and returns all that comes back until the server
/// closes or says nothing for `patience` [s].
std::string http_exchange(std::uint16_t port, const std::string& request, double patience = 2.0);

/// What a client says of itself.
struct WebGreeting {
  std::string origin = "own";  // "own": that of the server; "": none
  std::string host = "own";
  std::string subprotocol = "thigma.live.1";
  std::string token{};     // shown where it is not empty
  int receive_buffer = 0;  // of the system; small: what is not read waits at the server [bytes]
};

struct WebMessage {
  bool is_binary = false;
  std::string data;
};

/// A WebSocket. Reading waits for at most `patience` seconds, so that a test fails rather than
/// hangs.
class WebClient {
 public:
  explicit WebClient(std::uint16_t port, const WebGreeting& greeting = {});
  ~WebClient();  // hangs up without a word
  WebClient(const WebClient&) = delete;
  WebClient& operator=(const WebClient&) = delete;

  /// Of the handshake: 101, or what it was refused with.
  int status() const { return status_; }
  const std::string& response() const { return response_; }

  void send_text(std::string_view text) { send_frame(1, text); }
  void send_binary(std::string_view data) { send_frame(2, data); }
  /// A frame with any first byte, masked.
  void send_frame(int opcode, std::string_view payload, bool is_final = true);
  void send_raw(std::string_view bytes);

  /// The next message; nothing when none comes in time or the connection has ended. Answers pings.
  std::optional<WebMessage> read(double patience = 5.0);
  /// The next text message whose `type` is this.
  std::string read_type(const std::string& type, double patience = 5.0);
  /// Reads on until the server closes; its code, 0 without one (hung up), -1 when it does not
  /// close.
  int close_code(double patience = 5.0);
  const std::string& close_reason() const { return close_reason_; }

 private:
  bool fill(std::size_t bytes, double deadline);
  int socket_ = -1;
  int status_ = 0;
  int close_code_ = -1;
  std::string response_, buffer_, close_reason_;
};

}  // namespace thigma::test
