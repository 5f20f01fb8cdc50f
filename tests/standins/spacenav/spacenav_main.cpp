// standin_spacenav BOARD --socket PATH: the daemon of SpaceMice, pretended: its UNIX socket,
// protocols 0 and 1. README.md says what comes from where.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>

#include "../common/board.h"
#include "../net/service.h"
#include "../net/socket.h"
#include "requests.h"

namespace {

using namespace standin;

enum Event { kMotion = 0, kPress = 1, kRelease = 2, kDevice = 3 };
enum Mask { kMotions = 1, kButtons = 2, kDevices = 4 };
constexpr double kScan = 0.008;  // s, the mouse tells its deflection 125 times a second

std::map<int, SpaceClient>& clients() {
  static auto* const map = new std::map<int, SpaceClient>;
  return *map;
}

void own_values() {
  put(0, k_rate, 125);
  put(0, k_watchdog, 0);
}

std::string garbage() {
  Packet packet{};
  packet.fill(0x5a5a5a5a);
  return get(0, k_garbage) == 2.0 ? "not a packet" : bytes_of(packet);
}

void tell_clients(int mask, const Packet& event) {
  for (Peer& peer : peers()) {
    const SpaceClient& client = clients()[peer.number];
    if (peer.gone || (client.mask & mask) == 0) {
      continue;
    }
    Packet told = event;
    if (told[0] == kMotion) {
      for (std::size_t i = 1; i < 7; ++i) {
        told[i] = static_cast<std::int32_t>(static_cast<float>(told[i]) * client.sensitivity);
      }
    }
    send_faulty(peer, bytes_of(told), garbage());
    const Locked lock;
    add(0, k_reports);
  }
}

// Deflections after the dead zone, at most what the mouse can tell.
std::array<std::int32_t, 6> deflections() {
  std::array<std::int32_t, 6> counts{};
  const double most = get(0, k_counts_max);
  for (int i = 0; i < 6; ++i) {
    const double value =
        std::clamp(std::round(get(0, static_cast<Key>(k_axis_x + i))), -most, most);
    const bool is_noise = std::fabs(value) < get(0, k_dead_zone);
    counts[i] = is_noise ? 0 : static_cast<std::int32_t>(value);
  }
  return counts;
}

// The same deflection is told again only where the daemon repeats; a mouse at rest is silent.
void tell_motion() {
  static std::array<std::int32_t, 6> told{};
  static double told_at = now();
  const std::array<std::int32_t, 6> counts = deflections();
  const bool is_zero = std::all_of(counts.begin(), counts.end(), [](int c) { return c == 0; });
  const double repeat = get(0, k_repeat_ms);
  const bool repeats = repeat >= 0.0 && !is_zero && now() - told_at >= 1e-3 * repeat;
  if (counts == told && !repeats) {
    return;
  }
  Packet packet{};
  packet[0] = kMotion;
  std::copy(counts.begin(), counts.end(), packet.begin() + 1);
  packet[7] = static_cast<std::int32_t>(1e3 * (now() - told_at));
  told = counts;
  told_at = now();
  tell_clients(kMotions, packet);
}

void tell_buttons() {
  static unsigned told = 0;
  const auto buttons = static_cast<unsigned>(get(0, k_buttons));
  for (int i = 0; i < 16; ++i) {
    if (((buttons ^ told) >> i & 1U) == 0) {
      continue;
    }
    const bool is_pressed = (buttons >> i & 1U) != 0;
    tell_clients(kButtons, Packet{is_pressed ? kPress : kRelease, i, is_pressed ? 1 : 0});
  }
  told = buttons;
}

// True while there is a mouse; clients of protocol 1 are told when that changes.
bool tell_device() {
  static bool was_plugged = true;
  const bool is_plugged = !is_on(0, k_unplug);
  if (is_plugged != was_plugged) {
    tell_clients(kDevices, Packet{kDevice, is_plugged ? 0 : 1, 0, kDeviceType, kVendor, kProduct});
  }
  was_plugged = is_plugged;
  return is_plugged;
}

void due() {
  if (tell_device()) {
    tell_motion();
    tell_buttons();
  }
}

// Protocol 0: four bytes, a sensitivity, or a number that asks for another protocol.
void take_word(Peer& peer, SpaceClient* client) {
  std::int32_t word = 0;
  std::memcpy(&word, peer.in.data(), sizeof(word));
  record_raw(peer.number, "in", peer.in.substr(0, sizeof(word)), false);
  peer.in.erase(0, sizeof(word));
  const auto most = static_cast<std::int32_t>(get(0, k_protocol));
  // A daemon from before protocol 1 takes the number for a sensitivity: not finite, ignored.
  if (most > 0 && (word & static_cast<std::int32_t>(0xffffff00)) == (kTag | kChangeProtocol)) {
    client->protocol = std::min(word & 0xff, most);
    client->mask = client->protocol > 0 ? kMotions | kButtons | kDevices : client->mask;
    word = kTag | kChangeProtocol | client->protocol;
    {
      const Locked lock;
      note(0, "protocol", client->protocol);
    }
    send_faulty(peer, {reinterpret_cast<const char*>(&word), sizeof(word)}, garbage());
    return;
  }
  float sensitivity = 0.0F;
  std::memcpy(&sensitivity, &word, sizeof(word));
  const Locked lock;
  if (std::isfinite(sensitivity)) {
    client->sensitivity = sensitivity;
    put(0, k_sensitivity, static_cast<double>(sensitivity));
  }
  const double value = static_cast<double>(sensitivity);
  note(0, "sensitivity", std::isfinite(sensitivity) ? 0 : -1, &value, 1);
}

void has_read(Peer& peer) {
  SpaceClient& client = clients()[peer.number];
  while (!peer.gone && peer.in.size() >= (client.protocol == 0 ? 4 : kPacketSize)) {
    {
      const Locked lock;
      add(0, k_messages);
    }
    if (client.protocol == 0) {
      take_word(peer, &client);
      continue;
    }
    const std::string bytes = peer.in.substr(0, kPacketSize);
    record_raw(peer.number, "in", bytes, false);
    peer.in.erase(0, kPacketSize);
    std::string answer;
    {
      const Locked lock;
      answer = answer_request(&client, packet_of(bytes));
    }
    delay_answer();
    if (!answer.empty()) {
      send_faulty(peer, answer, garbage());
    }
  }
}

void left(Peer& peer) {
  clients().erase(peer.number);
  const Locked lock;
  note(0, "gone", peer.number);
}

}  // namespace

int main(int count, char** words) {
  const Arguments a = begin(count, words, "SPACENAV", &own_values);
  const int listener = a.socket.empty() ? -1 : listen_unix(a.socket);
  if (listener < 0) {
    std::fprintf(stderr, "%s: --socket: '%s', expected a path for a socket\n", words[0],
                 a.socket.c_str());
    return 1;
  }
  tell(a.socket, 0, 0);
  serve({[](Peer&) {},
         &has_read,
         &left,
         &due,
         [] { return get(0, k_rate) > 0.0 ? 1.0 / get(0, k_rate) : kScan; },
         [](int) {},
         {}},
        {listener});
}
