#include "thigma/core/file.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1}
                                      << 32;  // indices are 32 bits; a larger text holds more

// An open descriptor, closed on every way out.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return ::close(fd) == 0;
  }

 private:
  int fd_;
};

[[noreturn]] void fail_read(const std::string& path, const std::string& why) {
  throw InputError(path + ": cannot be read (" + why +
                   "), on opening, a readable file was expected");
}

[[noreturn]] void fail_write(const std::string& path) {
  throw IoError(path + ": cannot be written (" + std::strerror(errno) + ")");
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

// Whether a pipe has bytes or has seen its writer go, within a time in which a writer that was
// started with the program has come.
bool has_news(int fd) {
  constexpr int kWait = 2000;  // [ms]
  pollfd wait{fd, POLLIN, 0};
  return ::poll(&wait, 1, kWait) > 0;
}

bool wait_from_now_on(int fd) {
  const int flags = ::fcntl(fd, F_GETFL);
  return flags >= 0 && ::fcntl(fd, F_SETFL, flags & ~O_NONBLOCK) == 0;
}

}  // namespace

std::string read_file(const std::string& path) {
  // Opened in the other way, a pipe that nobody writes to would wait for ever.
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) fail_read(path, std::strerror(errno));
  struct stat info {};
  if (::fstat(file.get(), &info) != 0) fail_read(path, std::strerror(errno));
  // A character device such as /dev/zero never ends.
  if (!S_ISREG(info.st_mode) && !S_ISFIFO(info.st_mode)) fail_read(path, "not a regular file");
  const bool may_lack_writer = S_ISFIFO(info.st_mode) && !has_news(file.get());
  const std::size_t expected = S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) : 0;
  if (expected > kMaxFileBytes) fail_read(path, "larger than 4 GiB");
  std::string bytes(expected + 1, '\0');  // the spare byte finds the end without growing
  std::size_t size = 0;
  for (;;) {
    if (size == bytes.size()) bytes.resize(bytes.size() + bytes.size() / 2 + 65536);
    const ssize_t n = ::read(file.get(), bytes.data() + size, bytes.size() - size);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN && wait_from_now_on(file.get())) continue;  // slow, but there
    if (n < 0) fail_read(path, std::strerror(errno));
    if (n == 0 && size == 0 && may_lack_writer) fail_read(path, "a pipe that nobody writes to");
    if (n == 0) break;
    size += static_cast<std::size_t>(n);
    if (size > kMaxFileBytes) fail_read(path, "larger than 4 GiB");
  }
  bytes.resize(size);
  return bytes;
}

std::string_view without_byte_order_mark(std::string_view text) noexcept {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

void write_file(const std::string& path, std::string_view bytes) {
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode)) {
    Descriptor device(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (device.get() < 0 || !write_all(device.get(), bytes)) fail_write(path);
    return;
  }
  static std::atomic<unsigned> written{0};  // threads of one process write beside each other
  const std::string temporary =
      path + ".part" + std::to_string(::getpid()) + "." + std::to_string(written++);
  {
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.get() < 0) fail_write(path);
    if (!write_all(file.get(), bytes) || !file.close()) {
      const int why = errno;
      ::unlink(temporary.c_str());
      errno = why;
      fail_write(path);
    }
  }
  if (std::rename(temporary.c_str(), path.c_str()) != 0) {
    const int why = errno;
    ::unlink(temporary.c_str());
    errno = why;
    fail_write(path);
  }
}

}  // namespace thigma
