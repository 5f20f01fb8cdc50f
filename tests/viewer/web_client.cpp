#include "web_client.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "thigma/session/rt_thread.h"

namespace thigma::test {
namespace {

double now() { return 1e-9 * static_cast<double>(monotonic_ns()); }

int connect_to(std::uint16_t port, int receive_buffer = 0) {
  const int s = ::socket(AF_INET, SOCK_STREAM, 0);
  if (receive_buffer > 0)
    ::setsockopt(s, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(s, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return s;
  ::close(s);
  return -1;
}

void send_all(int s, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(s, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

/// Appends what is there within `patience`; false at the end or when nothing came.
bool receive(int s, double patience, std::string& into) {
  pollfd waiting{s, POLLIN, 0};
  if (::poll(&waiting, 1, static_cast<int>(1e3 * std::max(0.0, patience))) <= 0) return false;
  char bytes[65536];
  const ssize_t n = ::recv(s, bytes, sizeof bytes, 0);
  if (n <= 0) return false;
  into.append(bytes, static_cast<std::size_t>(n));
  return true;
}

}  // namespace

std::string http_exchange(std::uint16_t port, const std::string& request, double patience) {
  const int s = connect_to(port);
  send_all(s, request);
  std::string answer;
  while (receive(s, patience, answer)) {
  }
  ::close(s);
  return answer;
}

WebClient::WebClient(std::uint16_t port, const WebGreeting& greeting)
    : socket_(connect_to(port, greeting.receive_buffer)) {
  const std::string own = "127.0.0.1:" + std::to_string(port);
  const std::string host = greeting.host == "own" ? own : greeting.host;
  const std::string origin = greeting.origin == "own" ? "http://" + own : greeting.origin;
  std::string request =
      "GET /live" + (greeting.token.empty() ? "" : "?token=" + greeting.token) +
      " HTTP/1.1\r\nHost: " + host +
      "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  if (!origin.empty()) request += "Origin: " + origin + "\r\n";
  if (!greeting.subprotocol.empty())
    request += "Sec-WebSocket-Protocol: " + greeting.subprotocol + "\r\n";
  send_all(socket_, request + "\r\n");
  const double deadline = now() + 5.0;
  std::size_t end;
  while ((end = buffer_.find("\r\n\r\n")) == std::string::npos) {
    if (!receive(socket_, deadline - now(), buffer_)) break;
  }
  if (end == std::string::npos) return;
  response_ = buffer_.substr(0, end + 4);
  buffer_.erase(0, end + 4);
  if (response_.size() > 12) status_ = std::atoi(response_.c_str() + 9);
}

WebClient::~WebClient() {
  if (socket_ >= 0) ::close(socket_);
}

void WebClient::send_raw(std::string_view bytes) { send_all(socket_, bytes); }

void WebClient::send_frame(int opcode, std::string_view payload, bool is_final) {
  std::string frame(1, static_cast<char>(opcode | (is_final ? 0x80 : 0)));
  const std::size_t n = payload.size();
  if (n < 126) {
    frame += static_cast<char>(0x80 | n);
  } else if (n < 65536) {
    frame += static_cast<char>(0x80 | 126);
    frame += static_cast<char>(n >> 8);
    frame += static_cast<char>(n & 0xff);
  } else {
    frame += static_cast<char>(0x80 | 127);
    for (int shift = 56; shift >= 0; shift -= 8) frame += static_cast<char>((n >> shift) & 0xff);
  }
  const char mask[4] = {0x12, 0x34, 0x56, 0x78};
  frame.append(mask, 4);
  for (std::size_t i = 0; i < n; ++i) frame += static_cast<char>(payload[i] ^ mask[i % 4]);
  send_raw(frame);
}

bool WebClient::fill(std::size_t bytes, double deadline) {
  while (buffer_.size() < bytes) {
    if (!receive(socket_, deadline - now(), buffer_)) return false;
  }
  return true;
}

std::optional<WebMessage> WebClient::read(double patience) {
  const double deadline = now() + patience;
  WebMessage message;
  while (fill(2, deadline)) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(buffer_[i]); };
    const int opcode = byte(0) & 0x0f;
    const bool is_final = (byte(0) & 0x80) != 0;
    std::size_t length = byte(1) & 0x7f, header = 2;
    const std::size_t extra = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (!fill(header + extra, deadline)) return std::nullopt;
    if (extra > 0) {
      length = 0;
      for (std::size_t i = 0; i < extra; ++i) length = length << 8 | byte(2 + i);
      header += extra;
    }
    if (!fill(header + length, deadline)) return std::nullopt;
    const std::string payload = buffer_.substr(header, length);
    buffer_.erase(0, header + length);
    if (opcode == 8) {
      close_code_ = payload.size() >= 2 ? static_cast<unsigned char>(payload[0]) << 8 |
                                              static_cast<unsigned char>(payload[1])
                                        : 0;
      close_reason_ = payload.size() > 2 ? payload.substr(2) : "";
      send_frame(8, payload.substr(0, 2));
      return std::nullopt;
    }
    if (opcode == 9) send_frame(10, payload);
    if (opcode > 2) continue;
    if (opcode != 0) message.is_binary = opcode == 2;
    message.data += payload;
    if (is_final) return message;
  }
  return std::nullopt;
}

std::string WebClient::read_type(const std::string& type, double patience) {
  const double deadline = now() + patience;
  while (std::optional<WebMessage> message = read(deadline - now())) {
    if (!message->is_binary && message->data.find("\"type\":\"" + type + "\"") != std::string::npos)
      return message->data;
  }
  return {};
}

int WebClient::close_code(double patience) {
  const double deadline = now() + patience;
  while (close_code_ < 0) {
    if (read(deadline - now())) continue;
    if (close_code_ >= 0) break;
    char byte;
    // Hung up, or still silent?
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, 0) > 0 && ::recv(socket_, &byte, 1, MSG_PEEK) <= 0) return 0;
    return -1;
  }
  return close_code_;
}

}  // namespace thigma::test
