#pragma once
// A disk that fails, fills up or loses its power at a chosen call. Interposes the calls of libc, so
// whatever links faulty_disk.cpp is a program of its own.

#include <cerrno>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace thigma::test {

/// What happens to calls that change a disk, counted from 0, while it is in force.
struct DiskFault {
  int dies_at = -1;     // the process is killed in the middle of this call
  int fails_from = -1;  // this call and, until fails_to, those after it are refused
  int fails_to = 1 << 30;
  int error = ENOSPC;          // how
  std::int64_t capacity = -1;  // nothing beyond this byte of a file is taken; -1: no such limit
};

/// Runs `work` with a fault in force; returns the names of the calls it made, in order.
std::vector<std::string> with_disk(const DiskFault& fault, const std::function<void()>& work);

/// The same in a process of its own. returns  whether it came to its end
bool survives(const DiskFault& fault, const std::function<void()>& work);

/// How often the clock on the wall was asked while a fault was in force; it goes back an hour each
/// time.
int wall_clock_calls();

}  // namespace thigma::test
