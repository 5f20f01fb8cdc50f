#include "support/faulty_disk.h"

#include <atomic>
#include <csignal>
#include <mutex>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

namespace thigma::test {
namespace {

std::atomic<bool> is_on{false};
std::atomic<int> wall_calls{0};
std::mutex mutex;
DiskFault fault;
int count = 0;
std::vector<std::string> names;

enum class Verdict { goes_on, fails, dies };

Verdict judge(const char* name) {
  if (!is_on.load()) return Verdict::goes_on;
  const std::lock_guard lock(mutex);
  const int n = count++;
  names.emplace_back(name);
  if (n == fault.dies_at) return Verdict::dies;
  return n >= fault.fails_from && n < fault.fails_to && fault.fails_from >= 0 ? Verdict::fails
                                                                              : Verdict::goes_on;
}

bool is_beyond(std::int64_t end) {
  return is_on.load() && fault.capacity >= 0 && end > fault.capacity;
}

/// True: refused, with errno.
bool refuses(const char* name) {
  const Verdict verdict = judge(name);
  if (verdict == Verdict::dies) ::kill(::getpid(), SIGKILL);
  if (verdict == Verdict::fails) errno = fault.error;
  return verdict != Verdict::goes_on;
}

}  // namespace

std::vector<std::string> with_disk(const DiskFault& wanted, const std::function<void()>& work) {
  fault = wanted;
  count = 0;
  names.clear();
  wall_calls = 0;
  is_on = true;
  try {
    work();
  } catch (...) {
    is_on = false;
    throw;
  }
  is_on = false;
  return names;
}

bool survives(const DiskFault& wanted, const std::function<void()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    with_disk(wanted, work);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

int wall_clock_calls() { return wall_calls; }

}  // namespace thigma::test

using thigma::test::Verdict;

extern "C" {

ssize_t write(int fd, const void* bytes, size_t size) {
  const Verdict verdict = fd <= 2 ? Verdict::goes_on : thigma::test::judge("write");
  if (verdict == Verdict::fails) {
    errno = thigma::test::fault.error;
    return -1;
  }
  if (verdict == Verdict::dies) {
    syscall(SYS_write, fd, bytes, size / 2);
    ::kill(::getpid(), SIGKILL);
  }
  const off_t at = fd <= 2 ? 0 : ::lseek(fd, 0, SEEK_CUR);
  if (fd > 2 && thigma::test::is_beyond(at + static_cast<off_t>(size))) {
    if (at >= thigma::test::fault.capacity) {
      errno = ENOSPC;
      return -1;
    }
    size = static_cast<size_t>(thigma::test::fault.capacity - at);  // a part of it, as disks do
  }
  return syscall(SYS_write, fd, bytes, size);
}

int fsync(int fd) {
  return thigma::test::refuses("fsync") ? -1 : static_cast<int>(syscall(SYS_fsync, fd));
}

int fdatasync(int fd) {
  return thigma::test::refuses("fdatasync") ? -1 : static_cast<int>(syscall(SYS_fdatasync, fd));
}

int ftruncate(int fd, off_t size) noexcept {
  return thigma::test::refuses("ftruncate") ? -1
                                            : static_cast<int>(syscall(SYS_ftruncate, fd, size));
}

int fallocate(int fd, int mode, off_t at, off_t size) {
  if (thigma::test::refuses("fallocate")) return -1;
  if (thigma::test::is_beyond(at + size)) {
    errno = ENOSPC;
    return -1;
  }
  return static_cast<int>(syscall(SYS_fallocate, fd, mode, at, size));
}

int rename(const char* from, const char* to) noexcept {
  return thigma::test::refuses("rename")
             ? -1
             : static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) noexcept {
  return thigma::test::refuses("rename")
             ? -1
             : static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, 0));
}

int clock_gettime(clockid_t clock, struct timespec* time) noexcept {
  const long done = syscall(SYS_clock_gettime, clock, time);
  if (clock == CLOCK_REALTIME && thigma::test::is_on.load())
    time->tv_sec -= 3600 * ++thigma::test::wall_calls;
  return static_cast<int>(done);
}

int gettimeofday(struct timeval* __restrict time, void* __restrict) noexcept {
  struct timespec now {};
  clock_gettime(CLOCK_REALTIME, &now);
  time->tv_sec = now.tv_sec;
  time->tv_usec = now.tv_nsec / 1000;
  return 0;
}

time_t time(time_t* out) noexcept {
  struct timespec now {};
  clock_gettime(CLOCK_REALTIME, &now);
  if (out != nullptr) *out = now.tv_sec;
  return now.tv_sec;
}

}  // extern "C"
