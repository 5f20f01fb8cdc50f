#include "thigma/files/file.h"

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/descriptor.h"

namespace thigma {
namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{1}
                                      << 32;  // indices are 32 bits; a larger text holds more

[[noreturn]] void fail_read(const std::string& path, const std::string& why) {
  throw InputError(path + ": cannot be read (" + why +
                   "), on opening, a readable file was expected");
}

[[noreturn]] void fail_write(const std::string& path) {
  throw IoError(path + ": cannot be written (" + std::strerror(errno) + ")");
}

/// A new file beside `path` under a name that nobody else has, threads and other machines on a
/// shared folder included.
Descriptor open_temporary(const std::string& path, std::string& temporary) {
  static std::atomic<unsigned> written{0};
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries; ++i) {
    temporary = path + ".part" + std::to_string(::getpid()) + "." + std::to_string(written++);
    Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.is_open() || errno != EEXIST) return file;
  }
  return Descriptor();
}

/// The folder that a path is in; not open when that cannot be.
Descriptor open_folder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return Descriptor(
      ::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
}

/// Bytes before the name, both on the disk: a power cut leaves the old file or the new one.
bool replace_file(const std::string& path, const std::string& temporary, Descriptor& file) {
  if (!sync_file(file.get()) || !file.close()) return false;
  if (std::rename(temporary.c_str(), path.c_str()) != 0) return false;
  if (const Descriptor folder = open_folder(path); folder.is_open()) sync_folder(folder.get());
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

FileWriter::FileWriter(const std::string& path) : path_(path) {
  struct stat info {};
  if (::stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode)) {
    file_ = Descriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  } else {
    file_ = open_temporary(path, temporary_);
  }
  if (file_.is_open()) return;
  temporary_.clear();
  fail_write(path);
}

FileWriter::~FileWriter() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void FileWriter::fail() {
  const int why = errno;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  errno = why;
  fail_write(path_);
}

void FileWriter::append(std::string_view bytes) {
  if (!write_all(file_.get(), bytes)) fail();
}

void FileWriter::keep() {
  if (temporary_.empty()) return;
  if (!replace_file(path_, temporary_, file_)) fail();
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
  FileWriter file(path);
  file.append(bytes);
  file.keep();
}

}  // namespace thigma
