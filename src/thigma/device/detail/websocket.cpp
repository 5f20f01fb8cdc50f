#include "thigma/device/detail/websocket.h"

#include <array>
#include <bit>
#include <cstddef>

namespace thigma::detail {
namespace {

constexpr std::size_t kMostMessage = std::size_t{1} << 20;
constexpr std::string_view kGuid = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";  // 1.3

using Sha1 = std::array<std::uint32_t, 5>;

/// One block of 64 bytes (FIPS 180-4, 6.1.2).
void add_block(const unsigned char* block, Sha1& h) {
  std::uint32_t w[80];
  for (int i = 0; i < 16; ++i)
    w[i] = std::uint32_t{block[4 * i]} << 24 | std::uint32_t{block[4 * i + 1]} << 16 |
           std::uint32_t{block[4 * i + 2]} << 8 | block[4 * i + 3];
  for (int i = 16; i < 80; ++i) w[i] = std::rotl(w[i - 3] ^ w[i - 8] ^ w[i - 14] ^ w[i - 16], 1);
  auto [a, b, c, d, e] = h;
  for (int i = 0; i < 80; ++i) {
    std::uint32_t f = b ^ c ^ d, k = 0xCA62C1D6;
    if (i < 20) {
      f = (b & c) | (~b & d);
      k = 0x5A827999;
    } else if (i < 40) {
      k = 0x6ED9EBA1;
    } else if (i < 60) {
      f = (b & c) | (b & d) | (c & d);
      k = 0x8F1BBCDC;
    }
    const std::uint32_t t = std::rotl(a, 5) + f + e + k + w[i];
    e = d, d = c, c = std::rotl(b, 30), b = a, a = t;
  }
  h = {h[0] + a, h[1] + b, h[2] + c, h[3] + d, h[4] + e};
}

std::string sha1(std::string text) {
  Sha1 h = {0x67452301, 0xEFCDAB89, 0x98BADCFE, 0x10325476, 0xC3D2E1F0};
  const std::uint64_t bits = 8 * text.size();
  text += '\x80';
  while (text.size() % 64 != 56) text += '\0';
  for (int i = 7; i >= 0; --i) text += static_cast<char>(bits >> (8 * i));
  for (std::size_t i = 0; i < text.size(); i += 64)
    add_block(reinterpret_cast<const unsigned char*>(text.data()) + i, h);
  std::string digest;
  for (const std::uint32_t word : h) {
    for (int i = 3; i >= 0; --i) digest += static_cast<char>(word >> (8 * i));
  }
  return digest;
}

std::string base64(std::string_view bytes) {
  constexpr char kLetters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kLetters[(three >> (18 - 6 * k)) & 63];
  }
  return text;
}

bool is_same_word(std::string_view a, std::string_view b) {
  const auto low = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (low(a[i]) != low(b[i])) return false;
  }
  return true;
}

/// The head of a frame (5.2).
struct FrameHead {
  std::size_t size = 0;  // bytes of the head; 0: it is not whole yet
  std::uint64_t length = 0;
  std::uint8_t op = 0;
  bool is_final = false, is_masked = false, has_extension = false;
};

FrameHead frame_head(std::string_view in) {
  FrameHead head;
  if (in.size() < 2) return head;
  const auto byte = [in](std::size_t i) { return static_cast<unsigned char>(in[i]); };
  head.is_final = (byte(0) & 0x80) != 0;
  head.has_extension = (byte(0) & 0x70) != 0;
  head.op = byte(0) & 0x0F;
  head.is_masked = (byte(1) & 0x80) != 0;
  const int seven = byte(1) & 0x7F;
  const std::size_t more = seven == 126 ? 2 : seven == 127 ? 8 : 0;
  if (in.size() < 2 + more) return head;
  head.length = more == 0 ? static_cast<std::uint64_t>(seven) : 0;
  for (std::size_t i = 0; i < more; ++i) head.length = head.length << 8 | byte(2 + i);
  head.size = 2 + more;
  return head;
}

}  // namespace

