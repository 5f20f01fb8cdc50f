// standin_gamepad BOARD --socket FOLDER: what the kernel's /dev/input would tell of gamepads. Each
// is a UNIX socket FOLDER/eventN; libstandin_evdev.so makes it a device for a client.
#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "../common/board.h"
#include "../net/service.h"
#include "../net/socket.h"
#include "pad.h"
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace standin;

struct Effect {
  int strong = 0;
  int weak = 0;
  int milliseconds = 0;
};

// What one that has opened the device has uploaded.
std::map<int, std::map<int, Effect>>& effects() {
  static auto* const map = new std::map<int, std::map<int, Effect>>;
  return *map;
}

std::string folder;
std::vector<int> listeners;
double rumble_until[kUnits] = {};
int rumbling[kUnits] = {};  // the number of the peer

void own_values() {
  for (int unit = 0; unit < kUnits; ++unit) {
    put(unit, k_rate, 250);
    put(unit, k_watchdog, 0);
  }
}

std::string event(int type, int code, int value) {
  input_event e{};
  timespec t{};
  clock_gettime(is_on(0, k_clock_id) ? CLOCK_MONOTONIC : CLOCK_REALTIME, &t);
  e.input_event_sec = t.tv_sec;
  e.input_event_usec = t.tv_nsec / 1000;
  e.type = static_cast<std::uint16_t>(type);
  e.code = static_cast<std::uint16_t>(code);
  e.value = value;
  return {reinterpret_cast<const char*>(&e), sizeof(e)};
}

// What has changed since it was told last. Empty where nothing has.
std::string changes(int unit) {
  static std::map<int, int> told[kUnits];
  const Pad& pad = pad_of(unit);
  std::string bytes;
  for (const PadAxis& axis : pad.axes) {
    const int value = axis_value(unit, axis);
    int& last = told[unit][axis.code + 0x10000];
    if (value != last) {
      bytes += event(EV_ABS, axis.code, value);
      last = value;
    }
  }
  for (std::size_t i = 0; i < pad.buttons.size(); ++i) {
    const int value = is_pressed(unit, i) ? 1 : 0;
    int& last = told[unit][pad.buttons[i]];
    if (value != last) {
      bytes += event(EV_KEY, pad.buttons[i], value);
      last = value;
    }
  }
  if (!bytes.empty()) {
    bytes += event(EV_SYN, SYN_REPORT, 0);
  }
  return bytes;
}

void tell_pad(int unit) {
  std::string bytes = changes(unit);
  if (is_on(unit, k_overrun)) {  // the client was too slow: what has changed is lost
    put(unit, k_overrun, 0.0);
    bytes = event(EV_SYN, SYN_DROPPED, 0) + event(EV_SYN, SYN_REPORT, 0);
  }
  if (bytes.empty()) {
    return;
  }
  const std::string garbage = event(0x7777, 0x7777, 0x7777) + event(EV_ABS, ABS_X, 0x7fffffff);
  for (Peer& peer : peers()) {
    if (peer.kind == unit) {
      send_faulty(peer, bytes, garbage);
      const Locked lock;
      add(unit, k_reports);
    }
  }
}

void plug(int unit, bool is_plugged) {
  const std::string path = folder + "/event" + std::to_string(unit);
  int& listener = listeners[static_cast<std::size_t>(unit)];
  if (is_plugged && listener < 0) {
    listener = listen_unix(path);
  } else if (!is_plugged && listener >= 0) {
    close(listener);
    listener = -1;
    unlink(path.c_str());
    for (Peer& peer : peers()) {
      peer.gone = peer.gone || peer.kind == unit;
    }
    const Locked lock;
    note(unit, "device: unplugged", 0);
  }
}

// Under the lock.
void stop_rumble(int unit, const char* why) {
  if (is_on(unit, k_rumble_on)) {
    put(unit, k_rumble_on, 0.0);
    put(unit, k_rumble_off_time, now());
    note(unit, why, 0);
  }
  rumbling[unit] = 0;
}

