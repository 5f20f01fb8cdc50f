// RFC 6455, the server's side, and the little of HTTP that comes before it. Written anew rather
// than with a library: a stand-in must be able to send half a frame and what is no frame.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace standin {

// A request's head, and what of it matters here.
struct HttpRequest {
  std::string method;
  std::string target;
  bool is_upgrade = false;
  std::string key;       // Sec-WebSocket-Key
  std::size_t size = 0;  // bytes of the head
};

// Nothing while the head is not complete.
std::optional<HttpRequest> read_request(std::string_view bytes);

std::string http_answer(int status, std::string_view body);
// Section 4.2.2: the answer that makes a WebSocket.
std::string upgrade_answer(const std::string& key);

enum Opcode { kContinued = 0, kText = 1, kBinary = 2, kClose = 8, kPing = 9, kPong = 10 };

struct WebSocketFrame {
  int opcode = 0;
  bool is_last = false;
  bool is_masked = false;
  std::string payload;
  std::size_t size = 0;  // bytes of the frame
};

// Section 5.2. Nothing while the frame is not complete.
std::optional<WebSocketFrame> read_frame(std::string_view bytes);

// From a server: not masked.
std::string write_frame(int opcode, std::string_view payload);

}  // namespace standin
