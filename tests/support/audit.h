#pragma once
// Counts what a real-time thread must not do: allocate, free, lock, call the system. For test
// programs that are linked with support/audit.cpp, which interposes the C library's functions, and
// with nothing that needs its own.

#include <cstdint>

namespace thigma::test {

/// What the calling thread did while watched.
struct AuditCounts {
  std::int64_t allocations = 0;
  std::int64_t frees = 0;
  std::int64_t locks = 0;         // mutex, read-write lock, condition variable; contended or not
  std::int64_t system_calls = 0;  // but for clock_gettime
  int last_system_call = -1;
  std::int64_t total() const { return allocations + frees + locks + system_calls; }
};

/// Null, or why this build cannot audit (a sanitizer interposes the same functions).
const char* why_no_audit();

/// From now on the calling thread's system calls are seen: they fail with ENOSYS and are counted.
/// For the rest of the thread's life; call in a thread of the test's own. Returns false where the
/// kernel refuses (no seccomp).
bool forbid_system_calls();

/// While it lives, the calling thread is watched. Not nested.
class AuditScope {
 public:
  AuditScope();
  ~AuditScope();
  AuditScope(const AuditScope&) = delete;
  AuditScope& operator=(const AuditScope&) = delete;
  AuditCounts counts() const;
};

}  // namespace thigma::test
