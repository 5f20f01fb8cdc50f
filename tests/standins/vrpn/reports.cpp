#include "reports.h"

#include <algorithm>
#include <cmath>

#include "../common/board.h"
#include "../common/device.h"
#include "../net/socket.h"
#include "field.h"
#include "wire.h"
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace standin {
namespace {

constexpr const char* kSenders[] = {"VRPN Control", kDeviceName};
constexpr int kDevice = 1;

// In the order of their numbers.
constexpr const char* kTypes[] = {"VRPN_Connection_Got_First_Connection",
                                  "VRPN_Connection_Got_Connection",
                                  "VRPN_Connection_Dropped_Connection",
                                  "VRPN_Connection_Dropped_Last_Connection",
                                  "vrpn_Base text_message",
                                  "vrpn_Base ping_message",
                                  "vrpn_Base pong_message",
                                  "vrpn_Tracker Pos_Quat",
                                  "vrpn_Tracker Velocity",
                                  "vrpn_Tracker set_update_rate",
                                  "vrpn_Button Change",
                                  "vrpn_Button States",
                                  "vrpn_ForceDevice Force",
                                  "vrpn_ForceDevice Force_Field",
                                  "vrpn_ForceDevice Force_Error"};
enum Type {
  kPong = 6,
  kPosQuat = 7,
  kVelocityReport = 8,
  kChange = 10,
  kStates = 11,
  kForceReport = 12,
  kErrorReport = 14
};
constexpr int kButtonCount = 4;

int udp_socket = -1;
std::vector<int>* others = nullptr;
unsigned told_buttons = 0;

void tell_peer(Peer& peer, int type, const std::string& payload, bool may_be_lost = false) {
  Client& client = clients()[peer.number];
  std::string bytes = write_message(type < 0 ? 0 : kDevice, type, payload, client.sent++);
  if (is_on(0, k_lie_length)) {  // a length that no message has
    bytes.replace(0, 4, "\x7f\xff\xff\xf0", 4);
  }
  if (may_be_lost && peer.kind == kCalledBack && client.udp_port > 0 && is_on(0, k_udp) &&
      !is_on(0, k_silent) && !is_on(0, k_garbage) && !is_on(0, k_half)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(client.udp_port));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    sendto(udp_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL,
           reinterpret_cast<const sockaddr*>(&to), sizeof(to));
    const Locked lock;
    add(0, k_udp_reports);
    return;
  }
  send_faulty(peer, bytes, garbage());
}

// The description of a sender or type: the number takes the sender's place.
void describe(Peer& peer, int type, int number, const std::string& payload) {
  const std::string bytes = write_message(number, type, payload, clients()[peer.number].sent++);
  send_faulty(peer, bytes, garbage());
}

void say_states(Peer& peer) {
  std::string payload;
  add_int(&payload, kButtonCount);
  for (int i = 0; i < kButtonCount; ++i) {
    add_int(&payload, static_cast<std::int32_t>((told_buttons >> i) & 1U));
  }
  tell_peer(peer, kStates, payload);
}

std::string pose_report() {
  const Locked lock;
  const Pose pose = told_pose(0);
  std::string payload;
  add_int(&payload, 0);
  add_int(&payload, 0);  // the sensor again, to fill
  for (const double p : pose.position) {
    add_double(&payload, p);
  }
  for (const int i : {1, 2, 3, 0}) {  // x, y, z, w
    add_double(&payload, pose.orientation[i]);
  }
  add(0, k_reports);
  return payload;
}

std::string velocity_report() {
  const Locked lock;
  constexpr double kSpan = 0.01;  // s, of the turn that tells the velocity of turning
  std::string payload;
  add_int(&payload, 0);
  add_int(&payload, 0);
  for (const Key key : {k_vx, k_vy, k_vz}) {
    add_double(&payload, is_on(0, k_nan_velocity) ? std::nan("") : get(0, key));
  }
  const Quat q = turn({kSpan * get(0, k_wx), kSpan * get(0, k_wy), kSpan * get(0, k_wz)});
  for (const int i : {1, 2, 3, 0}) {
    add_double(&payload, q[i]);
  }
  add_double(&payload, kSpan);
  return payload;
}

void tell_all(int type, const std::string& payload, bool may_be_lost) {
  for (Peer& peer : peers()) {
    if (!peer.gone && clients()[peer.number].has_cookie) {
      tell_peer(peer, type, payload, may_be_lost);
    }
  }
}

void tell_buttons() {
  const auto buttons = static_cast<unsigned>(get(0, k_buttons));
  for (int i = 0; i < kButtonCount; ++i) {
    if (((buttons ^ told_buttons) >> i & 1U) != 0) {
      std::string payload;
      add_int(&payload, i);
      add_int(&payload, static_cast<std::int32_t>((buttons >> i) & 1U));
      tell_all(kChange, payload, false);
    }
  }
  told_buttons = buttons;
}

}  // namespace

void report_all() {
  int error = -1;
  std::string force;
  {
    const Locked lock;
    if (is_on(0, k_plugged) && is_on(0, k_unplug)) {
      advance(0);
    } else if (!is_on(0, k_plugged) && !is_on(0, k_unplug)) {
      open_unit(0);
    }
    error = feel_field();
    for (const Key key : {k_applied_fx, k_applied_fy, k_applied_fz}) {
      add_double(&force, get(0, key));
    }
  }
  if (is_on(0, k_unplug) || clients().empty()) {
    return;  // nothing more is told
  }
  tell_all(kPosQuat, pose_report(), true);
  if (is_on(0, k_velocity_reports)) {
    tell_all(kVelocityReport, velocity_report(), true);
  }
  tell_buttons();
  if (is_on(0, k_force_reports)) {
    tell_all(kForceReport, force, true);
  }
  if (error >= 0) {
    std::string payload;
    add_int(&payload, error);
    tell_all(kErrorReport, payload, false);
  }
}

double report_period() {
  return 1.0 / std::max(1.0, get(0, k_rate)) + 1e-6 * get(0, k_jitter_us) * (next_random() - 0.5);
}

std::map<int, Client>& clients() {
  static auto* const map = new std::map<int, Client>;
  return *map;
}

void use_udp(int socket, std::vector<int>* listened) {
  udp_socket = socket;
  others = listened;
}

void forget_client(int number) {
  const int fd = clients()[number].udp_in;
  if (fd >= 0) {
    std::erase(*others, fd);
    close(fd);
  }
  clients().erase(number);
}

std::string garbage() { return {"\xde\xad\xbe\xef\x00\x00\x00\x07garbage garbage garbage!", 32}; }

void tell_pong(Peer& peer) { tell_peer(peer, kPong, ""); }

void describe_all(Peer& peer) {
  // One that came by TCP gets all by TCP.
  if (is_on(0, k_udp) && peer.kind == kCalledBack) {
    int port = 0;
    clients()[peer.number].udp_in = bind_udp(&port);
    others->push_back(clients()[peer.number].udp_in);
    describe(peer, kUdpDescription, port, std::string("127.0.0.1") + '\0');
  }
  int number = 0;
  for (const char* name : kSenders) {
    describe(peer, kSenderDescription, number++, description(name));
  }
  number = 0;
  for (const char* name : kTypes) {
    describe(peer, kTypeDescription, number++, description(name));
  }
  say_states(peer);
}

}  // namespace standin
