// A client of the Inverse Service: a WebSocket and JSON, for tests.
#pragma once

#include <cstdint>
#include <string>

#include "haply/websocket.h"
#include "services.h"
#include <nlohmann/json.hpp>

namespace standin_test {

using Json = nlohmann::json;

// A client's frame: masked.
inline std::string masked(int opcode, const std::string& payload, bool is_last = true) {
  std::string frame(1, static_cast<char>((is_last ? 0x80 : 0) | opcode));
  if (payload.size() < 126) {
    frame += static_cast<char>(0x80 | payload.size());
  } else {
    frame += static_cast<char>(0xFE);
    frame += static_cast<char>(payload.size() >> 8);
    frame += static_cast<char>(payload.size() & 255U);
  }
  const std::string mask = "\x11\x22\x33\x44";
  frame += mask;
  for (std::size_t i = 0; i < payload.size(); ++i) {
    frame += static_cast<char>(payload[i] ^ mask[i % 4]);
  }
  return frame;
}

class HaplyClient {
 public:
  explicit HaplyClient(int port, bool shakes_hands = true) : wire_(si::connect_tcp(port)) {
    if (!shakes_hands) {
      return;
    }
    wire_.send(
        "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n");
    wire_.read(129);
    head = wire_.in().substr(0, wire_.in().find("\r\n\r\n") + 4);
    wire_.drop(head.size());
  }

  // The next message; empty where none comes in time.
  std::string next(double seconds = 10.0) {
    for (double waited = 0.0; waited < seconds; waited += 0.01) {
      if (const auto frame = si::read_frame(wire_.in())) {
        wire_.drop(frame->size);
        return frame->payload;
      }
      if (wire_.is_closed(0.0)) {
        return {};
      }
      wire_.read(wire_.in().size() + 1, 0.01);
    }
    return {};
  }
  Json json() { return Json::parse(next(), nullptr, false); }
  void say(const Json& message) { wire_.send(masked(si::kText, message.dump())); }
  Json ask(const Json& message) {
    say(message);
    return json();
  }
  Json force(double x, double y, double z, const char* field = "vector", const char* id = "049D") {
    return ask(force_message(x, y, z, field, id));
  }
  static Json force_message(double x, double y, double z, const char* field, const char* id) {
    const Json vector = {{"x", x}, {"y", y}, {"z", z}};
    const Json command = {{"set_cursor_force", {{field, vector}}}};
    return {{"inverse3", Json::array({{{"device_id", id}, {"commands", command}}})}};
  }
  Wire& wire() { return wire_; }

  std::string head;  // of the answer to the handshake

 private:
  Wire wire_;
};

}  // namespace standin_test