void play(Peer& peer, int id, int repeats) {
  const int unit = peer.kind;
  const auto effect = effects()[peer.number].find(id);
  if (effect == effects()[peer.number].end()) {
    return;
  }
  if (repeats <= 0) {
    stop_rumble(unit, "device: rumble stopped");
    return;
  }
  const Effect& e = effect->second;
  add(unit, k_effect_plays);
  put(unit, k_rumble_on, 1.0);
  put(unit, k_rumble_strong, e.strong);
  put(unit, k_rumble_weak, e.weak);
  put(unit, k_rumble_ms, e.milliseconds);
  rumbling[unit] = peer.number;
  // A length of 0 has no end.
  rumble_until[unit] = e.milliseconds > 0 ? now() + 1e-3 * repeats * e.milliseconds : 1e300;
  const double values[3] = {static_cast<double>(e.strong), static_cast<double>(e.weak),
                            static_cast<double>(e.milliseconds)};
  note(unit, "EV_FF play", id, values, 3);
}

// Under the lock.
void take_record(Peer& peer, const input_event& e) {
  const int unit = peer.kind;
  std::map<int, Effect>& mine = effects()[peer.number];
  add(unit, k_messages);
  switch (e.type) {
    case kEffectSize:
      mine[e.code].strong = static_cast<int>(static_cast<std::uint32_t>(e.value) >> 16);
      mine[e.code].weak = e.value & 0xffff;
      add(unit, k_effect_uploads);
      break;
    case kEffectTime:
      mine[e.code].milliseconds = e.value;
      break;
    case kEffectErase:
      mine.erase(e.code);
      add(unit, k_effect_erases);
      stop_rumble(unit, "device: effect erased");
      break;
    case EV_FF:
      play(peer, e.code, e.value);
      break;
    default:
      note(unit, "written", e.type);
  }
  put(unit, k_effects, static_cast<double>(mine.size()));
}

void has_read(Peer& peer) {
  while (peer.in.size() >= sizeof(input_event)) {
    input_event e{};
    std::memcpy(&e, peer.in.data(), sizeof(e));
    record_raw(peer.number, "in", peer.in.substr(0, sizeof(e)), false);
    peer.in.erase(0, sizeof(e));
    const Locked lock;
    take_record(peer, e);
  }
}

// The kernel erases the effects of a file that is closed, also by the death of its process.
void left(Peer& peer) {
  effects().erase(peer.number);
  const Locked lock;
  if (rumbling[peer.kind] == peer.number) {
    stop_rumble(peer.kind, "device: closed, effects erased");
  }
  put(peer.kind, k_grabbed, 0.0);
}

void due() {
  for (int unit = 0; unit < kUnits; ++unit) {
    plug(unit, unit < get(0, k_count) && !is_on(unit, k_unplug));
    tell_pad(unit);
    const Locked lock;
    if (is_on(unit, k_rumble_on) && now() >= rumble_until[unit]) {
      stop_rumble(unit, "device: rumble at its end");
    }
  }
}

}  // namespace

int main(int count, char** words) {
  const Arguments a = begin(count, words, "GAMEPAD", &own_values);
  folder = a.socket;
  mkdir(folder.c_str(), 0755);
  listeners.assign(kUnits, -1);
  if (folder.empty() || access(folder.c_str(), W_OK) != 0) {
    std::fprintf(stderr, "%s: --socket: '%s', expected a folder that can be written\n", words[0],
                 folder.c_str());
    return 1;
  }
  for (int unit = 0; unit < kUnits; ++unit) {
    changes(unit);  // the state at the start is no event
    plug(unit, unit < get(0, k_count));
  }
  tell(folder, 0, 0);
  serve({[](Peer&) {},
         &has_read,
         &left,
         &due,
         [] { return 1.0 / std::max(1.0, get(0, k_rate)); },
         [](int) {},
         {}},
        listeners);
}
