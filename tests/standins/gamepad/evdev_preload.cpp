// The calls that reach a device in /dev/input, put in front of the C library's with LD_PRELOAD, or
// by linking this library first: open, close, read, write, ioctl. poll, select, epoll and fcntl are
// the kernel's own: a descriptor of a gamepad is a socket.
#include <cerrno>
#include <cstdarg>
#include <string>

#include "evdev.h"
#include <fcntl.h>
#include <linux/input.h>
#include <sys/socket.h>
#include <unistd.h>

namespace standin {
namespace {

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

mode_t mode_of_call(int flags, std::va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace
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
  forget_descriptor(fd);
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
