#include "thigma/files/growing_file.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "thigma/core/error.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

}  // namespace

GrowingFile::GrowingFile(const std::string& path)
    : path_(path), name_(fs::path(path).filename().string()) {
  // Renaming would fail at a folder after the whole session, and put a file in the place of a
  // device such as /dev/null.
  std::error_code unknown;
  if (fs::exists(path, unknown) && !fs::is_regular_file(path, unknown)) fail("not a regular file");
  const fs::path folder = fs::path(path).parent_path();
  folder_ =
      Descriptor(::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (!folder_.is_open()) fail(std::strerror(errno));
  open_part();
  sync_folder(folder_.get());
  syncing_ = std::thread([this] { sync_now_and_then(); });
}

GrowingFile::~GrowingFile() { stop_syncing(); }

void GrowingFile::fail(const std::string& why) const {
  throw IoError(path_ + ": cannot be written: " + why);
}

/// A part of one's own, empty and locked.
void GrowingFile::open_part() {
  const std::string part = name_ + ".part";
  constexpr int kTries = 100;  // another process may finish between the two steps, not every time
  for (int i = 0; i < kTries; ++i) {
    file_ = Descriptor(
        ::openat(folder_.get(), part.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!file_.is_open()) fail(std::strerror(errno));
    if (::flock(file_.get(), LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK)
        fail("another process is writing it, expected another name or the end of that process");
      fail(std::string("its folder knows no locks, expected a folder that does (") +
           std::strerror(errno) + ")");
    }
    struct stat info {};
    if (::fstat(file_.get(), &info) != 0) fail(std::strerror(errno));
    if (!S_ISREG(info.st_mode)) fail(part + " is not a regular file");
    if (!is_named()) continue;  // the other one has put it in its place
    if (info.st_size == 0) return;
    move_away();
  }
  fail(part + " changes all the time");
}

/// Whether the open file is the one that has the name.
bool GrowingFile::is_named() const {
  struct stat open {
  }, named{};
  return ::fstat(file_.get(), &open) == 0 &&
         ::fstatat(folder_.get(), (name_ + ".part").c_str(), &named, AT_SYMLINK_NOFOLLOW) == 0 &&
         is_same_file(open, named);
}

void GrowingFile::move_away() {
  const std::string part = name_ + ".part";
  for (int n = 1; n < 10000; ++n) {
    const std::string free = part + "." + std::to_string(n);
    if (::faccessat(folder_.get(), free.c_str(), F_OK, AT_SYMLINK_NOFOLLOW) == 0) continue;
    if (::renameat(folder_.get(), part.c_str(), folder_.get(), free.c_str()) != 0)
      fail(std::strerror(errno));
    moved_ = path_ + ".part." + std::to_string(n);
    return;
  }
  fail(part + ".1 to .9999 are taken, expected room for what " + part + " holds");
}

void GrowingFile::append(std::string_view bytes, std::uint64_t room) {
  if (const int error = sync_error_.load(std::memory_order_relaxed); error != 0)
    fail(std::strerror(error));
  struct stat info {};
  if (::fstat(file_.get(), &info) == 0 && info.st_nlink == 0) fail("it or its folder was deleted");
  const auto at = static_cast<off_t>(size());
  // Set aside before anything is written; a file system that cannot do it is asked nevertheless by
  // writing.
  const auto wanted = static_cast<off_t>(bytes.size() + room);
  if (::fallocate(file_.get(), FALLOC_FL_KEEP_SIZE, at, wanted) != 0 &&
      (errno == ENOSPC || errno == EDQUOT)) {
    fail(std::strerror(errno));
  }
  if (::lseek(file_.get(), at, SEEK_SET) != at || !write_all(file_.get(), bytes)) {
    const std::string why = std::strerror(errno);
    // Part of it may have been taken. A reader stops there as well, should this fail.
    if (::ftruncate(file_.get(), at) != 0) fail(why + ", nor cut to its whole records");
    fail(why);
  }
  size_.store(size() + bytes.size(), std::memory_order_relaxed);
}

void GrowingFile::keep() {
  stop_syncing();
  // What was set aside and not used is given back; without that it is only space.
  [[maybe_unused]] const int ignored = ::ftruncate(file_.get(), static_cast<off_t>(size()));
  if (!sync_file(file_.get())) fail(std::strerror(errno));
  if (!is_named()) fail("it or its folder was deleted");
  if (::renameat(folder_.get(), (name_ + ".part").c_str(), folder_.get(), name_.c_str()) != 0)
    fail(std::strerror(errno));
  sync_folder(folder_.get());
  file_ = Descriptor();
}

void GrowingFile::discard() noexcept {
  stop_syncing();
  if (is_named()) ::unlinkat(folder_.get(), (name_ + ".part").c_str(), 0);
  file_ = Descriptor();
}

void GrowingFile::sync_now_and_then() {
  std::unique_lock lock(mutex_);
  std::uint64_t synced = 0;
  while (!wake_.wait_for(lock, std::chrono::seconds(kSyncSeconds), [this] { return is_done_; })) {
    const std::uint64_t now = size();
    if (now == synced) continue;
    lock.unlock();  // the disk may take its time
    if (::fdatasync(file_.get()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EROFS)
      sync_error_.store(errno, std::memory_order_relaxed);
    lock.lock();
    synced = now;
  }
}

void GrowingFile::stop_syncing() noexcept {
  {
    const std::lock_guard lock(mutex_);
    is_done_ = true;
  }
  wake_.notify_all();
  if (syncing_.joinable()) syncing_.join();
}

bool is_growing(const std::string& part) {
  struct stat info {};
  if (::stat(part.c_str(), &info) != 0) return false;
  // By the number of the file alone: layered file systems give devices of their own there.
  const std::string place = ":" + std::to_string(info.st_ino) + " ";
  std::ifstream locks("/proc/locks");
  for (std::string line; std::getline(locks, line);) {
    if (line.find(" FLOCK ") != std::string::npos && line.find(place) != std::string::npos)
      return true;
  }
  return false;
}

}  // namespace thigma
