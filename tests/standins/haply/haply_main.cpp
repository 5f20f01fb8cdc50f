// standin_haply BOARD: Haply's Inverse Service, pretended. README.md says what comes from which
// line of the vendor's documents.
#include <map>

#include "../common/board.h"
#include "../common/device.h"
#include "../net/service.h"
#include "../net/socket.h"
#include "messages.h"
#include "websocket.h"

namespace {

using namespace standin;

constexpr int kSimulation = 0;  // kinds of listeners
constexpr int kEvents = 1;

struct Session {
  bool is_open = false;  // the handshake is done
  std::string text;      // of a message in several frames
};

std::map<int, Session>& sessions() {
  static auto* const map = new std::map<int, Session>;
  return *map;
}

void own_values() {
  for (int unit = 0; unit < kUnits; ++unit) {
    put(unit, k_serial, unit == 0 ? 0x049D : 0x04C3);
    put(unit, k_sdk_major, 3);
    put(unit, k_sdk_minor, 5);
    put(unit, k_sdk_release, 0);
    put(unit, k_type, 0);  // 1: left hand
    put(unit, k_target_y, -0.12);
    put(unit, k_target_z, 0.15);
    put(unit, k_max_force, 10);
    put(unit, k_watchdog, 0);
    put(unit, k_velocity_threshold, 0);
    put(unit, k_comm_timeout_ms, 100);
  }
}

void say(Peer& peer, const std::string& text) {
  const double kind = get(0, k_garbage);
  const std::string wrong =
      kind == 1.0 ? write_frame(kText, "{\"inverse3\":[{\"device_id\":") : "\xff\xfe garbage \x01";
  send_faulty(peer, write_frame(kText, text), wrong);
  record_raw(peer.number, "out", text, true);
}

void say_inventory(Peer& peer) {
  std::string text;
  {
    const Locked lock;
    text = inventory(peer.number);
  }
  say(peer, text);
}

void answer(Peer& peer, const std::string& message) {
  record_raw(peer.number, "in", message, true);
  if (peer.kind == kEvents) {
    return;  // read only
  }
  const bool is_full = obey(message, peer.number);
  delay_answer();
  if (is_full) {
    say_inventory(peer);
    return;
  }
  std::string text;
  {
    const Locked lock;
    text = state_update();
  }
  say(peer, text);
}

void shake_hands(Peer& peer, Session& session) {
  const auto request = read_request(peer.in);
  if (!request) {
    return;
  }
  record_raw(peer.number, "in", request->method + " " + request->target, true);
  peer.in.erase(0, request->size);
  if (!request->is_upgrade) {
    const bool knows = request->target == "/version" && !is_on(0, k_no_version);
    const std::string body = knows ? version_answer() : "{\"error\":\"not found\"}";
    send_faulty(peer, http_answer(knows ? 200 : 404, body), "\xff\xfe garbage \x01");
    peer.gone = peer.gone || !is_on(0, k_silent);
    return;
  }
  if (is_on(0, k_silent)) {
    return;
  }
  session.is_open = send_all(peer.fd, upgrade_answer(request->key));
  if (session.is_open && peer.kind == kSimulation) {
    say_inventory(peer);
  }
}

void take_frame(Peer& peer, Session& session, const WebSocketFrame& frame) {
  if (!frame.is_masked) {  // RFC 6455, section 5.1
    send_all(peer.fd, write_frame(kClose, "\x03\xea"));
    peer.gone = true;
  } else if (frame.opcode == kClose) {
    send_all(peer.fd, write_frame(kClose, frame.payload));
    peer.gone = true;
  } else if (frame.opcode == kPing) {
    send_all(peer.fd, write_frame(kPong, frame.payload));
  } else if (frame.opcode != kPong) {
    session.text += frame.payload;
    if (frame.is_last) {
      const std::string message = std::move(session.text);
      session.text.clear();
      answer(peer, message);
    }
  }
}

void has_read(Peer& peer) {
  Session& session = sessions()[peer.number];
  if (!session.is_open) {
    shake_hands(peer, session);
  }
  while (session.is_open && !peer.gone) {
    const auto frame = read_frame(peer.in);
    if (!frame) {
      return;
    }
    peer.in.erase(0, frame->size);
    take_frame(peer, session, *frame);
  }
}

void left(Peer& peer) {
  sessions().erase(peer.number);
  end_session(peer.number);
}

// Events go to all who listen: plugged in or pulled out, the emergency brake.
void tell_events() {
  static bool was_plugged[kUnits] = {true, true};
  static bool was_braked[kUnits] = {};
  for (int unit = 0; unit < kUnits && unit < get(0, k_count); ++unit) {
    const bool is_plugged = !is_on(unit, k_unplug);
    const bool is_braked = is_on(unit, k_cut);
    std::string event;
    if (is_plugged && !was_plugged[unit]) {
      const Locked lock;
      open_unit(unit);
    }
    if (is_plugged != was_plugged[unit]) {
      event = is_plugged
                  ? device_event("device-connected", "info", unit, "device connected")
                  : device_event("device-disconnected", "warning", unit, "device disconnected");
    } else if (is_braked != was_braked[unit]) {
      event = device_event("device-safety-triggered", is_braked ? "error" : "notice", unit,
                           is_braked ? "ebrake_triggered" : "ebrake_released");
    }
    was_plugged[unit] = is_plugged;
    was_braked[unit] = is_braked;
    for (Peer& peer : peers()) {
      if (!event.empty() && peer.kind == kEvents && sessions()[peer.number].is_open) {
        say(peer, event);
      }
    }
  }
}

}  // namespace

int main(int count, char** words) {
  Arguments a = begin(count, words, "HAPLY", &own_values);
  std::vector<int> listeners = {listen_tcp(&a.port)};
  if (a.events_port >= 0) {
    listeners.push_back(listen_tcp(&a.events_port));
  }
  for (const int fd : listeners) {
    if (fd < 0) {
      std::fprintf(stderr, "%s: port %d is taken\n", words[0], a.port);
      return 1;
    }
  }
  {
    const Locked lock;
    for (int unit = 0; unit < kUnits; ++unit) {
      open_unit(unit);
    }
  }
  tell("ws://127.0.0.1:" + std::to_string(a.port), a.port, a.events_port);
  serve({[](Peer&) {}, &has_read, &left, &tell_events, [] { return 0.005; }, [](int) {}, {}},
        listeners);
}
