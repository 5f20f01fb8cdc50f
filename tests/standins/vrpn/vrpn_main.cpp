// standin_vrpn BOARD: a VRPN server with a tracker, buttons and a force device of one name,
// "Haptic0". README.md says what comes from where.
#include <cstdlib>
#include <cstring>

#include "../common/board.h"
#include "../common/device.h"
#include "../net/service.h"
#include "../net/socket.h"
#include "field.h"
#include "reports.h"
#include "wire.h"
#include <sys/socket.h>

namespace {

using namespace standin;

void own_values() {
  for (int unit = 0; unit < kUnits; ++unit) {
    put(unit, k_sdk_major, 7);
    put(unit, k_sdk_minor, 38);
    put(unit, k_watchdog, 0);
    put(unit, k_velocity_threshold, 0);
    put(unit, k_max_force, 0);
  }
}

void came(Peer& peer) {
  const double wrong = get(0, k_wrong_cookie);
  std::string text = cookie(static_cast<int>(get(0, k_sdk_major)) + (wrong == 1.0 ? 1 : 0),
                            static_cast<int>(get(0, k_sdk_minor)));
  if (wrong == 2.0) {
    text.replace(0, 4, "HTTP");
  }
  send_faulty(peer, text, garbage().substr(0, kCookieSize));
}

void obey(Peer& peer, const VrpnMessage& message) {
  Client& client = clients()[peer.number];
  const Locked lock;
  add(0, k_messages);
  if (message.type == kSenderDescription) {
    client.senders[message.sender] = described_name(message.payload);
  } else if (message.type == kTypeDescription) {
    client.types[message.sender] = described_name(message.payload);
  } else if (message.type == kUdpDescription) {
    client.udp_port = message.sender;
    note(0, "UDP description", message.sender);
  } else if (message.type >= 0) {
    const std::string& type = client.types[message.type];
    const std::string& sender = client.senders[message.sender];
    const bool is_mine = sender == kDeviceName;
    if (type == "vrpn_Base ping_message" && is_mine) {
      add(0, k_keepalives);
    } else if (type == "vrpn_ForceDevice Force_Field" && is_mine) {
      take_field(message.payload);
    } else if (type == "vrpn_Tracker set_update_rate" && is_mine) {
      std::size_t at = 0;
      const double rate = take_double(message.payload, &at);
      note(0, "set_update_rate", 0, &rate, 1);
    } else {
      note(0, (is_mine ? type : "no such sender").substr(0, 39).c_str(), message.type);
      add(0, is_mine ? k_configures : k_bad_messages);
    }
  }
}

bool is_ping(const Client& client, const VrpnMessage& message) {
  const auto type = client.types.find(message.type);
  return type != client.types.end() && type->second == "vrpn_Base ping_message";
}

// By TCP, where the rest of a message may come later, or whole in a datagram.
void take_messages(Peer& peer, std::string* bytes) {
  while (!peer.gone) {
    bool is_broken = false;
    const auto message = read_message(*bytes, &is_broken);
    if (is_broken) {
      const Locked lock;
      add(0, k_bad_messages);
      note(0, "no message", -1);
      peer.gone = true;
      return;
    }
    if (!message) {
      return;
    }
    record_raw(peer.number, "in", bytes->substr(0, message->size), false);
    bytes->erase(0, message->size);
    obey(peer, *message);
    if (is_ping(clients()[peer.number], *message)) {
      delay_answer();
      tell_pong(peer);
    }
  }
}

void has_read(Peer& peer) {
  Client& client = clients()[peer.number];
  if (!client.has_cookie) {
    if (peer.in.size() < kCookieSize) {
      return;
    }
    record_raw(peer.number, "in", peer.in.substr(0, kCookieSize), false);
    if (!is_cookie_of(peer.in, static_cast<int>(get(0, k_sdk_major)))) {
      const Locked lock;
      note(0, "wrong cookie", -1);
      add(0, k_bad_messages);
      peer.gone = true;
      return;
    }
    client.has_cookie = true;
    peer.in.erase(0, kCookieSize);
    describe_all(peer);
  }
  take_messages(peer, &peer.in);
}

// What clients send by UDP since it may be lost: fields of force.
bool take_datagram(int fd) {
  for (Peer& peer : peers()) {
    if (clients()[peer.number].udp_in != fd) {
      continue;
    }
    char buffer[65536];
    const ssize_t size = recv(fd, buffer, sizeof(buffer), MSG_DONTWAIT);
    std::string bytes(buffer, size > 0 ? static_cast<std::size_t>(size) : 0);
    add(0, k_udp_messages);
    take_messages(peer, &bytes);
    return true;
  }
  return false;
}

void left(Peer& peer) {
  forget_client(peer.number);
  const Locked lock;
  note(0, "dropped connection", peer.number);
  if (clients().empty() && is_on(0, k_drop_resets) && is_on(0, k_field_active)) {
    drop_field("device: last connection dropped");
  }
}

// A datagram "HOST PORT": the server calls back by TCP. Here always on this machine.
void lobbed(int fd, const Service& service) {
  char text[256] = {};
  const ssize_t size = recv(fd, text, sizeof(text) - 1, MSG_DONTWAIT);
  const char* space = size > 0 ? std::strrchr(text, ' ') : nullptr;
  const int port = space != nullptr ? std::atoi(space) : 0;
  {
    const Locked lock;
    add(0, k_lobs);
    note(0, "lobbed", port);
  }
  if (port > 0 && port < 65536 && !is_on(0, k_silent)) {
    if (const int back = connect_tcp(port); back >= 0) {
      add_peer(back, kCalledBack, service);
    }
  }
}

}  // namespace

int main(int count, char** words) {
  Arguments a = begin(count, words, "VRPN", &own_values);
  const int listener = listen_tcp(&a.port);
  const int udp_socket = bind_udp(&a.port);
  if (listener < 0 || udp_socket < 0) {
    std::fprintf(stderr, "%s: port %d is taken\n", words[0], a.port);
    return 1;
  }
  {
    const Locked lock;
    open_unit(0);
  }
  tell("Haptic0@127.0.0.1:" + std::to_string(a.port), a.port, 0);
  Service service{&came, &has_read, &left, &report_all, &report_period, nullptr, {udp_socket}};
  service.readable = [&](int fd) {
    if (!take_datagram(fd)) {
      lobbed(fd, service);
    }
  };
  use_udp(udp_socket, &service.others);
  serve(service, {listener});
}
