#include "service.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "../common/board.h"
#include "../common/device.h"
#include "socket.h"
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace standin {
namespace {

std::FILE* raw = nullptr;

[[noreturn]] void usage(const char* program) {
  std::fprintf(stderr,
               "%s BOARD [--port N] [--events-port N] [--socket PATH] [--record FILE] [--stay]\n",
               program);
  std::exit(2);
}

// Faults that hit connections rather than bytes.
void end_peers_by_key() {
  if (is_on(0, k_die)) {
    kill(getpid(), SIGKILL);
  }
  if (is_on(0, k_drop)) {
    put(0, k_drop, 0.0);
    for (Peer& peer : peers()) {
      peer.gone = true;
    }
  }
}

void bury(const Service& service) {
  for (auto peer = peers().begin(); peer != peers().end();) {
    if (!peer->gone) {
      ++peer;
      continue;
    }
    record_raw(peer->number, "note", "gone", true);
    service.left(*peer);
    close(peer->fd);
    peer = peers().erase(peer);
    put(0, k_clients, static_cast<double>(peers().size()));
  }
}

void listen_once(const Service& service, const std::vector<pollfd>& waiting,
                 const std::vector<int>& listeners) {
  const std::size_t others = listeners.size() + service.others.size();
  for (std::size_t i = 0; i < others; ++i) {
    if ((waiting[i].revents & POLLIN) == 0) {
      continue;
    }
    if (i >= listeners.size()) {
      service.readable(waiting[i].fd);
    } else if (const int fd = take(waiting[i].fd); fd >= 0) {
      add_peer(fd, static_cast<int>(i), service);
    }
  }
  for (Peer& peer : peers()) {
    const auto found =
        std::find_if(waiting.begin() + static_cast<std::ptrdiff_t>(others), waiting.end(),
                     [&](const pollfd& w) { return w.fd == peer.fd; });
    if (peer.gone || found == waiting.end() || found->revents == 0) {
      continue;
    }
    peer.gone = !receive(peer.fd, &peer.in);
    service.has_read(peer);
  }
}

}  // namespace

Arguments begin(int count, char** words, const char* name, void (*own_values)()) {
  Arguments a;
  if (count < 2) {
    usage(words[0]);
  }
  a.board = words[1];
  bool stays = false;
  for (int i = 2; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--stay") {
      stays = true;
      continue;
    }
    const char* value = i + 1 < count ? words[++i] : nullptr;
    if (value == nullptr) {
      usage(words[0]);
    }
    if (word == "--port") {
      a.port = std::atoi(value);
    } else if (word == "--events-port") {
      a.events_port = std::atoi(value);
    } else if (word == "--socket") {
      a.socket = value;
    } else if (word == "--record") {
      raw = std::fopen(value, "w");
    } else {
      usage(words[0]);
    }
  }
  if (!stays) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
  }
  setenv((std::string("STANDIN_") + name + "_BOARD").c_str(), a.board.c_str(), 1);
  load(name, own_values);
  board().device.store(getpid());
  std::thread([] { run_device(false); }).detach();
  return a;
}

void tell(const std::string& where, int port, int events_port) {
  put(0, k_port, port);
  put(0, k_events_port, events_port);
  std::printf("listening %s\n", where.c_str());
  std::fflush(stdout);
}

void record_raw(int client, const char* direction, std::string_view bytes, bool is_text) {
  if (raw == nullptr) {
    return;
  }
  std::fprintf(raw, "%.9f %d %s ", now(), client, direction);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (is_text) {
      std::fputc(byte < ' ' ? ' ' : c, raw);
    } else {
      std::fprintf(raw, "%02x", byte);
    }
  }
  std::fputc('\n', raw);
  std::fflush(raw);
}

std::list<Peer>& peers() {
  static auto* const list = new std::list<Peer>;
  return *list;
}

void add_peer(int fd, int kind, const Service& service) {
  if (is_on(0, k_refuse)) {
    close(fd);
    return;
  }
  Peer peer;
  peer.fd = fd;
  peer.kind = kind;
  {
    const Locked lock;
    add(0, k_connections);
    peer.number = static_cast<int>(get(0, k_connections));
    note(0, "connected", peer.number);
  }
  peers().push_back(peer);
  put(0, k_clients, static_cast<double>(peers().size()));
  record_raw(peer.number, "note", "connected", true);
  service.came(peers().back());
}

void serve(const Service& service, const std::vector<int>& listeners) {
  double next = now();
  while (board().quit.load() == 0) {
    std::vector<pollfd> waiting;
    for (const int fd : listeners) {
      waiting.push_back({fd, POLLIN, 0});
    }
    for (const int fd : service.others) {
      waiting.push_back({fd, POLLIN, 0});
    }
    for (const Peer& peer : peers()) {
      waiting.push_back({peer.fd, POLLIN, 0});
    }
    const double wait = std::clamp(next - now(), 0.0, 0.01);
    const timespec timeout{0, static_cast<long>(wait * 1e9)};
    if (ppoll(waiting.data(), waiting.size(), &timeout, nullptr) > 0) {
      listen_once(service, waiting, listeners);
    }
    end_peers_by_key();
    if (now() >= next) {
      service.due();
      const double period = service.period();
      // A machine that slept does not catch up.
      next = std::max(next + period, now() - 4.0 * period);
    }
    bury(service);
  }
  std::_Exit(0);
}

void send_faulty(Peer& peer, std::string_view bytes, std::string_view wrong) {
  if (peer.gone || is_on(0, k_silent)) {
    return;
  }
  std::string_view sent = is_on(0, k_garbage) ? wrong : bytes;
  const double half = get(0, k_half);
  if (half != 0.0) {
    sent = sent.substr(0, sent.size() / 2);
  }
  peer.gone = !send_all(peer.fd, sent) || half == 2.0;
  if (half != 0.0) {  // once; the other half never comes
    put(0, k_silent, half == 1.0 ? 1.0 : 0.0);
    put(0, k_half, 0.0);
  }
  const Locked lock;
  add(0, k_answers);
}

void delay_answer() {
  const double delay = 1e-3 * get(0, k_delay_ms) + 1e-6 * get(0, k_jitter_us) * next_random();
  if (delay > 0.0) {
    sleep_until(now() + delay);
  }
}

double next_random() {
  static std::uint64_t state = 0x9e3779b97f4a7c15;
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return static_cast<double>(state >> 11) * 0x1p-53;
}

}  // namespace standin
