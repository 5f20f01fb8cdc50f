#include "board.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <new>

#include <fcntl.h>
#include <sched.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace standin {
namespace {

constexpr std::uint64_t kMagic = 0x7468676d2d737469;
Board* the_board = nullptr;

int process() {
  static const int id = getpid();
  return id;
}

}  // namespace

void set_defaults(Board* b) {
  static constexpr double kDefaults[] = {
#define STANDIN_KEY(name, value) value,
      STANDIN_KEYS(STANDIN_KEY)
#undef STANDIN_KEY
  };
  for (auto& unit : b->key) {
    for (int i = 0; i < kKeyCount; ++i) {
      unit[i].store(kDefaults[i]);
    }
  }
  b->events.store(0);
  b->magic = kMagic;
}

Board* open_board(const char* path, int* inherited) {
  const int fd =
      path != nullptr ? open(path, O_RDWR | O_CREAT | O_CLOEXEC, 0600) : memfd_create("standin", 0);
  if (fd < 0) {
    return nullptr;
  }
  flock(fd, LOCK_EX);
  void* memory = MAP_FAILED;
  if (ftruncate(fd, sizeof(Board)) == 0) {
    memory = mmap(nullptr, sizeof(Board), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  }
  Board* b = nullptr;
  if (memory != MAP_FAILED) {
    b = static_cast<Board*>(memory);  // a new file is zeros, as new atomics are
    if (b->magic != kMagic) {
      set_defaults(b);
    }
  }
  flock(fd, LOCK_UN);
  *inherited = path == nullptr ? fd : -1;
  if (path != nullptr) {
    close(fd);
  }
  return b;
}

Board& board() { return *the_board; }
void use_board(Board* b) { the_board = b; }

double now() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void sleep_until(double time) {
  timespec t{};
  t.tv_sec = static_cast<time_t>(time);
  t.tv_nsec = static_cast<long>((time - static_cast<double>(t.tv_sec)) * 1e9);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &t, nullptr) == EINTR) {
  }
}

bool is_dead(int id) {
  if (kill(id, 0) != 0) {
    return errno == ESRCH;
  }
  char text[256] = {};
  std::snprintf(text, sizeof(text), "/proc/%d/stat", id);
  const int fd = open(text, O_RDONLY | O_CLOEXEC);
  const ssize_t size = fd >= 0 ? read(fd, text, sizeof(text) - 1) : 0;
  if (fd >= 0) {
    close(fd);
  }
  text[size > 0 ? size : 0] = 0;
  const char* state = std::strrchr(text, ')');
  return state != nullptr && std::strlen(state) > 2 && (state[2] == 'Z' || state[2] == 'X');
}

Locked::Locked() {
  for (int spin = 1;; ++spin) {
    int holder = 0;
    if (board().holder.compare_exchange_strong(holder, process(), std::memory_order_acquire)) {
      return;
    }
    if (spin % 64 == 0) {
      sched_yield();
    }
    // Somebody who was killed does not give it back.
    if (spin % 4096 == 0 && holder > 0 && holder != process() && is_dead(holder) &&
        board().holder.compare_exchange_strong(holder, process(), std::memory_order_acquire)) {
      return;
    }
  }
}

Locked::~Locked() { board().holder.store(0, std::memory_order_release); }

void note(int unit, const char* call, int code, const double* values, int count) {
  const std::uint64_t number = board().events.load();
  Event& e = board().event[number % kEvents];
  e = Event();
  e.time = now();
  e.number = number + 1;
  std::strncpy(e.call, call, sizeof(e.call) - 1);
  e.unit = unit;
  e.code = code;
  for (int i = 0; i < count && i < 7; ++i) {
    e.value[i] = values[i];
  }
  board().events.store(number + 1);
}

}  // namespace standin
