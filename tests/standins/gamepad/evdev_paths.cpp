// Which paths and descriptors are gamepads. STANDIN_EVDEV_FOLDER is standin_gamepad's folder,
// STANDIN_GAMEPAD_BOARD its board.
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "../common/board.h"
#include "evdev.h"
#include <fcntl.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace standin {
namespace {

constexpr int kDescriptors = 4096;
std::atomic<int> unit_plus_one[kDescriptors];  // 0: not one of ours
constexpr const char* kFolder = "/dev/input";

const char* folder() {
  static const char* const path = std::getenv("STANDIN_EVDEV_FOLDER");
  return path;
}

}  // namespace

bool has_board() {
  static const bool opened = [] {
    int inherited = -1;
    const char* path = std::getenv("STANDIN_GAMEPAD_BOARD");
    Board* b = path != nullptr ? open_board(path, &inherited) : nullptr;
    if (b != nullptr) {
      use_board(b);
    }
    return b != nullptr;
  }();
  return opened;
}

// The path of the stand-in for one of the kernel's, empty where it is not ours.
std::string ours(const char* path) {
  const std::size_t size = std::strlen(kFolder);
  const bool is_ours = path != nullptr && folder() != nullptr &&
                       std::strncmp(path, kFolder, size) == 0 &&
                       (path[size] == 0 || path[size] == '/');
  return is_ours ? std::string(folder()) + (path + size) : std::string();
}

int unit_of_path(const std::string& path) {
  const std::size_t at = path.rfind("/event");
  return at == std::string::npos ? -1 : std::atoi(path.c_str() + at + 6);
}

int connect_pad(const std::string& path, int flags) {
  const int unit = unit_of_path(path);
  if (unit < 0 || unit >= kUnits || !has_board()) {
    errno = ENOENT;
    return -1;
  }
  if (is_on(unit, k_no_permission)) {
    errno = EACCES;
    return -1;
  }
  const int kind = SOCK_STREAM | ((flags & O_CLOEXEC) != 0 ? SOCK_CLOEXEC : 0);
  const int fd = socket(AF_UNIX, kind, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
  if (connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    const int error = errno == ECONNREFUSED ? ENODEV : errno;
    close(fd);
    errno = error;
    return -1;
  }
  if ((flags & O_NONBLOCK) != 0) {
    fcntl(fd, F_SETFL, O_NONBLOCK);
  }
  if (fd < kDescriptors) {
    unit_plus_one[fd].store(unit + 1);
  }
  return fd;
}

int unit_of_descriptor(int fd) {
  if (fd < 0 || fd >= kDescriptors || unit_plus_one[fd].load() == 0) {
    return -1;
  }
  return unit_plus_one[fd].load() - 1;
}

void forget_descriptor(int fd) {
  if (fd >= 0 && fd < kDescriptors) {
    unit_plus_one[fd].store(0);
  }
}

bool is_there(int fd) {
  char byte = 0;
  const ssize_t size = recv(fd, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return size > 0 || (size < 0 && (errno == EAGAIN || errno == EINTR));
}

}  // namespace standin
