// The calls that reach /dev/input, put in front of the C library's with LD_PRELOAD:
// open, read, write, ioctl, stat, access, listing. poll, select, epoll, fcntl and close are the
// kernel's own: a descriptor of a gamepad is a socket. STANDIN_EVDEV_FOLDER is standin_gamepad's
// folder, STANDIN_GAMEPAD_BOARD its board.
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>

#include "../common/board.h"
#include "evdev.h"
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/input.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#define STANDIN_CALL extern "C" __attribute__((visibility("default")))

namespace standin {
namespace {

constexpr int kDescriptors = 4096;
std::atomic<int> unit_plus_one[kDescriptors];  // 0: not one of ours
constexpr const char* kFolder = "/dev/input";
constexpr unsigned kMajor = 13;  // of input devices; the minor of event0 is 64
constexpr unsigned kMinor = 64;

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

const char* folder() {
  static const char* const path = std::getenv("STANDIN_EVDEV_FOLDER");
  return path;
}

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

// A folder is opened as such; a device becomes a connection.
template <class Open>
int open_path(const char* path, int flags, Open really) {
  const std::string mine = ours(path);
  if (mine.empty()) {
    return really(path);
  }
  if ((flags & O_DIRECTORY) != 0 || mine.find("/event") == std::string::npos) {
    return really(mine.c_str());
  }
  return connect_pad(mine, flags);
}

template <class Status>
int as_device(const std::string& path, int result, Status* status) {
  const int unit = unit_of_path(path);
  if (result == 0 && S_ISSOCK(status->st_mode) && unit >= 0) {
    const bool is_open = has_board() && !is_on(unit, k_no_permission);
    status->st_mode = S_IFCHR | (is_open ? 0660U : 0000U);
    status->st_rdev = makedev(kMajor, kMinor + static_cast<unsigned>(unit));
  }
  return result;
}

mode_t mode_of_call(int flags, std::va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace

int unit_of_descriptor(int fd) {
  if (fd < 0 || fd >= kDescriptors || unit_plus_one[fd].load() == 0) {
    return -1;
  }
  return unit_plus_one[fd].load() - 1;
}

bool is_there(int fd) {
  char byte = 0;
  const ssize_t size = recv(fd, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return size > 0 || (size < 0 && (errno == EAGAIN || errno == EINTR));
}

}  // namespace standin

using namespace standin;

#define STANDIN_OPEN(name)                                                \
  STANDIN_CALL int name(const char* path, int flags, ...) {               \
    std::va_list arguments;                                               \
    va_start(arguments, flags);                                           \
    const mode_t mode = mode_of_call(flags, arguments);                   \
    va_end(arguments);                                                    \
    return open_path(path, flags, [&](const char* p) {                    \
      return next<int (*)(const char*, int, ...)>(#name)(p, flags, mode); \
    });                                                                   \
  }
#define STANDIN_OPENAT(name)                                                       \
  STANDIN_CALL int name(int at, const char* path, int flags, ...) {                \
    std::va_list arguments;                                                        \
    va_start(arguments, flags);                                                    \
    const mode_t mode = mode_of_call(flags, arguments);                            \
    va_end(arguments);                                                             \
    return open_path(path, flags, [&](const char* p) {                             \
      return next<int (*)(int, const char*, int, ...)>(#name)(at, p, flags, mode); \
    });                                                                            \
  }
STANDIN_OPEN(open)
STANDIN_OPEN(open64)
STANDIN_OPENAT(openat)
STANDIN_OPENAT(openat64)

// With _FORTIFY_SOURCE, calls without a mode.
STANDIN_CALL int __open_2(const char* path, int flags) { return open(path, flags); }
STANDIN_CALL int __open64_2(const char* path, int flags) { return open64(path, flags); }

STANDIN_CALL int close(int fd) {
  if (fd >= 0 && fd < kDescriptors) {
    unit_plus_one[fd].store(0);
  }
  return next<int (*)(int)>("close")(fd);
}

// Whole events; ENODEV where the device is gone.
STANDIN_CALL ssize_t read(int fd, void* buffer, size_t size) {
  const auto really = next<ssize_t (*)(int, void*, size_t)>("read");
  if (unit_of_descriptor(fd) < 0) {
    return really(fd, buffer, size);
  }
  if (size < sizeof(input_event)) {
    errno = EINVAL;
    return -1;
  }
  const ssize_t got = really(fd, buffer, size / sizeof(input_event) * sizeof(input_event));
  if (got == 0 || (got < 0 && errno == ECONNRESET)) {
    errno = ENODEV;
    return -1;
  }
  return got;
}

STANDIN_CALL ssize_t __read_chk(int fd, void* buffer, size_t size, size_t) {
  return read(fd, buffer, size);
}

STANDIN_CALL ssize_t write(int fd, const void* buffer, size_t size) {
  if (unit_of_descriptor(fd) < 0) {
    return next<ssize_t (*)(int, const void*, size_t)>("write")(fd, buffer, size);
  }
  if (size < sizeof(input_event)) {
    errno = EINVAL;
    return -1;
  }
  const ssize_t sent = send(fd, buffer, size, MSG_NOSIGNAL);
  if (sent < 0 && errno == EPIPE) {
    errno = ENODEV;
  }
  return sent;
}

STANDIN_CALL int ioctl(int fd, unsigned long request, ...) {
  std::va_list arguments;
  va_start(arguments, request);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  const int unit = unit_of_descriptor(fd);
  return unit < 0 ? next<int (*)(int, unsigned long, ...)>("ioctl")(fd, request, argument)
                  : answer_ioctl(fd, unit, request, argument);
}

#define STANDIN_STAT(name, Status)                                               \
  STANDIN_CALL int name(const char* path, struct Status* status) noexcept {      \
    const std::string mine = ours(path);                                         \
    const auto really = next<int (*)(const char*, struct Status*)>(#name);       \
    return mine.empty() ? really(path, status)                                   \
                        : as_device(mine, really(mine.c_str(), status), status); \
  }
STANDIN_STAT(stat, stat)
STANDIN_STAT(lstat, stat)
STANDIN_STAT(stat64, stat64)
STANDIN_STAT(lstat64, stat64)

STANDIN_CALL int fstatat(int at, const char* path, struct stat* status, int flags) noexcept {
  const std::string mine = ours(path);
  const auto really = next<int (*)(int, const char*, struct stat*, int)>("fstatat");
  return mine.empty() ? really(at, path, status, flags)
                      : as_device(mine, really(at, mine.c_str(), status, flags), status);
}

STANDIN_CALL int statx(int at, const char* path, int flags, unsigned mask,
                       struct statx* status) noexcept {
  const std::string mine = ours(path);
  const auto really = next<int (*)(int, const char*, int, unsigned, struct statx*)>("statx");
  if (mine.empty()) {
    return really(at, path, flags, mask, status);
  }
  const int result = really(at, mine.c_str(), flags, mask, status);
  const int unit = unit_of_path(mine);
  if (result == 0 && S_ISSOCK(status->stx_mode) && unit >= 0) {
    const bool is_open = has_board() && !is_on(unit, k_no_permission);
    status->stx_mode = static_cast<std::uint16_t>(S_IFCHR | (is_open ? 0660U : 0U));
    status->stx_rdev_major = kMajor;
    status->stx_rdev_minor = kMinor + static_cast<unsigned>(unit);
  }
  return result;
}

STANDIN_CALL int access(const char* path, int mode) noexcept {
  const std::string mine = ours(path);
  const int unit = unit_of_path(mine);
  if (!mine.empty() && unit >= 0 && unit < kUnits && mode != F_OK && has_board() &&
      is_on(unit, k_no_permission)) {
    errno = EACCES;
    return -1;
  }
  return next<int (*)(const char*, int)>("access")(mine.empty() ? path : mine.c_str(), mode);
}

STANDIN_CALL DIR* opendir(const char* path) {
  const std::string mine = ours(path);
  return next<DIR* (*)(const char*)>("opendir")(mine.empty() ? path : mine.c_str());
}

// Sockets of the folder are character devices to a client.
STANDIN_CALL struct dirent* readdir(DIR* directory) {
  struct dirent* entry = next<struct dirent* (*)(DIR*)>("readdir")(directory);
  if (entry != nullptr && entry->d_type == DT_SOCK &&
      std::strncmp(entry->d_name, "event", 5) == 0) {
    entry->d_type = DT_CHR;
  }
  return entry;
}
STANDIN_CALL struct dirent64* readdir64(DIR* directory) {
  return reinterpret_cast<struct dirent64*>(readdir(directory));
}
