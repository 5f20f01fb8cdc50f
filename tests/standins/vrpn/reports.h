// The server's clients and what it tells them.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "../net/service.h"

namespace standin {

constexpr const char* kDeviceName = "Haptic0";  // tracker, buttons and force device

// Kinds of connections: the client's own, or ours to a client that asked for it by a datagram.
enum Kind { kDirect = 0, kCalledBack = 1 };

struct Client {
  bool has_cookie = false;
  std::map<int, std::string> senders;  // by the client's numbers
  std::map<int, std::string> types;
  int udp_port = 0;        // where it takes datagrams, 0: nowhere
  int udp_in = -1;         // where we take its
  std::uint32_t sent = 0;  // messages, each has its number
};

// By the number of the connection.
std::map<int, Client>& clients();

// Where reports leave that may be lost, and the list of sockets that are listened to.
void use_udp(int socket, std::vector<int>* listened);
void forget_client(int number);

std::string garbage();
// The answer to a ping.
void tell_pong(Peer& peer);
// After the cookies: where datagrams are taken, the names of senders and types by their numbers,
// the state of buttons.
void describe_all(Peer& peer);
// Pose, velocity, changes of buttons, force and error of the device, to all.
void report_all();
// Until the next report, s.
double report_period();

}  // namespace standin
