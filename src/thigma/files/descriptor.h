#pragma once
// Descriptors of files and folders: closed on every way out, written whole, made safe against a
// power cut.

#include <cerrno>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace thigma {

/// An open descriptor, closed on every way out; -1: none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }
  bool is_open() const { return fd_ >= 0; }
  bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

 private:
  int fd_ = -1;
};

/// False with errno when the system took less.
inline bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

/// What was written is on the disk; false with errno when it is not. True where a file system knows
/// no such thing.
inline bool sync_file(int fd) {
  while (::fsync(fd) != 0) {
    if (errno == EINVAL || errno == EROFS || errno == ENOTSUP) return true;
    if (errno != EINTR) return false;
  }
  return true;
}

/// Names that were given or taken in a folder are on the disk. Not every file system can do that,
/// and who may not read the folder cannot ask: nothing is lost that a power cut at once would not
/// take.
inline void sync_folder(int folder) {
  const Descriptor readable(::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (readable.is_open()) sync_file(readable.get());
}

}  // namespace thigma
