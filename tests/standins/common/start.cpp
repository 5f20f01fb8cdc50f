// Starting the device: a thread, or the program standin_device that outlives the client.
#include <cstdlib>
#include <string>
#include <thread>

#include "board.h"
#include "device.h"
#include <dlfcn.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace standin {
namespace {

int inherited_board = -1;
const char* library_name = "";
void (*values_of_library)() = nullptr;

// Made at the first use and never destroyed: the library is loaded and left in any order.
std::string& board_path() {
  static auto* const path = new std::string;
  return *path;
}
std::thread& device_thread() {
  static auto* const thread = new std::thread;
  return *thread;
}

// Beside the library's file, or one folder up.
std::string program() {
  Dl_info info{};
  dladdr(reinterpret_cast<const void*>(&start_device), &info);
  std::string folder = info.dli_fname != nullptr ? info.dli_fname : "";
  folder = folder.substr(0, folder.rfind('/'));
  const std::string here = folder + "/standin_device";
  return access(here.c_str(), X_OK) == 0 ? here : folder + "/../standin_device";
}

bool start_process() {
  if (board().device.load() > 0 && !is_dead(board().device.load())) {
    return true;  // that of a client before, on the same board
  }
  std::string name = program();
  std::string path =
      inherited_board >= 0 ? "/proc/self/fd/" + std::to_string(inherited_board) : board_path();
  char* arguments[] = {name.data(), path.data(), nullptr};
  pid_t child = 0;
  board().device.store(-1);  // it writes its own number
  if (posix_spawn(&child, name.c_str(), nullptr, nullptr, arguments, environ) != 0) {
    return false;
  }
  waitpid(child, nullptr, 0);  // it goes on in the background
  for (int i = 0; i < 1000 && board().device.load() <= 0; ++i) {
    sleep_until(now() + 0.005);
  }
  return board().device.load() > 0;
}

bool is_running() {
  static bool started = false;
  const bool before = started;
  started = true;
  return before;
}

}  // namespace

void load(const char* library, void (*own_values)()) {
  const char* path = std::getenv((std::string("STANDIN_") + library + "_BOARD").c_str());
  board_path() = path != nullptr ? path : "";
  Board* b = open_board(path, &inherited_board);
  if (b == nullptr) {
    b = open_board(nullptr, &inherited_board);
  }
  use_board(b);
  b->quit.store(0);
  b->client.store(getpid());
  library_name = library;
  values_of_library = own_values;
  own_values();
  read_environment(library);
  for (int unit = 0; unit < kUnits; ++unit) {
    put(unit, k_opened, 0.0);
    put(unit, k_mode, kIdle);
  }
}

void reset_device() {
  const Locked lock;
  set_defaults(&board());
  values_of_library();
  read_environment(library_name);
}

void start_device() {
  if (is_running() || (is_on(0, k_process) && start_process())) {
    return;
  }
  board().device.store(0);
  device_thread() = std::thread([] { run_device(false); });
}

void stop_device() {
  board().quit.store(1);
  if (device_thread().joinable()) {
    device_thread().join();
  }
}

}  // namespace standin