std::string_view http_header(std::string_view head, std::string_view name) {
  for (std::size_t at = 0; (at = head.find("\r\n", at)) != std::string_view::npos;) {
    at += 2;
    const std::string_view line = head.substr(at, head.find("\r\n", at) - at);
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos || !is_same_word(line.substr(0, colon), name)) continue;
    std::string_view value = line.substr(colon + 1);
    while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
    while (!value.empty() && value.back() == ' ') value.remove_suffix(1);
    return value;
  }
  return {};
}

std::string websocket_accept(const std::string& key) {
  return base64(sha1(key + std::string(kGuid)));
}

std::string websocket_request(const std::string& host, const std::string& key) {
  return "GET / HTTP/1.1\r\nHost: " + host +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
         "Sec-WebSocket-Key: " +
         key + "\r\n\r\n";
}

std::string fault_of_websocket_answer(std::string_view head, const std::string& key) {
  const std::string_view first = head.substr(0, head.find("\r\n"));
  const bool is_http = first.substr(0, 7) == "HTTP/1." && first.size() >= 12;
  if (!is_http) return "it does not speak HTTP";
  if (first.substr(9, 3) != "101") return "it answers " + std::string(first.substr(9, 60));
  if (!is_same_word(http_header(head, "Upgrade"), "websocket") ||
      http_header(head, "Sec-WebSocket-Accept") != websocket_accept(key))
    return "it does not take the WebSocket handshake";
  return "";
}

void append_websocket_frame(WebSocketOp op, std::string_view payload, std::uint32_t mask,
                            std::string& out) {
  out += static_cast<char>(0x80 | static_cast<int>(op));
  const std::uint64_t n = payload.size();
  const int more = n < 126 ? 0 : n < 65536 ? 2 : 8;
  const int seven = more == 0 ? static_cast<int>(n) : more == 2 ? 126 : 127;
  out += static_cast<char>(0x80 | seven);
  for (int i = more - 1; i >= 0; --i) out += static_cast<char>(n >> (8 * i));
  char key[4];
  for (int i = 0; i < 4; ++i) out += key[i] = static_cast<char>(mask >> (24 - 8 * i));
  for (std::size_t i = 0; i < payload.size(); ++i)
    out += static_cast<char>(payload[i] ^ key[i % 4]);
}

WebSocketEvent WebSocketReader::next(std::string& payload) {
  while (*fault_ == '\0') {
    const FrameHead head = frame_head(in_);
    const bool is_control = (head.op & 8) != 0;
    if (head.has_extension) return fail("a frame uses an extension that nobody agreed on");
    if (head.is_masked) return fail("a frame is masked");
    if (head.op > 10 || (head.op > 2 && !is_control)) return fail("a frame has no known kind");
    if (head.size == 0) return WebSocketEvent::none;
    if (head.length > kMostMessage || message_.size() + head.length > kMostMessage)
      return fail("a message is longer than 1 MiB");
    if (is_control && (!head.is_final || head.length > 125))
      return fail("a control frame is too long or in parts");
    if (in_.size() < head.size + head.length) return WebSocketEvent::none;
    const std::string_view body =
        std::string_view(in_).substr(head.size, static_cast<std::size_t>(head.length));
    const auto op = static_cast<WebSocketOp>(head.op);
    if (is_control) payload = body;
    if (!is_control) {
      if ((op == WebSocketOp::more) != is_in_message_)
        return fail("the parts of a message are out of order");
      message_ += body;
      is_in_message_ = !head.is_final;
    }
    in_.erase(0, head.size + static_cast<std::size_t>(head.length));
    if (op == WebSocketOp::ping) return WebSocketEvent::ping;
    if (op == WebSocketOp::close) return WebSocketEvent::close;
    if (op == WebSocketOp::pong || is_in_message_) continue;
    payload.swap(message_);
    message_.clear();
    return WebSocketEvent::text;
  }
  return WebSocketEvent::broken;
}

}  // namespace thigma::detail
