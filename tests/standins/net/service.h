// What every stand-in that is a process has: a board, a record of bytes, a device that moves, and
// a loop that waits for sockets and for the time of the next report.
#pragma once

#include <cstdio>
#include <functional>
#include <list>
#include <string>
#include <string_view>
#include <vector>

namespace standin {

// PROGRAM BOARD [--port N] [--events-port N] [--socket PATH] [--record FILE]
struct Arguments {
  std::string board;
  std::string socket;  // a path
  int port = 0;        // 0: a free one
  int events_port = -1;
};

// Reads the arguments, maps the board, reads its keys from STANDIN_<NAME>_<KEY>, ends with the
// program that started it. Ends the program with 2 where the arguments are wrong.
Arguments begin(int count, char** words, const char* name, void (*own_values)());
// Tells where the service listens, on the board and as a line "listening WHERE".
void tell(const std::string& where, int port, int events_port);

// The raw record: a line TIME CLIENT in|out|note TEXT, bytes that are no text as hexadecimal.
void record_raw(int client, const char* direction, std::string_view bytes, bool is_text);

// One that is connected.
struct Peer {
  int fd = -1;
  int number = 0;     // 1 for the first
  int kind = 0;       // whose of the listeners
  bool gone = false;  // closed after this round
  std::string in;     // what came and was not read yet
};

// What a service does; called with the lock of the board not held.
struct Service {
  std::function<void(Peer&)> came;      // connected
  std::function<void(Peer&)> has_read;  // something new in `in`
  std::function<void(Peer&)> left;      // gone
  std::function<void()> due;            // the time of a report, see `period`
  std::function<double()> period;       // s, until the next; 0.01 where nothing is reported
  std::function<void(int)> readable;    // one of `others`
  std::vector<int> others;              // descriptors that are not connections
};

std::list<Peer>& peers();
void add_peer(int fd, int kind, const Service& service);
// Until the key `quit` of the board. `listeners` in the order of their kinds.
[[noreturn]] void serve(const Service& service, const std::vector<int>& listeners);

// What a fault makes of bytes that would be sent: whole, garbage, half; ends the peer where the
// fault says so, sends nothing where the service is silent. `wrong` is garbage of this protocol.
void send_faulty(Peer& peer, std::string_view bytes, std::string_view wrong);

// Waits as long as an answer takes: `delay_ms`, and a random part of `jitter_us`.
void delay_answer();
// A repeatable number from 0 to 1.
double next_random();

}  // namespace standin
