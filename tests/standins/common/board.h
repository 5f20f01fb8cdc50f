// The board: everything a stand-in is told, is and was sent, in one piece of shared memory. It may
// be a file, so that
// another process sets keys while the client runs and reads the record after the client was killed.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdio>

#include "keys.h"

namespace standin {

constexpr int kUnits = 2;                   // devices of one library
constexpr std::uint64_t kEvents = 1 << 18;  // a ring; the counters keep count beyond it

// One call that changed something, as it came.
struct Event {
  double time = 0.0;         // s, CLOCK_MONOTONIC, the same in every process
  std::uint64_t number = 0;  // 1 for the first
  char call[40] = {};        // the vendor's name of the function, or what the device did
  std::int32_t unit = 0;
  std::int32_t code = 0;  // what was returned, or the error
  double value[7] = {};   // force, torque, gripper force; or the arguments
};

struct Board {
  std::uint64_t magic = 0;
  std::atomic<int> holder;  // process that holds the lock, 0: nobody
  std::atomic<int> quit;    // the device process ends
  std::atomic<int> client;  // process of the library
  std::atomic<int> device;  // process of the device, 0: a thread of the client
  std::atomic<double> key[kUnits][kKeyCount];
  std::atomic<std::uint64_t> events;
  Event event[kEvents];
};

// Maps the board, a file or, with null, memory of this process that a child inherits; null where it
// cannot.
//  `inherited` is the descriptor to hand to a child, -1 where a path does.
Board* open_board(const char* path, int* inherited);

// Every key to its value at the start, no events.
void set_defaults(Board* b);

// The one board of this program or library.
Board& board();
void use_board(Board* b);

// Seconds, CLOCK_MONOTONIC.
double now();
// Sleeps until that time.
void sleep_until(double time);

inline double get(int unit, Key key) { return board().key[unit][key].load(); }
inline void put(int unit, Key key, double value) { board().key[unit][key].store(value); }
inline bool is_on(int unit, Key key) { return get(unit, key) != 0.0; }
// Under the lock.
inline void add(int unit, Key key) { put(unit, key, get(unit, key) + 1.0); }

// Whether a process is gone, or killed and not yet waited for.
bool is_dead(int process);

// A lock that survives the death of its holder. Spins, allocates nothing.
class Locked {
 public:
  Locked();
  ~Locked();
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
};

// Adds an event. Under the lock.
void note(int unit, const char* call, int code, const double* values = nullptr, int count = 0);

// Number of a key, -1 where there is none; "1.unplug" names the second device only (`unit` 1),
// "unplug" all (-1).
int find_key(const char* name, int* unit);

// Sets keys from STANDIN_<LIBRARY>_<KEY> and, of one device, STANDIN_<LIBRARY>_<0|1>_<KEY>.
void read_environment(const char* library);

// Writes counters and events as text.
bool write_log(const char* path);

}  // namespace standin
