#pragma once
// A client's half of the WebSocket protocol, as far as drivers need it: text both ways, no
// extension. Source: RFC 6455; sections in the code.

#include <cstdint>
#include <string>
#include <string_view>

namespace thigma::detail {

/// Value of a line of an HTTP head, "" where there is none.
/// name     in any case
/// Thread   [offline].
std::string_view http_header(std::string_view head, std::string_view name);

/// The request that opens a connection (4.1).
/// key      base64 of 16 bytes, another one each time
/// Thread   [offline].
std::string websocket_request(const std::string& host, const std::string& key);

/// What is wrong with the head of the server's answer, up to its empty line; "" where nothing is.
/// Thread   [offline].
std::string fault_of_websocket_answer(std::string_view head, const std::string& key);

/// What the server has to answer to a key: base64 of SHA-1 of the key and a fixed text (4.2.2).
/// Thread   [offline].
std::string websocket_accept(const std::string& key);

/// Opcodes (5.2).
enum class WebSocketOp : std::uint8_t {
  more = 0,
  text = 1,
  binary = 2,
  close = 8,
  ping = 9,
  pong = 10
};

/// Appends a whole message in one frame, masked as a client's has to be (5.3).
/// Thread   [offline].
void append_websocket_frame(WebSocketOp op, std::string_view payload, std::uint32_t mask,
                            std::string& out);

enum class WebSocketEvent : std::uint8_t {
  none,    // more bytes are needed
  text,    // or binary: a whole message
  ping,    // to be answered with its payload
  close,   // the server ends in order
  broken,  // no WebSocket frame, or one that a server may not send; nothing is read from here on
};

/// Makes messages of what a server sends. Invariant: holds 1 MiB and one frame at most.
/// Thread: one.
class WebSocketReader {
 public:
  void add(std::string_view bytes) { in_.append(bytes); }
  /// The next event; its payload until the next call.
  WebSocketEvent next(std::string& payload);
  /// Why it is broken, "" where it is not.
  const char* fault() const { return fault_; }

 private:
  WebSocketEvent fail(const char* why) {
    fault_ = why;
    return WebSocketEvent::broken;
  }
  std::string in_, message_;
  bool is_in_message_ = false;
  const char* fault_ = "";
};

}  // namespace thigma::detail
